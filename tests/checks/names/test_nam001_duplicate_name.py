import pytest

from tests.reported import reported

JOINT = '<joint name="j" type="fixed"/>\n'
BLUE = '<material name="blue"><color rgba="0 0 1 1"/></material>\n'


@pytest.mark.parametrize(
    ("element", "rest", "name"),
    [
        ('<link name="a"/>\n', "", "link 'a'"),
        (JOINT, '<link name="a"/>', "joint 'j'"),
        (BLUE, '<link name="a"/>', "material 'blue'"),
    ],
)
def test_every_further_one_is_reported_with_the_first(element: str, rest: str, name: str) -> None:
    found = reported("NAM001", f"{element * 3}{rest}")
    assert [one.message for one in found] == [f"duplicate {name}"] * 2
    assert [one.span.line for one in found] == [3, 4]
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


VISUAL = f'<visual><geometry><sphere radius="1"/></geometry>{BLUE}</visual>'


@pytest.mark.parametrize(
    "robot",
    [
        '<link name="a"/><joint name="a" type="fixed"/>',
        "<link/><link/>",
        f'{BLUE}<link name="a">{VISUAL * 2}</link>',
        (
            '<link name="a"/><joint name="j" type="fixed"/>'
            '<transmission name="t"><joint name="j"/></transmission>'
            '<ros2_control name="c"><joint name="j"/></ros2_control>'
        ),
    ],
)
def test_other_elements_may_have_the_same_name(robot: str) -> None:
    assert reported("NAM001", robot) == []
