import os
from pathlib import Path

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from tests.conftest import CORPUS, needs_corpus
from tests.mesh import made
from urdfkit.mesh.io import sniff as module
from urdfkit.mesh.io.facts import BY_SUFFIX, DefectKind, MeshFacts
from urdfkit.mesh.io.sniff import sniff, sniff_file

SUFFIXES = [*BY_SUFFIX, ".txt", ""]


def judged(data: bytes, suffix: str = ".stl") -> tuple[DefectKind | None, str]:
    facts = sniff(data, suffix)
    assert facts.size == len(data)
    return (facts.defect.kind, facts.defect.reason) if facts.defect else (None, "")


@pytest.mark.parametrize(("form", "suffix"), made.SOUND)
def test_a_sound_mesh_of_each_format(form: str, suffix: str) -> None:
    data = made.SOUND[form, suffix]
    axis = "Z_UP" if form == "COLLADA" else ""
    for promised in SUFFIXES:  # the content alone decides
        assert sniff(data, promised) == MeshFacts(form, len(data), up_axis=axis)


@pytest.mark.parametrize(
    ("data", "form"),
    [
        (b"ISO-10303-21;\nHEADER;\n", "STEP"),
        (b" " * 72 + b"S      1\n" + b" " * 72 + b"G      1\n", "IGES"),
        (b"Kaydara FBX Binary  \0\x1a\0", "FBX"),
        (b"; FBX 7.3.0 project file\n", "FBX"),
        (b"BLENDER-v279RENDH", "Blender"),
        (b"MM\x0a\0\0\0abcd", "3DS"),
        (b"#VRML V2.0 utf8\n", "VRML"),
        (b"#Inventor V2.1 ascii\n", "Open Inventor"),
        (b"<?xml version='1.0'?><!DOCTYPE X3D><X3D></X3D>", "X3D"),
        (b"<amf unit='meter'></amf>", "AMF"),
        (b"#usda 1.0\n", "USD"),
        (b"PXR-USDC\0", "USD"),
        (b"PK\x03\x04......3D/3dmodel.model", "3MF"),
        (b"PK\x03\x04......robot.usdc", "USD"),
        (b"OFF\n8 6 0\n", "OFF"),
    ],
)
def test_other_formats_are_recognised_and_left_alone(data: bytes, form: str) -> None:
    for suffix in SUFFIXES:
        assert sniff(data, suffix) == MeshFacts(form, len(data))


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        (b"", "is empty"),
        (b" \n\t\r\n", "contains only white space"),
    ],
)
def test_empty_files(data: bytes, reason: str) -> None:
    for suffix in SUFFIXES:
        assert judged(data, suffix) == (DefectKind.EMPTY, reason)


LFS = b"version https://git-lfs.github.com/spec/v1\noid sha256:0123\nsize 4048584\n"


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        (b"<!DOCTYPE html>\n<html><body/></html>", "is a web page"),
        (
            b"\xef\xbb\xbf\n<!-- x --><HTML><head><Title>\n Not\n found </title>",
            "is a web page: 'Not found'",
        ),
        (
            b"<html><title>" + b"ab " * 30,
            "is a web page: 'ab ab ab ab ab ab ab ab ab ab ab ab ab a...'",
        ),
        (LFS, "is a Git LFS pointer: the mesh of 4048584 bytes itself has not been fetched"),
        (LFS[:60], "is a Git LFS pointer: the mesh itself has not been fetched"),
        (b"\x89PNG\r\n\x1a\n", "is a PNG image"),
        (b"\xff\xd8\xff\xe0\0\x10JFIF", "is a JPEG image"),
        (b"%PDF-1.7\n", "is a PDF document"),
        (b"\x1f\x8b\x08\0", "is a gzip archive"),
        (b"<?xml version='1.0'?>\n<robot name='a'/>", "is XML with the root element <robot>"),
        (b"<Error><Code>AccessDenied</Code></Error>", "is XML with the root element <Error>"),
        (b"404: Not Found", "is text, not in a mesh format: '404: Not Found'"),
        (b'{"message": "Not Found"}', "is JSON, but not glTF"),
    ],
)
def test_files_that_are_no_meshes(data: bytes, reason: str) -> None:
    for suffix in SUFFIXES:
        assert judged(data, suffix) == (DefectKind.NOT_A_MESH, reason)


