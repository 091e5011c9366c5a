"""JNT042: see the rule."""

from __future__ import annotations

import pytest

from tests.jointed import joint, limit, robot
from tests.reported import messages, places

PLACES = ("0.1 0.2 0", "0.1 -0.2 0")


def hip(side: str, xyz: str, axis: str, kind: str = "revolute", rpy: str = "0 0 0") -> str:
    content = f'<origin xyz="{xyz}" rpy="{rpy}"/><axis xyz="{axis}"/>{limit("-1", "1")}'
    return joint(f"{side}_hip", kind, content)


def hips(left: str, right: str, kind: str = "revolute", places: tuple[str, str] = PLACES) -> str:
    return robot(hip("left", places[0], left, kind), hip("right", places[1], right, kind))


def test_one_letter() -> None:
    text = hips("0 1 0", "1 0 0")
    assert messages("JNT042", text) == [
        (
            "joint 'right_hip' turns about 1 0 0, seen from the root, and its twin 'left_hip' "
            "about 0 1 0"
        )
    ]
    assert places("JNT042", text) == [(6, '<axis xyz="1 0 0"/>')]


def test_the_frames_count() -> None:
    turned = hip("right", PLACES[1], "1 0 0", rpy="0 0 1.5708")
    assert messages("JNT042", robot(hip("left", PLACES[0], "0 1 0"), turned)) == []
    assert len(messages("JNT042", robot(hip("left", PLACES[0], "1 0 0"), turned))) == 1


@pytest.mark.parametrize(
    ("left", "right"),
    [
        ("0 1 0", "0 1 0"),
        ("0 1 0", "0 -1 0"),
        ("1 0 0", "-1 0 0"),
        ("0.6 0.8 0", "0.6 -0.8 0"),
        ("0.6 0.8 0", "-0.6 0.8 0"),
    ],
)
def test_mirror_images_to_either_side(left: str, right: str) -> None:
    assert messages("JNT042", hips(left, right)) == []


@pytest.mark.parametrize(
    "other",
    [
        hips("0 1 0", "1 0 0", "prismatic"),
        hips("0 1 0", "1 0 0", places=("0.1 0.2 0", "0.3 -0.2 0")),  # two arms on a table
        hips("0 1 0", "1 0 0", places=("0.1 0 0", "0.1 0 0")),
        robot(hip("upper", PLACES[0], "0 1 0"), hip("lower", PLACES[1], "1 0 0")),
    ],
)
def test_what_is_no_mirror_image(other: str) -> None:
    assert messages("JNT042", other) == []
