from __future__ import annotations

import pytest

from tests.reported import fixed, messages, places, reported

JOINT = """\
<link name="a"/>
<link name="b"/>
<joint name="j" type="continuous">
  <parent link="a"/>
  <child link="b"/>
  {}
</joint>"""


def test_an_unknown_element_is_named_with_its_owner() -> None:
    robot = JOINT.format('<anchor xyz="0 0 0"/>')
    assert messages("URD001", robot) == ["joint 'j': unknown element <anchor> in <joint> (ignored)"]
    assert places("URD001", robot) == [(7, '<anchor xyz="0 0 0"/>')]
    without = robot.replace('  <anchor xyz="0 0 0"/>\n', "")
    assert fixed("URD001", robot) == f'<robot name="example">\n{without}\n</robot>\n'


@pytest.mark.parametrize(
    ("written", "suggested"),
    [
        ('<orign xyz="0 0 1"/>', '<origin xyz="0 0 1"/>'),
        ("<Axis xyz='0 0 1'></Axis>", "<axis xyz='0 0 1'></axis>"),
        ('<dynamic damping="1" >\n </dynamic >', '<dynamics damping="1" >\n </dynamics >'),
    ],
)
def test_a_slip_is_corrected_at_both_ends(written: str, suggested: str) -> None:
    assert fixed("URD001", JOINT.format(written)) == (
        f'<robot name="example">\n{JOINT.format(suggested)}\n</robot>\n'
    )


@pytest.mark.parametrize("inside", ["<text/>", "12", "<!-- 12 -->"])
def test_only_what_holds_nothing_is_removed(inside: str) -> None:
    (found,) = reported("URD001", JOINT.format(f"<anchor>{inside}</anchor>"))
    assert (found.fix is None) == (inside != "<!-- 12 -->")


def test_what_is_there_already_is_not_meant_again() -> None:
    robot = JOINT.format('<origin xyz="0 0 1"/><orign xyz="0 0 1"/>')
    assert messages("URD001", robot) == ["joint 'j': unknown element <orign> in <joint> (ignored)"]


@pytest.mark.parametrize(
    "known",
    [
        '<drake:damping xmlns:drake="http://drake.mit.edu" d="1"/>',
        '<calibration rising="0"/>',
        '<safety_controller k_velocity="1"/>',
    ],
)
def test_extensions_with_a_prefix_and_rare_elements_are_known(known: str) -> None:
    assert reported("URD001", JOINT.format(known)) == []


@pytest.mark.parametrize(
    "robot",
    [
        '<link name="a"><contact><lateral_friction value="1"/></contact></link>',  # PyBullet
        '<robot name="r"><mujoco><compiler/></mujoco><link name="a"/></robot>',
        '<robot name="r"><link name="a"/><frame name="f" link="a"/></robot>',  # Drake
        '<robot name="r"><link name="a"/><gazebo><what/></gazebo></robot>',
        '<robot name="r"><link name="a"/><transmission><what/></transmission></robot>',
    ],
)
def test_dialects_of_other_readers_are_known(robot: str) -> None:
    assert reported("URD001", robot) == []


def test_a_macro_body_is_one_finding_with_its_calls_and_can_be_mended() -> None:
    robot = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="part" params="name">
    <link name="${name}"><visua><geometry><box size="1 1 1"/></geometry></visua></link>
  </xacro:macro>
  <xacro:part name="a"/>
  <xacro:part name="b"/>
</robot>
"""
    (found,) = reported("URD001", robot, "robot.xacro")
    assert [call.message.partition(":")[0] for call in found.calls] == ["link 'a'", "link 'b'"]
    assert fixed("URD001", robot, "robot.xacro") == robot.replace("visua>", "visual>")


def test_a_macro_without_its_prefix_is_another_finding() -> None:
    robot = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="part" params=""><link name="part"/></xacro:macro>
  <link name="base"/>
  <part/>
</robot>
"""
    assert reported("URD001", robot, "robot.xacro") == []
    assert len(reported("XAC002", robot, "robot.xacro")) == 1
