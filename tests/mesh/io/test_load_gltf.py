"""glTF: every way to write triangles, and every way to get them wrong."""

import json
import re
import struct
import subprocess
import sys
from collections.abc import Callable
from io import BytesIO
from pathlib import Path

import pytest

pytest.importorskip("numpy")
trimesh = pytest.importorskip("trimesh")

import numpy as np

from tests.mesh import made
from tests.mesh.gltfs import CORNERS, Content, floats, tetrahedron, uri, volume_and_middle
from tests.mesh.made import whole_gltf
from urdfkit.mesh.io import load_gltf
from urdfkit.mesh.io.load import UnloadableMesh, load_bytes


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


def by_assimp(content: Content, directory: Path) -> float:
    """The signed volume of what assimp reads, which places each mesh by its nodes."""
    assimp = Path(sys.executable).with_name("assimp")  # Pinocchio brings it along
    if not assimp.exists():
        pytest.skip("needs assimp")
    source, target = directory / "by_assimp.gltf", directory / "by_assimp.stl"
    source.write_text(json.dumps(content))
    subprocess.run([assimp, "export", source, target, "-fstlb"], check=True, capture_output=True)
    return float(trimesh.load_mesh(target).volume)


def sparse() -> Content:
    """The last corner is changed by a sparse list, from one that is nearer."""
    places = CORNERS.astype("<f4")
    places[3] = (0, 0, 1)
    content = tetrahedron(places.tobytes(), 5126)
    changes = np.array([3, 0], "<u2").tobytes() + np.array([0, 0, 5], "<f4").tobytes()
    content["buffers"].append({"uri": uri(changes), "byteLength": len(changes)})
    content["bufferViews"].append({"buffer": 1, "byteLength": len(changes)})
    content["accessors"][0]["sparse"] = {
        "count": 1,
        "indices": {"bufferView": 2, "componentType": 5123},
        "values": {"bufferView": 2, "byteOffset": 4},
    }
    return content


def zeros_and_changes() -> Content:
    """All corners but the one in the origin come from a sparse list over no list at all."""
    content = sparse()
    changes = np.array([1, 2, 3, 0], "<u2").tobytes() + CORNERS[1:].astype("<f4").tobytes()
    content["buffers"][1] = {"uri": uri(changes), "byteLength": len(changes)}
    content["bufferViews"][2]["byteLength"] = len(changes)
    del content["accessors"][0]["bufferView"]
    content["accessors"][0]["sparse"]["count"] = 3
    content["accessors"][0]["sparse"]["values"]["byteOffset"] = 8
    return content


def normalised() -> Content:
    """KHR_mesh_quantization: fractions of 32767, made larger by the node."""
    rows = np.zeros((4, 4), dtype="<i2")
    rows[:, :3] = np.round(CORNERS / 5 * 32767)
    content = tetrahedron(rows.tobytes(), 5122, normalized=True)
    content["bufferViews"][0]["byteStride"] = 8
    content["extensionsRequired"] = ["KHR_mesh_quantization"]
    content["nodes"] = [{"mesh": 0, "scale": [5, 5, 5]}]
    return content


def surfaces(mode: int, *runs: tuple[int, ...]) -> Content:
    """The tetrahedron in strips or fans."""
    content = floats()
    data = b"".join(np.array(run, "<u2").tobytes() for run in runs)
    content["buffers"].append({"uri": uri(data), "byteLength": len(data)})
    content["bufferViews"].append({"buffer": 1, "byteLength": len(data)})
    content["accessors"].pop()
    primitives, start = [], 0
    for number, run in enumerate(runs, start=1):
        content["accessors"].append(
            {
                "bufferView": 2,
                "byteOffset": start,
                "componentType": 5123,
                "count": len(run),
                "type": "SCALAR",
            }
        )
        primitives.append({"attributes": {"POSITION": 0}, "indices": number, "mode": mode})
        start += 2 * len(run)
    content["meshes"][0]["primitives"] = primitives
    return content


