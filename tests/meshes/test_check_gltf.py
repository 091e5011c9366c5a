"""glTF that trimesh reads wrongly is refused; what it reads is right."""

from __future__ import annotations

import json
import struct
from base64 import b64encode
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("numpy")
pytest.importorskip("trimesh")

import numpy as np

from tests.meshes import made
from urdfkit.meshes import check_gltf
from urdfkit.meshes.load import UnloadableMesh, load_bytes
from urdfkit.meshes.samples import gltf

Content = dict[str, Any]
#: A tetrahedron with its corner in the origin.
CORNERS = np.array([(0, 0, 0), (2, 0, 0), (0, 3, 0), (0, 0, 5)])
FACES = np.array([(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)])


def uri(data: bytes) -> str:
    return f"data:application/octet-stream;base64,{b64encode(data).decode()}"


def tetrahedron(places: bytes, component: int, **accessor: object) -> Content:
    """A tetrahedron whose corners are given in some number format."""
    faces = FACES.astype("<u2").tobytes()
    places += b"\0" * (-len(places) % 4)
    return {
        "asset": {"version": "2.0"},
        "buffers": [{"uri": uri(places + faces), "byteLength": len(places + faces)}],
        "bufferViews": [
            {"buffer": 0, "byteLength": len(places)},
            {"buffer": 0, "byteOffset": len(places), "byteLength": len(faces)},
        ],
        "accessors": [
            {
                "bufferView": 0,
                "componentType": component,
                "count": 4,
                "type": "VEC3",
                "min": CORNERS.min(axis=0).tolist(),
                "max": CORNERS.max(axis=0).tolist(),
                **accessor,
            },
            {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"},
        ],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "nodes": [{"mesh": 0}],
        "scenes": [{"nodes": [0]}],
        "scene": 0,
    }


def volume_and_middle(content: Content) -> tuple[float, list[float]]:
    mesh = load_bytes(json.dumps(content).encode(), "a.gltf")
    a, b, c = (mesh.vertices[mesh.faces[:, corner]] for corner in range(3))
    middle = (mesh.vertices.min(axis=0) + mesh.vertices.max(axis=0)) / 2
    return float((a * np.cross(b, c)).sum()) / 6, middle.tolist()


def floats() -> Content:
    return tetrahedron(CORNERS.astype("<f4").tobytes(), 5126)


def test_floats() -> None:
    volume, middle = volume_and_middle(floats())
    assert volume == pytest.approx(5)
    assert middle == [1, 1.5, 2.5]


def test_whole_numbers_that_a_node_scales() -> None:
    """KHR_mesh_quantization, as gltfpack writes it; every row is padded to 4 bytes."""
    rows = np.zeros((4, 4), dtype="<u2")
    rows[:, :3] = 100 * CORNERS
    content = tetrahedron(rows.tobytes(), 5123)
    content["bufferViews"][0]["byteStride"] = 8
    content["extensionsRequired"] = ["KHR_mesh_quantization"]
    content["nodes"] = [{"mesh": 0, "scale": [0.01, 0.01, 0.01], "translation": [1, 0, 0]}]
    volume, middle = volume_and_middle(content)
    assert volume == pytest.approx(5)
    assert middle == pytest.approx([2, 1.5, 2.5])


@pytest.mark.parametrize("node", [{"scale": [-1, 1, 1]}, {"scale": [-2, -2, -2]}])
def test_a_mirrored_node_keeps_outside_outside(node: Content) -> None:
    content = floats()
    content["nodes"] = [{"mesh": 0, **node}]
    size = abs(np.prod(node["scale"]))
    assert volume_and_middle(content)[0] == pytest.approx(5 * size)


def test_a_strip() -> None:
    content = json.loads(gltf())
    square = struct.pack("<12f", 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0)
    content["buffers"] = [{"uri": uri(square), "byteLength": len(square)}]
    content["bufferViews"][0]["byteLength"] = len(square)
    content["accessors"][0]["count"] = 4
    content["meshes"][0]["primitives"][0]["mode"] = 5
    mesh = load_bytes(json.dumps(content).encode(), "a.gltf")
    a, b, c = (mesh.vertices[mesh.faces[:, corner]] for corner in range(3))
    assert (np.cross(b - a, c - a) / 2).sum(axis=0).tolist() == [0, 0, 1]


def sparse(content: Content) -> None:
    content["accessors"][0]["sparse"] = {"count": 1}


def normalised(content: Content) -> None:
    content["accessors"][0] |= {"componentType": 5123, "normalized": True}


def fan(content: Content) -> None:
    content["meshes"][0]["primitives"][0]["mode"] = 6


def draco(content: Content) -> None:
    content["extensionsRequired"] = ["KHR_draco_mesh_compression"]
    content["meshes"][0]["primitives"][0]["extensions"] = {"KHR_draco_mesh_compression": {}}


def meshopt(content: Content) -> None:
    content["extensionsUsed"] = ["EXT_meshopt_compression"]


def endless(content: Content) -> None:
    content["accessors"][0]["count"] = 10**9


@pytest.mark.parametrize(
    ("spoil", "reason"),
    [
        (sparse, "holds sparse lists, which are not read"),
        (normalised, "holds positions as normalised whole numbers, which are not read"),
        (fan, "holds triangle fans, which are not read"),
        (draco, "is compressed with Draco; to read it: pip install DracoPy"),
        (meshopt, "is compressed with meshopt, which is not read"),
        (endless, "declares a list of more than 60000000 numbers"),
    ],
)
def test_what_trimesh_would_read_wrongly_is_refused(
    spoil: Callable[[Content], None], reason: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(check_gltf, "find_spec", lambda name: None)
    content = floats()
    spoil(content)
    with pytest.raises(UnloadableMesh, match=reason):
        load_bytes(json.dumps(content).encode(), "a.gltf")
    with pytest.raises(UnloadableMesh, match=reason):
        load_bytes(made.glb(json.dumps(content).encode()), "a.glb")


def test_numbers_in_a_file_beside_it(tmp_path: Path) -> None:
    content = json.loads(gltf())
    content["buffers"][0]["uri"] = "numbers.bin"
    data = json.dumps(content).encode()
    with pytest.raises(UnloadableMesh, match=r"numbers\.bin"):
        load_bytes(data, str(tmp_path / "a.gltf"))
    (tmp_path / "numbers.bin").write_bytes(struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0))
    assert len(load_bytes(data, str(tmp_path / "a.gltf")).faces) == 1