def test_a_zip_archive_that_is_no_mesh() -> None:
    assert judged(b"PK\x03\x04" + b"\0" * 40) == (DefectKind.NOT_A_MESH, "is a zip archive")


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        (b"<<<<<<< HEAD\nsolid a\n=======\n", "contains the markers of a merge conflict"),
        (b"\x01" * 90, "is not in a known mesh format (begins with 01 01 01 01 01 01 01 01)"),
        (b"\x01\0\xff", "is not in a known mesh format (begins with 01 00 ff)"),
        (b"\x01\0" * 9, "is not in a known mesh format (begins with 01 00 01 00 01 00 01 00)"),
    ],
)
def test_unreadable_files(data: bytes, reason: str) -> None:
    assert judged(data, ".dae") == (DefectKind.UNREADABLE, reason)


def test_files(tmp_path: Path) -> None:
    path = tmp_path / "part.STL"
    path.write_bytes(made.binary_stl()[:-1])
    assert sniff_file(str(path)) == sniff(made.binary_stl()[:-1], ".STL")
    for name, reason in (
        (str(tmp_path), "is not a regular file"),
        (os.devnull, "is not a regular file"),
        (str(tmp_path / "none.stl"), "file not found"),
        ("a\0b", "cannot be read: its name contains a NUL"),
    ):
        defect = sniff_file(name).defect
        assert defect is not None
        assert (defect.kind, defect.reason) == (DefectKind.UNREADABLE, reason)


def test_a_pipe_does_not_stop_the_program(tmp_path: Path) -> None:
    if not hasattr(os, "mkfifo"):
        pytest.skip("needs named pipes")
    os.mkfifo(tmp_path / "pipe.stl")
    facts = sniff_file(str(tmp_path / "pipe.stl"))
    assert facts.defect is not None
    assert facts.defect.reason == "is not a regular file"


def test_very_large_files_are_only_recognised(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "MAX_BYTES", 100)
    path = tmp_path / "part.stl"
    data = made.binary_stl([((float("nan"), 0, 0), (1, 0, 0), (0, 1, 0))] * 100)
    path.write_bytes(data)
    assert sniff_file(str(path)) == MeshFacts("binary STL", len(data))
    path.write_bytes(data[:-1])
    assert sniff_file(str(path)) == MeshFacts("", len(data) - 1)


@given(st.binary(max_size=300), st.sampled_from(SUFFIXES))
@example(b"\xff\xfe<\0", ".dae")
@example(b"ply\nformat ascii 1.0\nelement face 1\nproperty list float int x\nend_header\n", ".ply")
def test_any_bytes_are_judged(data: bytes, suffix: str) -> None:
    facts = sniff(data, suffix)
    assert facts.size == len(data)
    assert facts.defect or facts.format


@given(st.sampled_from(sorted(made.SOUND)), st.data())
def test_any_damage_is_judged(which: tuple[str, str], data: st.DataObject) -> None:
    sound = made.SOUND[which]
    at = data.draw(st.integers(0, len(sound) - 1))
    length = data.draw(st.integers(0, 8))
    piece = data.draw(st.binary(max_size=12))
    facts = sniff(sound[:at] + piece + sound[at + length :], which[1])
    assert facts.defect or facts.format


def still_whole(form: str, data: bytes, cut: int) -> bool:
    """True where the rest of a mesh that is cut off is a mesh that nothing tells from a whole."""
    rest = data[cut:]
    if form == "OBJ":  # nothing says how many faces there should be
        return data[:cut].count(b"\nf ") > 0
    if form == "ASCII STL":
        return b"endsolid" in data[:cut]
    return not rest.strip()


@pytest.mark.parametrize(("form", "suffix"), made.SOUND)
def test_a_mesh_cut_off_anywhere_is_reported(form: str, suffix: str) -> None:
    data = made.SOUND[form, suffix]
    for cut in range(len(data)):
        facts = sniff(data[:cut], suffix)
        assert facts.defect or still_whole(form, data, cut), data[:cut]


@pytest.mark.parametrize("order", ["<", ">"])
def test_a_binary_ply_cut_off_anywhere_is_reported(order: str) -> None:
    data = made.binary_ply(order)
    assert sniff(data, ".ply") == MeshFacts("PLY", len(data))
    for cut in range(len(data)):
        assert sniff(data[:cut], ".ply").defect, data[:cut]


@needs_corpus
def test_the_meshes_of_real_robots_are_in_order() -> None:
    meshes = [path for path in CORPUS.rglob("*") if path.suffix.lower() in BY_SUFFIX]
    assert len(meshes) > 100
    facts = {str(path): sniff_file(str(path)) for path in meshes}
    assert {path: f for path, f in facts.items() if f.defect or f.non_finite} == {}
    assert {f.format for f in facts.values()} == {"binary STL", "COLLADA"}
