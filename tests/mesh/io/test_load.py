import struct
import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")

import numpy as np

from tests.mesh import made
from tests.mesh.measures import bounds, volume
from urdfkit.mesh.io.load import UnloadableMesh, load, salvage

TETRAHEDRON = [("part.stl", made.binary_stl()), ("part.stl", made.ascii_stl())]
NAN = float("nan")


def write(directory: Path, name: str, data: bytes) -> Path:
    path = directory / name
    path.write_bytes(data)
    return path


@pytest.mark.parametrize(("name", "data"), TETRAHEDRON, ids=["binary", "ascii"])
def test_a_tetrahedron(tmp_path: Path, name: str, data: bytes) -> None:
    mesh = load(write(tmp_path, name, data))
    assert mesh.faces.shape == (4, 3)
    assert bounds(mesh) == ((0, 0, 0), (1, 1, 1))
    assert volume(mesh) == pytest.approx(1 / 6, rel=1e-12)
    assert mesh == mesh._replace(unit=1, up_axis="", losses=(), extras=(), textures=())


def test_content_decides_and_not_the_suffix(tmp_path: Path) -> None:
    assert len(load(write(tmp_path, "part.dae", made.binary_stl())).faces) == 4
    assert len(load(write(tmp_path, "part", made.obj())).faces) == 2


@pytest.mark.parametrize("header", [b"solid part", b"solid vertex 1 2 3\nfacet"])
def test_binary_with_the_header_of_ascii(tmp_path: Path, header: bytes) -> None:
    assert len(load(write(tmp_path, "a.stl", made.binary_stl(header=header))).faces) == 4


def test_the_name_of_a_solid_is_no_corner(tmp_path: Path) -> None:
    mesh = load(write(tmp_path, "a.stl", made.ascii_stl(name="a vertex 9 9 9")))
    assert mesh.faces.shape == (4, 3)
    assert bounds(mesh) == ((0, 0, 0), (1, 1, 1))


def test_corners_that_are_not_finite_are_reported(tmp_path: Path) -> None:
    far = ((0.0, 0.0, 0.0), (NAN, 0.0, 0.0), (0.0, 1.0, 0.0))
    mesh = load(write(tmp_path, "a.stl", made.binary_stl([*made.TETRAHEDRON, far])))
    assert mesh.losses == ("1 triangle with a coordinate that is not finite",)
    assert mesh.faces.shape == (4, 3)
    assert np.isfinite(mesh.vertices).all()


def test_colours_of_a_binary_stl(tmp_path: Path) -> None:
    data = bytearray(made.binary_stl())
    struct.pack_into("<H", data, 84 + 48, 0x8000 | 31)
    assert load(write(tmp_path, "a.stl", bytes(data))).extras == ("colours of 1 triangle",)


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        (b"", "is empty"),
        (made.binary_stl()[:-1], "declares 4 triangles and contains 3"),
        (made.binary_stl() + b"x", "has 1 byte after the declared 4 triangles"),
        (made.ascii_stl()[:-14], "ends after 4 triangles, without 'endsolid'"),
        (b"version https://git-lfs.github.com/spec/v1\n", "is a Git LFS pointer: the mesh itself"),
        (b"<html><title>404</title>", "is a web page: '404'"),
        (b"ISO-10303-21;", "is STEP, which is not supported"),
    ],
)
def test_what_cannot_be_loaded(tmp_path: Path, data: bytes, reason: str) -> None:
    path = write(tmp_path, "a.stl", data)
    with pytest.raises(UnloadableMesh) as caught:
        load(path)
    assert caught.value.reason.startswith(reason)
    assert str(caught.value) == f"{path}: {caught.value.reason}"


def test_what_is_no_file(tmp_path: Path) -> None:
    for path, reason in (
        (tmp_path, "is not a regular file"),
        (tmp_path / "none.stl", "file not found"),
        (tmp_path / "a\0.stl", "cannot be read: its name contains a NUL"),
        (Path("/dev/zero"), "is not a regular file"),
    ):
        with pytest.raises(UnloadableMesh) as caught:
            load(path)
        assert caught.value.reason == reason


def test_a_large_file_is_not_read(tmp_path: Path) -> None:
    path = tmp_path / "large.stl"
    with path.open("wb") as file:
        file.truncate(200 * 1024**2)  # takes no room on the disk
    with pytest.raises(UnloadableMesh) as caught:
        load(path)
    assert caught.value.reason == "is too large: 200 MiB > 128 MiB"


def test_what_is_left_of_a_truncated_file(tmp_path: Path) -> None:
    mesh = salvage(write(tmp_path, "a.stl", made.binary_stl()[:-1]))
    assert mesh.faces.shape == (3, 3)
    assert mesh.losses == ("1 declared triangle missing from the file",)
    mesh = salvage(write(tmp_path, "b.stl", made.ascii_stl()[:-60]))
    assert mesh.faces.shape == (3, 3)
    with pytest.raises(UnloadableMesh):
        salvage(write(tmp_path, "c.stl", b""))


def test_the_common_formats_do_without_trimesh(tmp_path: Path) -> None:
    for name, data in (
        ("a.stl", made.binary_stl()),
        ("a.dae", made.collada()),
        ("a.obj", made.obj()),
    ):
        write(tmp_path, name, data)
    code = (
        "import sys; from urdfkit.mesh.io.load import load\n"
        f"for name in 'a.stl', 'a.dae', 'a.obj': load({str(tmp_path)!r} + '/' + name)\n"
        "assert 'numpy' in sys.modules\n"
        "assert not {'trimesh', 'collada', 'scipy', 'PIL'} & set(sys.modules)"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
