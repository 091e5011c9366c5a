"""The fingers of a hand."""

import pytest

from urdfkit.robot.fingers import finger_of, odd_one, series


@pytest.mark.parametrize(
    ("name", "finger"),
    [
        ("right_index_pip", "index"),
        ("LPinkyProximal", "Pinky"),
        ("thumb_mcp", ""),
        ("index_ring_spacer", ""),  # two fingers
        ("stringer", ""),
    ],
)
def test_the_finger_of_a_name(name: str, finger: str) -> None:
    assert finger_of(name) == finger


def test_series() -> None:
    fingers = ("index", "middle", "ring", "pinky")
    tips = [f"l_{finger}_tip" for finger in fingers]
    assert series([*tips, "l_thumb_tip", "palm", *(f"{one}_base" for one in fingers[:3])]) == [tips]


@pytest.mark.parametrize(
    ("values", "odd"),
    [((1, 1, 2, 1), ("c", 1)), ((1, 1, 1, 1), None), ((1, 1, 2, 2), None), ((1, 2, 1), None)],
)
def test_the_odd_one(values: tuple[int, ...], odd: tuple[str, int] | None) -> None:
    assert odd_one(dict(zip("abcd", values, strict=False))) == odd
