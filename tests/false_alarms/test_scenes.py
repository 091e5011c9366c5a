"""Surroundings that are written as a robot."""

import pytest

from tests.reported import messages

LINK = '<link name="{}"><visual><geometry><box size="{}"/></geometry></visual></link>\n'


@pytest.mark.parametrize(("walls", "count"), [(1, 1), (2, 0), (9, 0)])
def test_many_walls_about_a_small_root(walls: int, count: int) -> None:
    """animals_description: nine walls of 6 m fixed to a box of 0.1 m."""
    robot = LINK.format("base", "0.1 0.1 0.1")
    robot += "".join(LINK.format(f"l_{number}", "4 4 6") for number in range(walls))
    assert len(messages("JNT012", robot)) == count


@pytest.mark.parametrize("links", [1, 3])
def test_a_visual_in_millimetres_over_a_collision_in_metres(links: int) -> None:
    small = '<collision><geometry><box size="0.1 0.1 0.1"/></geometry></collision></link>'
    hand = LINK.replace("</link>", small).format("hand_{}", "50 50 90")
    assert len(messages("JNT012", "".join(hand.format(i) for i in range(links)))) == links


@pytest.mark.parametrize(("kind", "count"), [("fixed", 0), ("revolute", 1)])
def test_a_plane_on_a_small_root(kind: str, count: int) -> None:
    """animals_description: an inclined plane of 8 x 8 x 6 m, fixed to a box of 0.1 m."""
    joint = f'<joint name="j" type="{kind}"><parent link="base"/><child link="one"/></joint>'
    robot = LINK.format("base", "0.1 0.1 0.1") + LINK.format("one", "8 8 6") + joint
    assert len(messages("JNT012", robot)) == count
