"""Where URD008 moves tags to."""

import pytest

from tests.reported import fixed, reported
from tests.xacros import HEAD


def test_all_tags_of_a_link_go_into_one_new_block_behind_it() -> None:
    robot = """\
<link name="wheel">
  <mu1>0.5</mu1> <!-- rubber -->
  <mu2>0.5</mu2> <kp>1e6</kp>
  <collision><geometry><sphere radius="1"/></geometry><kd>1</kd></collision>
</link>
<link name="base"/>"""
    assert (
        fixed("URD008", robot)
        == """\
<robot name="example">
<link name="wheel">
  <!-- rubber -->
  <collision><geometry><sphere radius="1"/></geometry></collision>
</link>
<gazebo reference="wheel">
  <mu1>0.5</mu1>
  <mu2>0.5</mu2>
  <kp>1e6</kp>
  <kd>1</kd>
</gazebo>
<link name="base"/>
</robot>
"""
    )


@pytest.mark.parametrize(
    ("block", "filled"),
    [
        ('<gazebo reference="a"/>', '<gazebo reference="a">\n  <mu1>1</mu1>\n</gazebo>'),
        (
            '<gazebo reference="a">\n    <material>Gazebo/Red</material>\n</gazebo>',
            (
                '<gazebo reference="a">\n    <material>Gazebo/Red</material>\n    <mu1>1</mu1>\n'
                "</gazebo>"
            ),
        ),
        (
            '<gazebo reference="a"><kp>1</kp></gazebo>',
            '<gazebo reference="a"><kp>1</kp><mu1>1</mu1></gazebo>',
        ),
    ],
)
def test_a_block_that_there_is_is_used(block: str, filled: str) -> None:
    link = '<link name="a">\n  <mu1>1</mu1>\n</link>\n'
    expected = f'<robot name="example">\n<link name="a">\n</link>\n{filled}\n</robot>\n'
    assert fixed("URD008", link + block) == expected


@pytest.mark.parametrize(
    "robot",
    [
        # one of two values would win
        '<link name="a"><mu1>1</mu1></link><gazebo reference="a"><mu1>2</mu1></gazebo>',
        # of another kind, of another dialect, of nobody
        '<link name="a"/><joint name="j" type="fixed"><mu1>1</mu1></joint>',
        '<link name="a"><collision><surface/></collision></link>',
        '<link name="a"/><mu1>1</mu1>',
        "<link><mu1>1</mu1></link>",
    ],
)
def test_what_cannot_surely_be_moved_stays(robot: str) -> None:
    assert [one.fix for one in reported("URD008", robot)] == [None]


def test_a_macro_moves_it_for_all_of_its_calls() -> None:
    macro = """\
  <xacro:macro name="wheel" params="side">
    <link name="${side}_wheel">
      <mu1>0.5</mu1>
    </link>
  </xacro:macro>
  <xacro:wheel side="left"/>
  <xacro:wheel side="right"/>
"""
    robot = f"{HEAD}\n{macro}</robot>"
    moved = robot.replace("      <mu1>0.5</mu1>\n", "").replace(
        "    </link>\n",
        "    </link>\n"
        '    <gazebo reference="${side}_wheel">\n'
        "      <mu1>0.5</mu1>\n"
        "    </gazebo>\n",
    )
    assert fixed("URD008", robot, "r.xacro") == moved
