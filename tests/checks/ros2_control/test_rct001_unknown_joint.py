from pathlib import Path

import pytest

from tests.controls import (
    NEXT,
    ROBOT,
    TRAJECTORY,
    control,
    driven,
    reported_with_file,
    transmission,
)
from tests.jointed import joint, limit, robot
from tests.naming import naming
from tests.reported import fixed, messages, places, reported
from urdfkit import check


def test_a_joint_of_ros2_control() -> None:
    text = ROBOT + control(driven("swing"), driven("swnig"))
    assert messages("RCT001", text) == [
        "<ros2_control> 'c': unknown joint 'swnig'; did you mean 'swing'?"
    ]
    assert places("RCT001", text) == [(NEXT + 3, "swnig")]


def test_a_joint_of_a_transmission() -> None:
    text = ROBOT + transmission("wheel")
    assert messages("RCT001", text) == [naming("t", "unknown", "wheel")]
    assert places("RCT001", text) == [(NEXT + 1, "wheel")]
    assert reported("RCT001", text, targets=("classic-ros1", "ros2")) != []
    assert reported("RCT001", text, targets=("ros2",)) == [], "nothing reads it there"


def test_a_transmission_of_ros2_finds_the_joints_of_its_block_only() -> None:
    inner = '<transmission name="t"><plugin>p/C</plugin><joint name="{}" role="r"/></transmission>'
    assert messages("RCT001", ROBOT + control(driven("swing"), inner.format("slide"))) == [
        naming("t", "slide", "<ros2_control>", "c")
    ]
    assert reported("RCT001", ROBOT + control(driven("swing"), inner.format("swing"))) == []


def test_an_actuator_of_a_transmission_is_no_joint() -> None:
    """A youBot: its actuators have parameters of the bus."""
    inner = '<plugin>p/C</plugin><actuator name="m" role="a"/><joint name="swing" role="j"/>'
    block = f'<transmission name="t">{inner}</transmission>'
    parameters = '<joint name="m"><param name="bus">1</param></joint>'
    (found,) = reported("RCT001", ROBOT + control(driven("swing"), parameters, block))
    assert found.message == naming("<ros2_control>", "c", "m", "actuator")
    assert found.help == naming("<joint>", "<hardware>")
    assert found.fix is None


def test_gpio_may_have_any_name() -> None:
    assert reported("RCT001", ROBOT + control('<gpio name="g"/>', '<sensor name="s"/>')) == []
    assert reported("RCT001", ROBOT + control("<joint/>", driven("${side}_arm"))) == []


def test_part_of_a_robot_is_accepted(tmp_path: Path) -> None:
    xacro = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
    part = tmp_path / "part.xacro"
    part.write_text(f"<robot {xacro}>{transmission('elsewhere')}</robot>")
    (tmp_path / "whole.xacro").write_text(
        f'<robot name="r" {xacro}><xacro:include filename="part.xacro"/>{ROBOT}</robot>'
    )
    assert check(part, select=["RCT001"]).diagnostics == ()
    (found,) = check(tmp_path / "whole.xacro", select=["RCT001"]).diagnostics
    assert found.span.source.path.endswith("part.xacro")


def test_description_of_hardware_only() -> None:
    """As in webots_ros2, where the joints are in the world."""
    block = control(driven("left motor"), driven("right motor"))
    assert reported("RCT001", block) == reported("RCT001", '<link name="base"/>' + block) == []
    assert len(reported("RCT001", ROBOT + block)) == 2


def test_fix_renames_the_joint_if_two_blocks_agree() -> None:
    joints = robot(joint("swnig", "continuous", limit("0", "0", "10", "2")))
    once, twice = (joints + control(driven("swing")) * count for count in (1, 2))
    assert fixed("RCT001", once).count('<joint name="swnig"') == 2
    assert fixed("RCT001", twice).count('<joint name="swing"') == 3


@pytest.mark.parametrize(
    ("joints", "other", "count"),
    [
        ("joints: [wheel], interfaces: [position]", "slide", 1),
        ("joints: [wheel]", "slide", 0),  # read only with interfaces
        ("joints: [wheel], interfaces: [position]", "elbow", 0),  # of another robot
        ("joints: [wheel, slide], interfaces: [position]", "elbow", 1),
    ],
)
def test_joints_of_a_broadcaster(tmp_path: Path, joints: str, other: str, count: int) -> None:
    kind = "joint_state_broadcaster/JointStateBroadcaster"
    text = (
        f"b: {{ros__parameters: {{type: {kind}, {joints}}}}}\n"
        f"arm: {{ros__parameters: {{type: {TRAJECTORY}, joints: [{other}]}}}}\n"
        f"hand: {{ros__parameters: {{type: {TRAJECTORY}, joints: [swing]}}}}\n"
    )
    found = reported_with_file("RCT001", tmp_path, text, "")
    assert [one.message for one in found] == [naming("b", "unknown", "wheel")] * count


@pytest.mark.parametrize(("name", "offered"), [("neck_stretch", False), ("neck_ptch", True)])
def test_a_joint_with_an_entry_of_its_own_is_not_offered(name: str, offered: bool) -> None:
    """Kate's neck: the joint of one of its transmissions is not in the robot any more."""
    neck = robot(joint("neck_pitch", "continuous", limit("0", "0", "10", "2")))
    (found,) = reported("RCT001", neck + control(driven(name), driven("neck_pitch")))
    assert bool(found.fix) is ("did you mean" in found.message) is offered


@pytest.mark.parametrize(
    ("left", "right", "found"),
    [("swing", "slide", 0), ("swnig", "slide", 1), ("swnig", "sldie", 0), ("", "slide", 0)],
)
def test_a_parameter_of_the_hardware_names_no_joint(left: str, right: str, found: int) -> None:
    """Only where its counterpart names one: else nothing says that joints are meant."""
    hardware = f"""<hardware><plugin>p/C</plugin><param name="left_wheel_name">{left}</param>
        <param name="right_wheel_name">{right}</param></hardware>"""
    joints = driven("swing") + driven("slide")
    text = ROBOT + f'<ros2_control name="c" type="system">{hardware}{joints}</ros2_control>'
    expected = naming("<ros2_control>", "c", "left_wheel_name", "right_wheel_name", left, "swing")
    assert messages("RCT001", text) == [expected] * found
