"""The text about the pose in which gravity exceeds an effort limit."""

import pytest

pytest.importorskip("numpy")

from urdfkit.physics.gravity import Load
from urdfkit.physics.overloads import worst_pose


@pytest.mark.parametrize(
    ("pose", "text"),
    [
        ({}, "zero"),
        ({"a": 1e-5}, "zero"),
        ({"a": 0.5, "b": -1.57}, "a 0.5, b -1.57"),
        # A humanoid has twenty joints in a row: those far from zero are named, in their order.
        (
            {"a": 0.1, **{f"j{n}": -1.0 - n for n in range(6)}, "b": 0.2, "c": 1e-5},
            "j0 -1, j1 -2, j2 -3, j3 -4, j4 -5, j5 -6 and 2 more",
        ),
        # The joint itself is named in any case.
        (
            {"j": 0.1, **{f"j{n}": -1.0 - n for n in range(6)}},
            "j 0.1, j1 -2, j2 -3, j3 -4, j4 -5, j5 -6 and 1 more",
        ),
    ],
)
def test_worst_pose(pose: dict[str, float], text: str) -> None:
    assert worst_pose(Load("j", 1.0, 0.0, 0.0, 2.0, pose)) == text
