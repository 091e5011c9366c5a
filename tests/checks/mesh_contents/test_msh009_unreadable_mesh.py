from pathlib import Path

import pytest

from tests.mesh import made
from tests.meshed import SOUND, link, mesh, reasons, reported
from urdfkit.mesh.samples import collada
from urdfkit.text.diagnostic import Severity

CODE = "MSH009"
COPY = "export the mesh again, or copy it from where the robot comes from"
GET = "get the file itself: the raw link of the page, or git lfs pull"
DOWNLOAD = "download or export the mesh again"
REMOVE = "export the mesh again, or remove the triangle in a mesh editor"
NAN = float("nan")


@pytest.mark.parametrize(
    ("name", "data", "reason", "help_"),
    [
        ("hokuyo.dae", b"", "is empty", COPY),
        ("a.stl", made.binary_stl([]), "contains no triangles", COPY),
        ("a.dae", b"\x01\0", "is not in a known mesh format (begins with 01 00)", COPY),
        (
            "a.obj",
            made.obj() + b"f 1 2 9\n",
            "refers to vertex 9 in line 9, but has 4 vertices",
            COPY,
        ),
        (
            "hokuyo.dae",
            b"<!DOCTYPE html><html><title>hokuyo.dae at main</title></html>",
            "is a web page: 'hokuyo.dae at main'",
            GET,
        ),
        (
            "a.stl",
            b"version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 684\n",
            "is a Git LFS pointer: the mesh of 684 bytes itself has not been fetched",
            "run git lfs pull",
        ),
        ("a.stl", b"404: Not Found", "is text, not in a mesh format: '404: Not Found'", GET),
        ("a.stl", made.binary_stl()[:-1], "declares 4 triangles and contains 3", DOWNLOAD),
        ("a.glb", made.glb()[:8], "ends after 8 bytes, inside its header", DOWNLOAD),
    ],
)
def test_defects(tmp_path: Path, name: str, data: bytes, reason: str, help_: str) -> None:
    assert reasons(tmp_path, CODE, name, data) == [(reason, help_)]


@pytest.mark.parametrize(
    ("name", "data", "where"),
    [
        (
            "a.stl",
            made.binary_stl([*made.TETRAHEDRON, ((0, 0, 0), (0, NAN, 0), (1, 0, 0))]),
            "corner 2 of triangle 5 is (0, nan, 0)",
        ),
        (
            "a.stl",
            made.ascii_stl().replace(b"vertex 0 1 0", b"vertex 0 inf 0", 1),
            "the vertex in line 5 is (0, inf, 0)",
        ),
    ],
)
def test_vertices_that_are_not_finite(tmp_path: Path, name: str, data: bytes, where: str) -> None:
    (found, *others) = reported(tmp_path, CODE, link(mesh(name)), {name: data})
    assert found.severity is Severity.ERROR
    assert found.message.endswith(f"has a vertex that is not finite: {where}")
    assert found.help == REMOVE
    assert all(one.severity is Severity.WARNING for one in others)


def test_triangles_of_a_ply_file_that_are_not_finite(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, CODE, link(mesh("a.ply")), {"a.ply": made.ascii_ply("nan 0 0")})
    assert "1 triangle with a coordinate that is not finite" in found.message


@pytest.mark.parametrize(("form", "suffix"), made.SOUND)
def test_sound_files(tmp_path: Path, form: str, suffix: str) -> None:
    name = f"a{suffix}"
    found = reported(tmp_path, CODE, link(mesh(name)), {name: made.SOUND[form, suffix]})
    assert [one for one in found if one.severity is Severity.ERROR] == []


def test_a_missing_file_is_not_empty(tmp_path: Path) -> None:
    assert reported(tmp_path, CODE, link(mesh("none.stl")), {}) == []


class TestPartlyBroken:
    @pytest.fixture(autouse=True)
    def _measured(self) -> None:
        for library in ("numpy", "lxml", "manifold3d"):
            pytest.importorskip(library)

    def test_a_bad_colour(self, tmp_path: Path) -> None:
        bad = collada(effect="<diffuse><color>0.01.0 0 1</color></diffuse>")
        robot = link(mesh("a.dae", "visual"), mesh("b.stl"))
        (found,) = reported(tmp_path, CODE, robot, {"a.dae": bad, "b.stl": SOUND})
        assert found.severity is Severity.WARNING
        assert "'a.dae' is partly broken: 1 colour" in found.message

    def test_nothing_is_left(self, tmp_path: Path) -> None:
        bad = collada().replace(b"<p>0 1 2</p>", b"<p>0 1 7</p>")
        (found,) = reported(tmp_path, CODE, link(mesh("a.dae")), {"a.dae": bad})
        assert found.severity is Severity.WARNING
        assert "'a.dae' contains no triangles" in found.message

    @pytest.mark.parametrize(("role", "number"), [("visual", 1), ("collision", 0)])
    def test_the_appearance_of_a_collision(self, tmp_path: Path, role: str, number: int) -> None:
        bad = collada(effect="<diffuse><color>0.01.0 0 1</color></diffuse>")
        found = reported(tmp_path, CODE, link(mesh("a.dae", role)), {"a.dae": bad})
        assert len(found) == number
