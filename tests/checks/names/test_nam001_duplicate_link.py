from __future__ import annotations

from tests.reported import reported


def test_every_further_one_is_told_with_the_first() -> None:
    found = reported(
        "NAM001", '<link name="a"/>\n<link name="b"/>\n<link name="a"/>\n<link name="a"/>'
    )
    assert [one.message for one in found] == ["a second link is called 'a'"] * 2
    assert [one.span.line for one in found] == [4, 5]
    assert [one.related[0].span.line for one in found] == [2, 2]


def test_a_macro_called_twice_without_a_prefix() -> None:
    robot = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="leg" params="side"><link name="leg"/></xacro:macro>
  <xacro:leg side="left"/>
  <xacro:leg side="right"/>
</robot>
"""
    (found,) = reported("NAM001", robot, "robot.xacro")
    assert (found.span.line, found.span.text) == (2, "leg")
    assert [call.via[0].span.line for call in found.calls] == [4], "the call that makes the second"


def test_links_and_joints_are_apart_and_nameless_links_are_another_finding() -> None:
    assert reported("NAM001", '<link name="a"/><joint name="a" type="fixed"/><link/><link/>') == []
