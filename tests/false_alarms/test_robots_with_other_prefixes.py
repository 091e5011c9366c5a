"""Robots and SRDFs for other arguments, and other robots of one name."""

from pathlib import Path

import pytest

from tests.workspaces import add_file, add_package
from tests.xacros import xacro
from urdfkit import Diagnostic, check

ARM = '<link name="${p}_base"/><link name="${p}_tool"/>'
JOINT = (
    '<joint name="${p}_wrist" type="fixed"><parent link="${p}_base"/><child link="${p}_tool"/>'
    "</joint>"
)
HARDWARE = (
    '<ros2_control name="${p}_hardware" type="system"><hardware>'
    "<plugin>mock_components/GenericSystem</plugin></hardware>"
    '<joint name="${p}_wrist"><command_interface name="position"/></joint></ros2_control>'
)
TWO_ARMS = (
    '<xacro:arg name="prefix_1" default=""/><xacro:arg name="prefix_2" default=""/>'
    f'<xacro:macro name="arm" params="p">{ARM}{JOINT}{HARDWARE}</xacro:macro>'
    '<xacro:arm p="$(arg prefix_1)"/><xacro:arm p="{}"/>'
)


@pytest.mark.parametrize(
    ("second", "severity", "is_named"),
    [("$(arg prefix_2)", "warning", True), ("$(arg prefix_1)", "error", False)],
)
@pytest.mark.parametrize("code", ["NAM001", "RCT007"])
def test_two_arms_with_empty_prefixes(
    tmp_path: Path, code: str, second: str, severity: str, is_named: bool
) -> None:
    """abb_ros2_control: a launch file passes the prefixes, which it reads from a file."""
    robot = add_file(tmp_path / "r.urdf.xacro", xacro(TWO_ARMS.replace("{}", second)).encode())
    found = check(robot, select=[code]).diagnostics
    assert severity in {one.severity.value for one in found}
    for one in found:
        assert ("'prefix_1' and 'prefix_2'" in one.help) == is_named


def _of_srdf(directory: Path, srdf: str, *robots: str) -> list[Diagnostic]:
    """What is said of the names in an SRDF, compared with the first robot in its package."""
    package = add_package(directory / "arm", "arm")
    add_file(package / "config" / "r.srdf", f'<robot name="r">{srdf}</robot>')
    for number, links in enumerate(robots):
        names = "".join(f'<link name="{name}"/>' for name in links.split())
        joints = "".join(
            f'<joint name="j{at}" type="fixed"><parent link="base"/><child link="{name}"/></joint>'
            for at, name in enumerate(links.split()[1:])
        )
        add_file(package / "urdf" / f"r{number}.urdf", f'<robot name="r">{names}{joints}</robot>')
    return list(check(package / "urdf" / "r0.urdf", select=["SRD001", "SRD011"]).diagnostics)


GROUPS = "".join(
    f'<group name="{side}"><link name="{side}_base"/><link name="{side}_tool"/></group>'
    for side in ("left", "right")
)


@pytest.mark.parametrize(
    ("links", "codes"), [("base _base _tool", {"SRD011"}), ("base tip", {"SRD001"})]
)
def test_an_srdf_for_two_prefixes(tmp_path: Path, links: str, codes: set[str]) -> None:
    """abb_ros2_control: the SRDF has the prefixes that the robot gets from a launch file."""
    assert {one.code for one in _of_srdf(tmp_path, GROUPS, links)} == codes


@pytest.mark.parametrize(("other", "count"), [("base tool contact", 0), ("base tool", 1)])
def test_an_srdf_for_the_robot_beside(tmp_path: Path, other: str, count: int) -> None:
    """mim_robots: the arm with a gripper lacks the tip of the others, and has their name."""
    group = '<group name="g"><link name="base"/><link name="tool"/><link name="contact"/></group>'
    found = _of_srdf(tmp_path, group, "base tool finger", other)
    assert [one.code for one in found] == ["SRD001"] * count


@pytest.mark.parametrize(("default", "count"), [("true", 0), ("false", 1)])
def test_the_srdf_of_a_configuration_with_its_own_robot(
    tmp_path: Path, default: str, count: int
) -> None:
    """ada_ros2: a launch file that shows the robot takes its fork off; MoveIt has it."""
    (tmp_path / ".git").mkdir()
    tool = (
        '<link name="fork"/><joint name="j" type="fixed"><parent link="base"/><child link="fork"/>'
        "</joint>"
    )
    arm = add_package(tmp_path / "ada", "ada")
    add_file(
        arm / "urdf" / "ada.xacro",
        '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="ada">'
        f'<xacro:arg name="fork" default="{default}"/><link name="base"/>'
        f'<xacro:if value="$(arg fork)">{tool}</xacro:if></robot>',
    )
    add_file(
        arm / "launch" / "view.launch",
        "<launch><param name='robot_description' "
        "command='xacro $(find ada)/urdf/ada.xacro fork:=false'/></launch>",
    )
    moveit = add_package(tmp_path / "ada_moveit", "ada_moveit")
    add_file(
        moveit / "config" / "ada.urdf.xacro",
        '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="ada">'
        '<xacro:include filename="$(find ada)/urdf/ada.xacro"/></robot>',
    )
    group = '<group name="g"><link name="base"/><link name="fork"/></group>'
    add_file(moveit / "config" / "ada.srdf", f'<robot name="ada">{group}</robot>')
    servo = "move_group_name: g\nee_frame_name: fork\ncommand_out_topic: c/joint_trajectory\n"
    add_file(moveit / "config" / "servo.yaml", servo)
    for code in ("SRD001", "SRD030"):
        found = check(tmp_path, select=[code]).diagnostics
        assert (
            len({(one.span.line, one.message) for one in found if "fork" in one.message}) == count
        )
