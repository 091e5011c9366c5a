from pathlib import Path

import pytest

from tests.naming import naming
from tests.reported import fixed, reported
from tests.workspaces import add_file, add_package, mesh_link
from urdfkit.text.diagnostic import Severity

CODE = "MSH003"


@pytest.fixture
def robot(tmp_path: Path) -> str:
    package = add_package(tmp_path / "arm", "arm")
    add_file(package / "meshes" / "forearm.stl")
    return str(package / "urdf" / "arm.urdf")


@pytest.mark.parametrize("start", ["", "file://", "file:", "file://localhost"])
def test_a_path_of_this_machine(robot: str, start: str) -> None:
    reference = f"{start}{Path(robot).parents[1]}/meshes/forearm.stl"
    text = mesh_link(reference)
    (found,) = reported(CODE, text, robot)
    assert found.severity is Severity.WARNING
    assert found.message == naming("arm", "visual", reference)
    right = mesh_link("package://arm/meshes/forearm.stl")
    assert fixed(CODE, text, robot) == fixed(CODE, right, robot)


def test_outside_of_every_package_nothing_better_is_known(robot: str, tmp_path: Path) -> None:
    (found,) = reported(CODE, mesh_link(str(add_file(tmp_path / "forearm.stl"))), robot)
    assert found.fix is None


@pytest.mark.parametrize(
    "reference",
    ["package://arm/meshes/forearm.stl", "../meshes/forearm.stl", "/no/such/forearm.stl"],
)
def test_other_references(robot: str, reference: str) -> None:
    assert reported(CODE, mesh_link(reference), robot) == []


@pytest.mark.parametrize(
    "start", ["file://$(find arm)", "file:///$(find arm)", "$(find arm)", "${directory}"]
)
def test_what_xacro_makes_absolute_is_fine(robot: str, start: str) -> None:
    text = f"""\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="directory" value="file://$(find arm)"/>
  {mesh_link(start + "/meshes/forearm.stl")}
</robot>
"""
    assert reported(CODE, text, robot) == []
    assert reported("MSH001", text, robot) == []


@pytest.fixture
def workspace(tmp_path: Path) -> str:
    package = add_package(tmp_path / "arm", "arm")
    add_file(package / "meshes" / "forearm.stl")
    add_file(add_package(tmp_path / "hand", "hand_description") / "hand.stl")
    add_file(tmp_path / "loose.stl")
    return str(package / "urdf" / "arm.urdf")


@pytest.mark.parametrize(
    ("reference", "help_"),
    [
        ("package://arm/../hand/hand.stl", naming("package://hand_description")),
        ("package://arm/meshes/../../loose.stl", naming("refer", "package://PACKAGE")),
        ("../../hand/hand.stl", naming("package://hand_description")),
    ],
)
def test_out_of_the_package(workspace: str, reference: str, help_: str) -> None:
    (found,) = reported(CODE, mesh_link(reference), workspace)
    assert found.severity is Severity.WARNING
    assert found.message == naming("arm", "visual", reference, "arm")
    assert found.help == help_


@pytest.mark.parametrize(
    "reference",
    [
        "package://arm/meshes/../meshes/forearm.stl",
        "../meshes/forearm.stl",
        "package://hand_description/hand.stl",
        "package://arm/../none.stl",  # MSH001
    ],
)
def test_within_a_package(workspace: str, reference: str) -> None:
    assert reported(CODE, mesh_link(reference), workspace) == []


def test_without_a_package_there_is_none_to_leave(tmp_path: Path) -> None:
    add_file(tmp_path / "meshes" / "a.stl")
    robot = str(tmp_path / "urdf" / "arm.urdf")
    assert reported(CODE, mesh_link("../meshes/a.stl"), robot) == []