def strip() -> Content:
    return surfaces(5, (0, 2, 1, 3, 0, 2))


def joined_strips() -> Content:
    """Two strips in one, by triangles without area."""
    return surfaces(5, (0, 2, 1, 3, 3, 1, 1, 3, 0, 2))


def fans() -> Content:
    return surfaces(6, (0, 2, 1, 3, 2), (1, 2, 3))


def turned_nodes() -> Content:
    """By a quaternion, a matrix and a scale, one in the other."""
    content = floats()
    content["nodes"] = [
        {"children": [1], "rotation": [0.5, 0.5, 0.5, 0.5], "translation": [0, 0, 9]},
        {"children": [2], "matrix": [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 3, 4, 5, 1]},
        {"mesh": 0, "scale": [1, 2, 3]},
    ]
    return content


@pytest.mark.parametrize(
    ("make", "size"),
    [
        (floats, 5),
        (sparse, 5),
        (zeros_and_changes, 5),
        (normalised, 5),
        (strip, 5),
        (joined_strips, 5),
        (fans, 5),
        (turned_nodes, 30),
    ],
)
def test_every_way_to_write_a_tetrahedron(
    make: Callable[[], Content], size: float, tmp_path: Path
) -> None:
    content = make()
    mesh = load_bytes(json.dumps(content).encode(), "a.gltf")
    assert len(mesh.faces) == 4
    assert volume_and_middle(content)[0] == pytest.approx(size, rel=1e-4)
    if make is not normalised:  # of which assimp makes nothing
        assert by_assimp(content, tmp_path) == pytest.approx(size, rel=1e-4)
    as_glb = made.glb(json.dumps(content).encode())
    assert np.array_equal(load_bytes(as_glb, "a.glb").vertices, mesh.vertices)


def test_turned_nodes_are_where_trimesh_has_them() -> None:
    content = json.dumps(turned_nodes()).encode()
    expected = trimesh.load_scene(BytesIO(content), file_type="gltf").bounds
    mesh = load_bytes(content, "a.gltf")
    found = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    assert np.asarray(found) == pytest.approx(expected)


def test_what_is_no_triangle_is_reported() -> None:
    content = floats()
    lines = {"attributes": {"POSITION": 0}, "mode": 1}
    content["meshes"][0]["primitives"].append(lines)
    content["nodes"].append({"camera": 0})
    content["animations"] = [{}]
    mesh = load_bytes(json.dumps(content).encode(), "a.gltf")
    assert mesh.extras == ("1 line or point set", "1 camera", "1 animation")
    content["meshes"][0]["primitives"] = [lines]
    with pytest.raises(UnloadableMesh, match="contains no triangles"):
        load_bytes(json.dumps(content).encode(), "a.gltf")


def test_nodes_of_no_scene_are_shown_if_there_is_no_scene() -> None:
    content = floats()
    del content["scenes"], content["scene"]
    content["nodes"] = [{"mesh": 0}, {"children": [0], "translation": [0, 0, 1]}]
    assert volume_and_middle(content)[1] == [1, 1.5, 3.5]


def draco(content: Content) -> None:
    content["extensionsRequired"] = ["KHR_draco_mesh_compression"]


def meshopt(content: Content) -> None:
    content["extensionsRequired"] = ["EXT_meshopt_compression"]


def endless(content: Content) -> None:
    content["accessors"][0]["count"] = 10**9


def only_zeros(content: Content) -> None:
    del content["accessors"][0]["bufferView"]


def short_buffer(content: Content) -> None:
    content["buffers"][0]["uri"] = uri(b"1234")


def no_base64(content: Content) -> None:
    content["buffers"][0]["uri"] = "data:;base64,AAAAA"


def matrices(content: Content) -> None:
    content["accessors"][0]["type"] = "MAT4"


def doubles(content: Content) -> None:
    content["accessors"][0]["componentType"] = 5130


def indices_of_floats(content: Content) -> None:
    content["accessors"][1] = content["accessors"][0]


def flat_positions(content: Content) -> None:
    content["accessors"][0]["type"] = "VEC2"


