"""New packages: without a finding, and as they are promised."""

import ast
from pathlib import Path

import pytest

from urdfkit import check, load, simulate
from urdfkit.cli import main
from urdfkit.errors import UnwritableFile, UrdfkitError
from urdfkit.output.package_templates import KINDS, create
from urdfkit.text.diagnostic import Severity


@pytest.fixture(params=KINDS)
def package(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    create("my_robot", request.param, str(tmp_path))
    return tmp_path / "my_robot"


def test_nothing_is_found_in_it(package: Path) -> None:
    report = check(package)
    assert report.diagnostics == ()
    names = {Path(file).name for file in report.files}
    assert names == {"simulation.launch.py", "my_robot.urdf.xacro"}
    assert not report.crashed


def test_nothing_is_found_with_real_hardware(package: Path) -> None:
    robot = package / "urdf" / "my_robot.urdf.xacro"
    report = check(robot, arguments={"sim": "false"})
    assert [one for one in report.diagnostics if one.severity is not Severity.INFO] == []


def test_it_is_formatted(package: Path) -> None:
    assert main(["format", "--check", str(package)]) == 0


def test_a_mistake_in_it_is_found(package: Path) -> None:
    """Its files are read: a controller of a joint that is not there."""
    controllers = package / "config" / "controllers.yaml"
    text = controllers.read_text(encoding="utf-8")
    joint = "elbow" if "elbow" in text else "left_wheel_joint"
    controllers.write_text(text.replace(joint, "nowhere"), encoding="utf-8")
    assert not check(package).ok


def test_it_behaves(package: Path) -> None:
    for library in ("mujoco", "trimesh"):
        pytest.importorskip(library)
    found = simulate(package / "urdf" / "my_robot.urdf.xacro")
    assert [str(one) for one in found.verdicts if not one.passes] == []
    assert {one.test for one in found.verdicts} >= {"drive", "drop" if found.is_free else "hold"}


def test_it_is_drawn(package: Path, tmp_path: Path) -> None:
    pytest.importorskip("PIL")
    out = tmp_path / "robot.png"
    robot = package / "urdf" / "my_robot.urdf.xacro"
    assert main(["render", str(robot), "-o", str(out), "--size", "64x64"]) == 0
    assert out.stat().st_size


def test_its_name_is_everywhere(package: Path) -> None:
    files = [file for file in package.rglob("*") if file.is_file()]
    assert not [file for file in files if "@" in file.name or file.suffix == ".in"]
    assert not [file for file in files if "@name@" in file.read_text(encoding="utf-8")]
    assert load(package / "urdf" / "my_robot.urdf.xacro").name == "my_robot"
    ast.parse((package / "launch" / "simulation.launch.py").read_text(encoding="utf-8"))


@pytest.mark.parametrize(
    "name", ["", "a", "Robot", "9a", "a-b", "a__b", "_a", "a_", "../a", "a b", "é", "a\n", "xacro"]
)
def test_names_that_are_none(name: str, tmp_path: Path) -> None:
    with pytest.raises(UrdfkitError, match=r"is not a valid package name|would depend on"):
        create(name, "arm", str(tmp_path))
    assert list(tmp_path.iterdir()) == []


def test_nothing_is_overwritten(tmp_path: Path) -> None:
    (tmp_path / "robot").mkdir()
    with pytest.raises(UnwritableFile, match="exists; nothing is overwritten"):
        create("robot", "arm", str(tmp_path))
    assert list((tmp_path / "robot").iterdir()) == []


def test_the_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["new", "robot", "--kind", "arm", "-o", str(tmp_path / "src")]) == 0
    printed = capsys.readouterr().out
    package = tmp_path / "src" / "robot"
    files = {str(file) for file in package.rglob("*") if file.is_file()}
    assert {line for line in printed.splitlines() if line in files} == files
    assert main(["new", "robot", "--kind", "arm", "-o", str(tmp_path / "src")]) == 2
    assert main(["new", "robot"]) == 2
    assert "missing option '--kind'" in capsys.readouterr().err
