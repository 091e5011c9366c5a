from __future__ import annotations

from tests.reported import reported


def test_every_further_one_is_told_with_the_first() -> None:
    joint = '<joint name="j" type="fixed"/>\n'
    found = reported("NAM002", f'<link name="a"/>\n{joint * 3}')
    assert [one.message for one in found] == ["a second joint is called 'j'"] * 2
    assert [one.span.line for one in found] == [4, 5]
    assert [one.related[0].span.line for one in found] == [3, 3]


def test_the_same_name_below_other_elements_is_no_joint_of_the_robot() -> None:
    robot = (
        '<link name="a"/><joint name="j" type="fixed"/>'
        '<transmission name="t"><joint name="j"/></transmission>'
        '<ros2_control name="c"><joint name="j"/></ros2_control>'
    )
    assert reported("NAM002", robot) == []
