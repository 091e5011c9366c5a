from __future__ import annotations

import pytest

from tests.reported import messages, places, reported


@pytest.mark.parametrize(
    ("robot", "message"),
    [
        ('<link name="a"><visual/></link>', "link 'a': <visual> has no <geometry>"),
        ('<link name="a"><collision/></link>', "link 'a': <collision> has no <geometry>"),
        (
            '<link name="a"><inertial><mass value="1"/></inertial></link>',
            "link 'a': <inertial> has no <inertia>",
        ),
        (
            '<link name="a"/><joint name="j" type="fixed"><parent link="a"/></joint>',
            "joint 'j' has no <child>",
        ),
    ],
)
def test_what_is_missing_is_named(robot: str, message: str) -> None:
    assert messages("URD004", robot) == [message]


def test_the_place_is_the_element_that_lacks_it() -> None:
    robot = '<link name="a"/>\n<joint name="j" type="fixed">\n</joint>'
    assert places("URD004", robot) == [(3, '<joint name="j" type="fixed">')] * 2


@pytest.mark.parametrize(
    "robot",
    [
        '<link name="a"/>',
        '<link name="a"/><gazebo><plugin/></gazebo><transmission name="t"/>',
        '<link name="a"><visual><geometry/></visual></link>',  # URD009
        '<link name="a"><visual><geomtry/></visual></link>',  # URD013
    ],
)
def test_what_is_not_missing_or_told_by_another_rule(robot: str) -> None:
    assert reported("URD004", robot) == []