def no_such_list(content: Content) -> None:
    content["meshes"][0]["primitives"][0]["indices"] = 7


def no_object(content: Content) -> None:
    content["accessors"][0] = "positions"


def no_list(content: Content) -> None:
    content["nodes"] = {"mesh": 0}


def no_vector(content: Content) -> None:
    content["nodes"][0]["translation"] = [0, 0, "far"]


def not_a_number(content: Content) -> None:
    content["nodes"][0]["translation"] = [0, 0, float("nan")]


def unknown_mode(content: Content) -> None:
    content["meshes"][0]["primitives"][0]["mode"] = 7


def overlapping_rows(content: Content) -> None:
    content["bufferViews"][0]["byteStride"] = 4


def row_that_is_not_there(content: Content) -> None:
    content |= sparse()
    content["accessors"][0]["count"] = 3


@pytest.mark.parametrize(
    ("spoil", "reason"),
    [
        (draco, "uses unsupported compression: Draco"),
        (meshopt, "uses unsupported compression: meshopt"),
        (endless, "is not valid glTF"),
        (only_zeros, "declares 4 rows of numbers and contains none"),
        (short_buffer, "lacks 44 bytes of bufferViews[0]"),
        (no_base64, "contains invalid base64"),
        (matrices, "is not valid glTF"),
        (doubles, "is not valid glTF"),
        (indices_of_floats, "is not valid glTF: indices are fractions"),
        (flat_positions, "is not valid glTF: positions are not three numbers"),
        (no_such_list, "is not valid glTF"),
        (no_object, "is not valid glTF"),
        (no_list, "is not valid glTF"),
        (no_vector, "is not valid glTF"),
        (not_a_number, "NaN is not a JSON number"),
        (unknown_mode, "is not valid glTF: unknown mode 7"),
        (overlapping_rows, "is not valid glTF: rows of numbers overlap"),
        (row_that_is_not_there, "is not valid glTF"),
    ],
)
def test_why_a_file_cannot_be_read(spoil: Callable[[Content], None], reason: str) -> None:
    content = floats()
    spoil(content)
    with pytest.raises(UnloadableMesh, match=re.escape(reason)):
        load_bytes(json.dumps(content).encode(), "a.gltf")


def test_nodes_that_hold_one_another() -> None:
    content = floats()
    content["nodes"] = [{"mesh": 0, "children": [1, 1]}, {"children": [0]}]
    mesh = load_bytes(json.dumps(content).encode(), "a.gltf")
    assert len(mesh.faces) == 4
    assert mesh.losses == ("2 nodes with two parents",)


def test_a_mesh_that_is_shown_without_end() -> None:
    content = floats()
    content["nodes"] = [{"mesh": 0}] * 20_001
    content["scenes"] = [{"nodes": [*range(20_001)]}]
    with pytest.raises(UnloadableMesh, match="has more than 20000 nodes"):
        load_bytes(json.dumps(content).encode(), "a.gltf")


def test_one_list_that_is_shown_over_and_over(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(load_gltf, "MAX_TRIANGLES", 100)
    surfaces, nodes = floats(), floats()
    surfaces["meshes"][0]["primitives"] *= 26
    nodes["nodes"] *= 26
    nodes["scenes"][0]["nodes"] = [*range(26)]
    for content in (surfaces, nodes):
        with pytest.raises(UnloadableMesh, match="has more than 100 triangles"):
            load_bytes(json.dumps(content).encode(), "a.gltf")


def test_numbers_in_a_file_beside_it(tmp_path: Path) -> None:
    content = json.loads(whole_gltf())
    content["buffers"][0]["uri"] = "numbers.bin"
    data = json.dumps(content).encode()
    with pytest.raises(UnloadableMesh, match=r"numbers\.bin"):
        load_bytes(data, str(tmp_path / "a.gltf"))
    (tmp_path / "numbers.bin").write_bytes(struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0))
    assert len(load_bytes(data, str(tmp_path / "a.gltf")).faces) == 1
