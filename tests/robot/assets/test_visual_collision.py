from itertools import product

import pytest

from urdfkit.core.spatial import IDENTITY, Rotation, Transform, multiply, rotate, transposed
from urdfkit.robot.assets.visual_collision import QUARTERS
from urdfkit.robot.shapes import BoundingBox


def test_the_quarter_turns_are_the_rotations_of_a_cube() -> None:
    corners = {(x, y, z) for x, y, z in product((1.0, -1.0), repeat=3)}
    assert len({*QUARTERS, IDENTITY}) == 24
    for turn in QUARTERS:
        assert multiply(turn, transposed(turn)) == IDENTITY
        assert {rotate(turn, corner) for corner in corners} == corners
    angles = [turn[0][0] + turn[1][1] + turn[2][2] for turn in QUARTERS]
    assert angles == sorted(angles, reverse=True)


@pytest.mark.parametrize("turn", QUARTERS)
def test_a_box_moves_with_its_frame(turn: Rotation) -> None:
    frame = Transform(turn, (1, -2, 3))
    box = BoundingBox((0.5, 0, 1), (2, 1, 4))
    corners = BoundingBox.of(frame.apply((x, y, z)) for x, y, z in product(*zip(*box, strict=True)))
    found = box.moved(frame)
    assert found.low == pytest.approx(corners.low)
    assert found.high == pytest.approx(corners.high)
