from pathlib import Path

import pytest

from tests.naming import naming
from tests.reported import messages, places, reported
from tests.workspaces import add_file, add_package, mesh_link
from urdfkit.lint import engine
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Source

CODE = "XAC011"


@pytest.fixture
def robot(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    """Path of a robot in a package."""
    for variable in ("AMENT_PREFIX_PATH", "ROS_PACKAGE_PATH"):
        monkeypatch.delenv(variable, raising=False)
    package = add_package(tmp_path / "arm", "arm_description")
    add_file(package / "meshes" / "forearm.stl")
    return str(package / "urdf" / "arm.urdf")


def test_one_finding_for_all_meshes_of_a_package(robot: str) -> None:
    text = mesh_link("package://nao/a.stl", "package://nao/b.stl", "package://pr2/c.stl")
    package = Path(robot).parents[1]
    searched = [package / "urdf", "AMENT_PREFIX_PATH", "ROS_PACKAGE_PATH", package, "1"]
    assert messages(CODE, text, robot) == [
        naming("arm", "nao", "2", *searched),
        naming("arm", "pr2", "1", *searched),
    ]
    found = reported(CODE, text, robot)
    assert {diagnostic.severity for diagnostic in found} == {Severity.WARNING}
    assert found[0].help == naming("--package", "nao=DIR")
    assert places(CODE, text, robot) == [(3, "package://nao/a.stl"), (5, "package://pr2/c.stl")]


def test_the_files_of_such_a_package_are_not_called_missing(robot: str) -> None:
    assert reported("MSH001", mesh_link("package://nao/a.stl"), robot) == []


def test_a_typo_in_the_name(robot: str) -> None:
    (found,) = reported(CODE, mesh_link("package://arm_descripton/meshes/forearm.stl"), robot)
    assert found.help == naming("--package", "arm_descripton=DIR", "arm_description")


def test_given_by_the_user(robot: str, tmp_path: Path) -> None:
    add_file(tmp_path / "elsewhere" / "a.stl")
    source = Source(robot, whole_robot(mesh_link("package://nao/a.stl")).encode())
    packages = {"nao": str(tmp_path / "elsewhere")}
    report = engine.check(source, packages=packages, select=[CODE, "MSH001"])
    assert report.diagnostics == ()


def test_a_model_that_gazebo_would_not_find(robot: str) -> None:
    (message,) = messages(CODE, mesh_link("model://lidar.stl"), robot)
    assert "model 'lidar.stl'" in message
    assert "GAZEBO_MODEL_PATH (" in message


@pytest.mark.parametrize("reference", ["package://arm_description/none.stl", "a.stl", "x://y/z"])
def test_other_references(robot: str, reference: str) -> None:
    assert reported(CODE, mesh_link(reference), robot) == []


def test_a_declared_package_is_missing_on_this_machine_only(robot: str) -> None:
    manifest = Path(robot).parents[1] / "package.xml"
    text = manifest.read_text()
    manifest.write_text(text.replace("</package>", "<depend>nao</depend></package>"))
    (found,) = reported(CODE, mesh_link("package://nao/a.stl"), robot)
    assert found.severity is Severity.INFO


@pytest.mark.parametrize(("file", "severity"), [("", Severity.INFO), ("arm/x", Severity.WARNING)])
def test_a_submodule_that_is_not_checked_out(robot: str, file: str, severity: Severity) -> None:
    """gripper-ros: its description is a submodule."""
    package = Path(robot).parents[1]
    add_file(package / ".gitmodules", b'[submodule "arm"]\n\tpath = arm\n\turl = a@b:c.git\n')
    (package / "arm").mkdir()
    if file:
        add_file(package / file)
    (found,) = reported(CODE, mesh_link("package://hand/a.stl"), robot)
    assert found.severity is severity
