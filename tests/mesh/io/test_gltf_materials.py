"""glTF: colours, textures, and the normals and coordinates that go with them."""

import json
from pathlib import Path

import pytest

pytest.importorskip("numpy")

import numpy as np

from tests.mesh import made
from tests.mesh.gltfs import CORNERS, PIXEL, Content, floats, uri
from urdfkit.mesh.geometry import MeshMaterial, MeshPart
from urdfkit.mesh.io.load import load_bytes


def with_looks() -> Content:
    """Coordinates of a texture as bytes, normals as bytes, colours as 16 bits."""
    content = floats()
    uv = np.array([(0, 0), (255, 0), (0, 255), (255, 255)], "u1")
    normals = np.array([(0, 0, -127, 0), (127, 0, 0, 0), (0, 127, 0, 0), (0, 0, 127, 0)], "i1")
    colors = np.array([(65535, 0, 0, 32768)] * 4, "<u2")
    lists = (
        ("TEXCOORD_0", uv, 5121, 2),
        ("NORMAL", normals, 5120, 3),
        ("COLOR_0", colors, 5123, 4),
    )
    for name, table, component, width in lists:
        data = table.tobytes()
        content["meshes"][0]["primitives"][0]["attributes"][name] = len(content["accessors"])
        content["accessors"].append(
            {
                "bufferView": len(content["bufferViews"]),
                "componentType": component,
                "normalized": True,
                "count": 4,
                "type": f"VEC{width}",
            }
        )
        content["bufferViews"].append(
            {
                "buffer": len(content["buffers"]),
                "byteLength": len(data),
                "byteStride": table.itemsize * table.shape[1],
            }
        )
        content["buffers"].append({"uri": uri(data), "byteLength": len(data)})
    content["meshes"][0]["primitives"][0]["material"] = 0
    content["materials"] = [
        {
            "name": "paint",
            "alphaMode": "BLEND",
            "pbrMetallicRoughness": {
                "baseColorFactor": [0.5, 0.25, 1, 0.75],
                "baseColorTexture": {"index": 0},
            },
        }
    ]
    content["textures"] = [{"source": 0}]
    content["images"] = [{"uri": uri(PIXEL), "mimeType": "image/png"}]
    return content


def looks(content: Content, path: str = "a.gltf") -> MeshPart:
    (part,) = load_bytes(json.dumps(content).encode(), path).parts
    return part


def test_looks() -> None:
    part = looks(with_looks())
    assert part.material == MeshMaterial("paint", (0.5, 0.25, 1, 0.75), PIXEL)
    # Corners may be in another order than in the file.
    order = [int(np.flatnonzero((part.vertices == corner).all(axis=1))[0]) for corner in CORNERS]
    assert part.uv is not None
    assert part.normals is not None
    assert part.colors is not None
    assert part.uv[order].tolist() == [[0, 1], [1, 1], [0, 0], [1, 0]]
    assert part.normals[order].tolist() == [[0, 0, -1], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    assert part.colors[order][0] == pytest.approx([1, 0, 0, 0.5], abs=1e-4)


def test_an_opaque_material_is_opaque_whatever_its_alpha() -> None:
    content = with_looks()
    del content["materials"][0]["alphaMode"]
    material = looks(content).material
    assert material is not None
    assert material.rgba == (0.5, 0.25, 1, 1)


def test_a_texture_that_is_scaled_turned_and_moved() -> None:
    """KHR_texture_transform, as gltfpack writes it with quantised coordinates."""
    content = with_looks()
    texture = content["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]
    texture["extensions"] = {
        "KHR_texture_transform": {"offset": [0.5, 0.25], "rotation": np.pi / 2, "scale": [2, 4]}
    }
    part = looks(content)
    corner = part.vertices.tolist().index([2, 0, 0])
    assert part.uv is not None
    # (1, 0) is scaled to (2, 0); a quarter anticlockwise, where v goes down, is (0, -2).
    assert part.uv[corner] == pytest.approx([0.5, 1 - (0.25 - 2)])


def test_an_older_material() -> None:
    content = with_looks()
    del content["materials"][0]["pbrMetallicRoughness"]
    content["materials"][0]["extensions"] = {
        "KHR_materials_pbrSpecularGlossiness": {"diffuseFactor": [0, 1, 0, 1]}
    }
    assert looks(content).material == MeshMaterial("paint", (0, 1, 0, 1))


def test_an_image_in_a_file(tmp_path: Path) -> None:
    content = with_looks()
    content["images"] = [{"uri": "a%20skin.png"}]
    path, data = str(tmp_path / "a.gltf"), json.dumps(content).encode()
    mesh = load_bytes(data, path)
    assert (mesh.textures, mesh.missing) == (("a%20skin.png",), ("a%20skin.png",))
    image = tmp_path / "a skin.png"
    image.write_bytes(PIXEL)
    mesh = load_bytes(data, path)
    assert (mesh.textures, mesh.missing, mesh.files) == (("a%20skin.png",), (), (str(image),))
    assert mesh.parts[0].material is not None
    assert mesh.parts[0].material.texture == str(image)


def test_an_image_in_the_binary_chunk() -> None:
    content = with_looks()
    content["images"] = [{"bufferView": len(content["bufferViews"]), "mimeType": "image/png"}]
    content["bufferViews"].append({"buffer": len(content["buffers"]), "byteLength": len(PIXEL)})
    content["buffers"].append({"byteLength": len(PIXEL)})
    (part,) = load_bytes(made.glb(json.dumps(content).encode(), PIXEL), "a.glb").parts
    assert part.material is not None
    assert part.material.texture == PIXEL
