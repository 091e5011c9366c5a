"""The mission's package, fixed end to end."""

import shutil
from pathlib import Path

import pytest

from tests.conftest import MODELS
from urdfkit import check, expand, fix
from urdfkit.cli import main
from urdfkit.text.diagnostic import Severity

#: The fixes of infos are applied only where their codes are given.
INFOS = ("GAZ045", "INE008", "JNT020", "XAC007")


@pytest.fixture(scope="module")
def robot(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The model of a copy of the package, after all of its fixes."""
    package = tmp_path_factory.mktemp("mission") / "gazebo_pkg"
    shutil.copytree(MODELS / "gazebo_pkg", package)
    file = package / "urdf" / "waking_robot_new.xacro"
    fixes = fix(file, unsafe=True)
    assert {one.code for one in fixes.applied} == {
        "RCT029",
        "GEO004",
        "TRE008",
        "URD001",
        "URD008",
        "XAC004",
        "XAC014",
    }
    assert {left.diagnostic.code for left in fixes.left if left.reason == "info"} == {*INFOS}
    fixes.write()
    infos = fix(file, unsafe=True, select=INFOS)
    assert {one.code for one in infos.applied} == {*INFOS}
    infos.write()
    return file


def test_no_error_and_no_warning_with_a_fix_is_left(robot: Path) -> None:
    report = check(robot)
    assert [d.code for d in report.diagnostics if d.severity is not Severity.INFO] == ["MSH001"]
    assert [d.code for d in report.diagnostics if d.fix] == []
    assert report.crashed == ()


def test_a_second_run_changes_nothing(robot: Path) -> None:
    assert fix(robot, unsafe=True).files == ()


def test_comments_and_layout_are_kept(robot: Path) -> None:
    original = (MODELS / "gazebo_pkg" / "urdf" / robot.name).read_text()
    text = robot.read_text()
    assert "libgazebo_ros_gpu_laser.so" in text
    assert all(line in text for line in original.splitlines() if "<!--" in line)


def test_it_expands_and_has_the_inertia_of_its_shapes(robot: Path) -> None:
    text = expand(robot).text()
    assert text.count("<mu1>0.5</mu1>") == 4
    assert text.count('ixx="0.0005541666666666666"') == 4


def test_with_its_mesh_made_nothing_but_hints_is_left(
    robot: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    pytest.importorskip("trimesh")
    shutil.copytree(robot.parents[1], tmp_path / "gazebo_pkg")
    file = tmp_path / "gazebo_pkg" / "urdf" / robot.name
    fixes = fix(file, unsafe=True, generate_meshes=True)
    assert fixes.files == ()
    assert [Path(mesh.path).name for mesh in fixes.meshes] == ["hokuyo.dae"]
    assert {left.diagnostic.severity for left in fixes.left} == {Severity.INFO}
    fixes.write()
    report = check(file)
    assert {d.severity for d in report.diagnostics} == {Severity.INFO}
    assert [d.code for d in report.diagnostics if d.fix] == []
    picture = tmp_path / "robot.png"
    assert main(["render", str(file), "-o", str(picture)]) == 0
    assert picture.stat().st_size > 10_000
    assert "striped" not in capsys.readouterr().err  # as a missing mesh would be drawn


def test_pinocchio_loads_it(robot: Path) -> None:
    pinocchio = pytest.importorskip("pinocchio")
    model = pinocchio.buildModelFromXML(expand(robot).text())
    assert (model.nq, model.nv) == (8, 4)
    wheel = model.inertias[model.getJointId("base_to_wheel1")].inertia
    # A cylinder of 0.5 kg, radius 0.06 m and length 0.05 m along z.
    assert wheel[2, 2] == pytest.approx(0.5 / 2 * 0.06**2)
    assert wheel[0, 0] == pytest.approx(0.5 / 12 * (3 * 0.06**2 + 0.05**2))
