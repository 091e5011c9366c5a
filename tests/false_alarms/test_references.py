"""Names of links that are not there, and the link that was meant."""

from pathlib import Path

import pytest

from tests.naming import naming
from tests.reported import messages, reported
from urdfkit import check
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Source

LINKS = '<link name="base_link"/><link name="arm_link"/>'
ARM = '<joint name="a" type="fixed"><parent link="base_link"/><child link="arm_link"/></joint>'


@pytest.mark.parametrize(
    ("joint", "hint"),
    [
        # 'arm_link' has a parent: two would be another error
        ('<parent link="base_link"/><child link="arm_lnk"/>', ""),
        ('<parent link="arm_lnk"/><child link="base_link"/>', "; did you mean 'arm_link'?"),
        # a joint from a link to itself would be, too
        ('<parent link="base_link"/><child link="base_lnk"/>', ""),
    ],
)
def test_the_link_that_is_suggested_is_free(joint: str, hint: str) -> None:
    robot = f'{LINKS}{ARM}<joint name="b" type="fixed">{joint}</joint>'
    (message,) = messages("REF001", robot)
    assert message.endswith("in the model" + hint)
    (message,) = messages("REF001", f'{LINKS}<joint name="b" type="fixed">{joint}</joint>')
    is_free = "base_lnk" not in joint
    assert ("mean 'arm_link'" in message) is is_free


FRAGMENT = (
    '<robot name="laser" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="laser"/>{}'
    '<joint name="l" type="fixed"><parent link="mast"/><child link="laser"/></joint></robot>'
)


@pytest.mark.parametrize(
    ("name", "more", "severity"),
    [
        ("laser.xacro", "", Severity.WARNING),
        ("laser.urdf", "", Severity.ERROR),
        ("laser.xacro", '<link name="base"/>', Severity.ERROR),
    ],
)
def test_a_part_with_a_name_for_robots_elsewhere(name: str, more: str, severity: Severity) -> None:
    report = check(Source(name, FRAGMENT.format(more).encode()), select=["REF001"])
    assert [found.severity for found in report.diagnostics] == [severity]


@pytest.mark.parametrize(
    ("tag", "reference", "hint"),
    [
        ("<collision/>", "front_caster", naming("front_caster_wheel")),
        ("<stopCfm>0</stopCfm>", "front_caster", naming("front_caster_joint")),
        (
            '<sensor name="s" type="force_torque"/>',
            "front_caster",
            naming("front_caster_joint"),
        ),
        ("<mu1>1</mu1>", "front_caster_whel", naming("front_caster_wheel")),
    ],
)
def test_a_block_of_a_link_is_not_for_a_joint(tag: str, reference: str, hint: str) -> None:
    """Mobile_Robot_URDF_Maker: joint 'front_caster_joint' was suggested for a <collision>."""
    ends = '<parent link="base"/><child link="front_caster_wheel"/>'
    robot = (
        '<link name="base"/><link name="front_caster_wheel"/>'
        f'<joint name="front_caster_joint" type="fixed">{ends}</joint>'
        f'<gazebo reference="{reference}">{tag}</gazebo>'
    )
    (found,) = reported("GAZ001", robot)
    assert found.help == hint


@pytest.mark.parametrize(
    ("tag", "is_named"),
    [('<link name="camera"/>', True), ('<xacro:property name="camera" value="1"/>', False)],
)
def test_a_property_with_the_name_of_a_link_is_no_link(
    tmp_path: Path, tag: str, is_named: bool
) -> None:
    """waiter_robot_ROS: camera_link is a length, and the block names a camera that is not there."""
    robot = (
        '<robot name="{}" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="base"/>'
        '{}<xacro:include filename="bot.gazebo"/></robot>'
    )
    (tmp_path / "a.xacro").write_text(robot.format("a", ""))
    (tmp_path / "b.xacro").write_text(robot.format("b", tag))
    block = '<robot><gazebo reference="camera"><material>Gazebo/Gray</material></gazebo></robot>'
    (tmp_path / "bot.gazebo").write_text(block)
    (found,) = check(tmp_path / "a.xacro", select=["GAZ001"]).diagnostics
    assert ("'camera', which b.xacro has" in found.help) is is_named
