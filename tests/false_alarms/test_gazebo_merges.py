"""Links that Gazebo merges, and what that changes nothing of; blocks of one link."""

import pytest

from tests.gazebos import BASE, WHEELS, block, child, plugin
from tests.massive import shape
from tests.reported import messages

BALL = shape("collision", '<sphere radius="0.1"/>')
FOOTPRINT = '<link name="base_footprint">{}</link>\n'


@pytest.mark.parametrize(("inside", "count"), [("", 0), (BALL, 1)])
def test_self_collision_of_a_base_that_is_merged_into_its_footprint(
    inside: str, count: int
) -> None:
    base = BASE.replace("</link>", BALL + "</link>")
    joint = child("base", "fixed", parent="base_footprint").partition("</link>")[2]
    robot = FOOTPRINT.format(inside) + base + joint + block("<self_collide>true</self_collide>")
    assert len(messages("GAZ067", robot)) == count


@pytest.mark.parametrize(("reference", "count"), [("", 1), ("base", 0), ("world", 0)])
def test_a_robot_that_is_static_in_the_block_of_a_link(reference: str, count: int) -> None:
    """RRBot's `<gazebo reference="world"><static>`: `ign sdf -p` has no <static> then."""
    static = block("<static>true</static>", reference)
    robot = WHEELS + '<link name="world"/>' + plugin("libgazebo_ros_control.so") + static
    assert len(messages("GAZ063", robot)) == count
