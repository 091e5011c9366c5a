from __future__ import annotations

import pytest

from tests.reported import places, reported

XACRO = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'


def test_the_place_is_the_robot() -> None:
    assert places("URD010", '<?xml version="1.0"?>\n<robot><link name="a"/></robot>') == [
        (2, "<robot>")
    ]


@pytest.mark.parametrize(
    ("robot", "count"),
    [
        (f'<robot {XACRO}><xacro:macro name="m" params=""/></robot>', 0),
        (f'<robot {XACRO}><link name="a"/><xacro:property name="p" value="1"/></robot>', 1),
        ('<robot name=""><link name="a"/></robot>', 0),  # check_urdf accepts it
        ("<robot/>", 1),
    ],
)
def test_only_a_library_of_macros_needs_none(robot: str, count: int) -> None:
    assert (
        len(reported("URD010", robot, "robot.xacro" if XACRO in robot else "robot.urdf")) == count
    )
    assert reported("URD003", robot) == []
