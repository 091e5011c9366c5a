"""Broken mesh files: a reason, never a crash, and no more memory than the file deserves."""

import resource
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")
trimesh = pytest.importorskip("trimesh")

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from tests.mesh import made
from tests.mesh.made import whole_gltf
from tests.meshed import link, mesh, reported
from urdfkit.mesh import samples
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.io.load import UnloadableMesh, load, load_bytes, salvage
from urdfkit.mesh.io.sniff import sniff
from urdfkit.mesh.measuring import measure

BOX = trimesh.creation.box()

#: A small file of each format that holds triangles.
WHOLE: dict[str, bytes] = {
    "binary.stl": samples.stl(samples.box((0, 0, 0), (1, 1, 1))),
    "ascii.stl": made.ascii_stl(),
    "collada.dae": samples.collada(
        "<up_axis>Z_UP</up_axis>", "<diffuse><color>1 0 0 1</color></diffuse>"
    ),
    "obj.obj": made.obj(),
    "ascii.ply": made.ascii_ply(),
    "binary.ply": BOX.export(file_type="ply"),
    "binary.glb": BOX.export(file_type="glb"),
    "text.gltf": whole_gltf(),
}

#: Offsets that are tried of the format that trimesh reads, which takes a millisecond each.
STEP = {"binary.ply": 5}


def is_sound(mesh: Mesh) -> bool:
    """True if a mesh is what it promises to be."""
    return all(
        len(part.faces)
        and np.isfinite(part.vertices).all()
        and part.faces.min() >= 0
        and part.faces.max() < len(part.vertices)
        and (part.normals is None or np.allclose(np.linalg.norm(part.normals, axis=1), 1))
        for part in mesh.parts
    )


def outcome(data: bytes, name: str) -> str:
    """The reason why some bytes are no mesh; empty if they are one."""
    try:
        found = load_bytes(data, name)
    except UnloadableMesh as error:
        assert error.reason  # noqa: PT017
        return error.reason
    assert is_sound(found)
    assert measure(found).triangles > 0
    return ""


@pytest.mark.parametrize("name", WHOLE)
def test_the_whole_files_are_meshes(name: str) -> None:
    assert outcome(WHOLE[name], name) == ""


@pytest.mark.parametrize("name", WHOLE)
def test_cut_off_anywhere(name: str) -> None:
    data = WHOLE[name]
    taken = [end for end in range(0, len(data), STEP.get(name, 1)) if not outcome(data[:end], name)]
    # What is missing is a line end, white space, or a face that nobody misses.
    assert all(end > 0.6 * len(data) for end in taken)
    if name.startswith("binary"):
        assert taken == []


@pytest.mark.parametrize("name", WHOLE)
def test_what_is_left_of_a_cut_file(name: str, tmp_path: Path) -> None:
    data = WHOLE[name]
    path = tmp_path / name
    for end in range(0, len(data), 20):
        path.write_bytes(data[:end])
        try:
            assert is_sound(salvage(path))
        except UnloadableMesh as error:
            assert error.reason  # noqa: PT017 - either is right


@pytest.mark.parametrize("name", WHOLE)
@given(data=st.data())
def test_other_bytes_somewhere(name: str, data: Any) -> None:
    broken = bytearray(WHOLE[name])
    for _ in range(data.draw(st.integers(1, 4))):
        at = data.draw(st.integers(0, len(broken) - 1))
        broken[at : at + data.draw(st.integers(0, 3))] = data.draw(st.binary(max_size=4))
    outcome(bytes(broken), name)


@pytest.mark.parametrize("name", WHOLE)
@pytest.mark.parametrize("part", [0.3, 0.55])
def test_a_check_tells_it(name: str, part: float, tmp_path: Path) -> None:
    data = WHOLE[name][: int(part * len(WHOLE[name]))]
    found = reported(tmp_path, "MSH", link(mesh(name)), {name: data})
    assert "MSH009" in {one.code for one in found}


@pytest.mark.parametrize(
    ("name", "right", "wrong", "reason"),
    [
        ("binary.ply", b"list uchar", b"list \0uchar", "has the property"),
        ("binary.ply", b"list uchar", b"list float", "has the property"),
        ("ascii.ply", b"\n3 0 1 2", b"\n1 0 1 2", "cannot be read"),
    ],
)
def test_bytes_that_once_were_a_crash(name: str, right: bytes, wrong: bytes, reason: str) -> None:
    data = WHOLE[name]
    assert right in data
    assert outcome(data.replace(right, wrong), name).startswith(reason)


#: Files of some hundred bytes that claim to hold billions of things.
GREEDY: dict[str, bytes] = {
    "a.stl": b"\0" * 80 + b"\xff\xff\xff\xff" + b"\0" * 500,
    "a.ply": made.ascii_ply().replace(b"vertex 3", b"vertex 999999999999"),
    "b.ply": made.binary_ply().replace(b"face 1", b"face 4000000000"),
    "a.obj": b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 999999999999999999999 2 3\n",
    "a.dae": samples.collada().replace(b"<p>0 1 2</p>", b"<p>0 1 99999999999999999999</p>"),
    "b.dae": samples.collada().replace(b'stride="3"', b'stride="99999999999"'),
    "c.dae": samples.collada().replace(b'offset="0"/><p>', b'offset="999999999"/><p>'),
    "d.dae": samples.collada()
    .replace(b"<triangles", b"<polylist")
    .replace(b"</triangles", b"</polylist")
    .replace(b"<p>", b"<vcount>" + b"9007199254740991 " * 3000 + b"</vcount><p>"),
    "a.gltf": made.gltf(accessors=[{"count": 10**12, "componentType": 5126, "type": "VEC3"}]),
}


@pytest.mark.parametrize("name", GREEDY)
def test_what_a_file_claims_takes_no_memory(name: str, tmp_path: Path) -> None:
    (tmp_path / name).write_bytes(GREEDY[name])
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    for read in (load, salvage):
        try:
            assert is_sound(read(tmp_path / name))
        except UnloadableMesh as error:
            assert error.reason  # noqa: PT017 - either is right
    grow_pieces = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before  # in KiB
    assert grow_pieces < 100_000
    assert sniff(GREEDY[name], "." + name.rpartition(".")[2]).size == len(GREEDY[name])
