from pathlib import Path

import pytest

from tests.mesh import made
from tests.naming import naming
from tests.reported import reported
from tests.workspaces import add_file, mesh_link
from urdfkit.text.diagnostic import Severity

CODE = "MSH007"


def message(tmp_path: Path, name: str, data: bytes) -> str | None:
    add_file(tmp_path / name, data)
    found = reported(CODE, mesh_link(name), str(tmp_path / "arm.urdf"), ("gz-harmonic",))
    if not found:
        return None
    assert found[0].severity is Severity.ERROR
    return found[0].message.removeprefix(f"link 'arm': the visual mesh '{name}' ")


def test_a_cad_file(tmp_path: Path) -> None:
    step = b"ISO-10303-21;\nHEADER;\n"
    for name in ("arm.step", "arm.stl"):
        assert message(tmp_path, name, step) == naming("STEP", "Gazebo", "MuJoCo", "Drake")


@pytest.mark.parametrize(
    ("name", "data", "expected"),
    [
        ("a.stl", made.obj(), naming("OBJ", ".stl")),
        ("a.DAE", made.binary_stl(), naming("binary", "STL", ".DAE")),
        ("a.stlb", made.ascii_stl(), naming("ASCII", "STL", ".stlb")),
        ("a.bin", made.collada(), naming("COLLADA", ".bin")),
        ("mesh", made.collada(), naming("COLLADA", "")),
    ],
)
def test_the_suffix_of_another_format(
    tmp_path: Path, name: str, data: bytes, expected: str
) -> None:
    assert message(tmp_path, name, data) == expected


@pytest.mark.parametrize(
    ("name", "data"),
    [
        *((f"mesh{suffix}", data) for (_, suffix), data in made.SOUND.items()),
        ("a.STL", made.ascii_stl()),
        ("a.stlb", made.binary_stl()),
        ("a.fbx", b"Kaydara FBX Binary  "),  # new Gazebo and RViz read it
        ("a.mesh", b"\x00\x10[MeshSerializer_v1.8]"),  # RViz reads it
        ("a.stl", made.binary_stl()[:-1]),  # MSH009
    ],
)
def test_what_some_reader_takes(tmp_path: Path, name: str, data: bytes) -> None:
    assert message(tmp_path, name, data) is None


@pytest.mark.parametrize(
    ("targets", "count"), [((), 0), (("drake",), 0), (("ros2", "drake"), 0), (("ros2",), 1)]
)
def test_the_soft_bodies_of_drake(tmp_path: Path, targets: tuple[str, ...], count: int) -> None:
    add_file(tmp_path / "bowl.vtk", b"# vtk DataFile Version 3.0\nbowl\nASCII\n")
    robot = mesh_link("bowl.vtk")
    assert len(reported(CODE, robot, str(tmp_path / "bowl.urdf"), targets)) == count
    assert reported("MSH009", robot, str(tmp_path / "bowl.urdf"), targets) == []
