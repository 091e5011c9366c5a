"""Links that Gazebo merges, and what that changes nothing of."""

import pytest

from tests.gazebos import BASE, block, child
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
