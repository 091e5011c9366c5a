from pathlib import Path

import pytest

from tests.mesh import made
from tests.meshed import SOUND, link, mesh, reasons, reported
from tests.naming import naming
from urdfkit.mesh.samples import collada
from urdfkit.text.diagnostic import Severity

CODE = "MSH009"
COPY = naming("export", "copy")
GET = naming("raw link")
DOWNLOAD = naming("download", "export")
REMOVE = naming("editor")
NAN = float("nan")


@pytest.mark.parametrize(
    ("name", "data", "reason", "help_"),
    [
        ("hokuyo.dae", b"", naming("empty"), COPY),
        ("a.stl", made.binary_stl([]), naming("no triangles"), COPY),
        ("a.dae", b"\x01\0", naming("known", "01 00"), COPY),
        (
            "a.obj",
            made.obj() + b"f 1 2 9\n",
            naming("9", "9", "4"),
            COPY,
        ),
        (
            "hokuyo.dae",
            b"<!DOCTYPE html><html><title>hokuyo.dae at main</title></html>",
            naming("page", "hokuyo.dae at main"),
            GET,
        ),
        (
            "a.stl",
            b"version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 684\n",
            naming("Git LFS", "684 bytes"),
            naming("git lfs pull"),
        ),
        ("a.stl", b"PK\x03\x04", naming("zip archive"), naming("unpack")),
        ("a.stl", b"404: Not Found", naming("format", "404: Not Found"), GET),
        ("a.stl", made.binary_stl()[:-1], naming("4 triangles", "3"), DOWNLOAD),
        ("a.glb", made.glb()[:8], naming("after", "8 bytes", "inside"), DOWNLOAD),
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
            "2 of triangle 5 is (0, nan, 0)",
        ),
        (
            "a.stl",
            made.ascii_stl().replace(b"vertex 0 1 0", b"vertex 0 inf 0", 1),
            "line 5 is (0, inf, 0)",
        ),
    ],
)
def test_vertices_that_are_not_finite(tmp_path: Path, name: str, data: bytes, where: str) -> None:
    (found, *others) = reported(tmp_path, CODE, link(mesh(name)), {name: data})
    assert found.severity is Severity.ERROR
    assert found.message.endswith(where)
    assert found.help == REMOVE
    assert all(one.severity is Severity.WARNING for one in others)


def test_triangles_of_a_ply_file_that_are_not_finite(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, CODE, link(mesh("a.ply")), {"a.ply": made.ascii_ply("nan 0 0")})
    assert found.message == naming("arm", "collision", "a.ply", "1 triangle")


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
        assert found.message == naming("arm", "visual", "a.dae", "1", "0.01.0 0 1")

    def test_nothing_is_left(self, tmp_path: Path) -> None:
        bad = collada().replace(b"<p>0 1 2</p>", b"<p>0 1 7</p>")
        (found,) = reported(tmp_path, CODE, link(mesh("a.dae")), {"a.dae": bad})
        assert found.severity is Severity.WARNING
        assert found.message == naming("arm", "collision", "a.dae", "1 triangle")

    @pytest.mark.parametrize(("role", "number"), [("visual", 1), ("collision", 0)])
    def test_the_appearance_of_a_collision(self, tmp_path: Path, role: str, number: int) -> None:
        bad = collada(effect="<diffuse><color>0.01.0 0 1</color></diffuse>")
        found = reported(tmp_path, CODE, link(mesh("a.dae", role)), {"a.dae": bad})
        assert len(found) == number
