"""JNT043: see the rule."""

from __future__ import annotations

import pytest

from tests.jointed import joint, robot
from tests.reported import messages, places

NAMES = ("fl_wheel", "fr_wheel", "rl_wheel", "rr_wheel")


def rover(*axes: str, names: tuple[str, ...] = NAMES, kind: str = "continuous") -> str:
    return robot(
        *(joint(n, kind, f'<axis xyz="{axis}"/>') for n, axis in zip(names, axes, strict=True))
    )


@pytest.mark.parametrize("odd", range(4))
@pytest.mark.parametrize("way", [1, -1])
def test_one_against_three(odd: int, way: int) -> None:
    axes = [f"0 {way} 0"] * 4
    axes[odd] = f"0 {-way} 0"
    text = rover(*axes)
    message = f"joint '{NAMES[odd]}' turns its wheel against the other three"
    assert messages("JNT043", text) == [message]
    assert places("JNT043", text) == [(4 + 2 * odd, f'<axis xyz="0 {-way} 0"/>')]


def test_the_frames_count() -> None:
    turned = '<origin rpy="3.14159265 0 0"/><axis xyz="0 -1 0"/>'
    wheels = [joint(name, "continuous", '<axis xyz="0 1 0"/>') for name in NAMES[:3]]
    assert messages("JNT043", robot(*wheels, joint("rr_wheel", "continuous", turned))) == []


@pytest.mark.parametrize(
    "other",
    [
        rover("0 1 0", "0 -1 0", "0 1 0", "0 -1 0"),  # side against side, as a Scout
        rover("0 1 0", "0 1 0", "0 1 0", "0 1 0"),
        rover("0 1 0", "0 1 0", "0 1 0", "1 0 0"),  # JNT033
        rover("0 1 0", "0 1 0", "0 -1 0", names=NAMES[:3]),
        rover("0 1 0", "0 1 0", "0 1 0", "0 -1 0", names=(*NAMES[:3], "caster_wheel")),
        rover("0 1 0", "0 1 0", "0 1 0", "0 -1 0", kind="fixed"),
    ],
)
def test_what_may_be_meant(other: str) -> None:
    assert messages("JNT043", other) == []


LEFT = '<origin xyz="0 0.2 0"/><axis xyz="0 1 0"/>'
RIGHT = '<origin xyz="0 -0.2 0"/><axis xyz="0 {} 0"/>'


def wheel(name: str, inside: str, kind: str = "continuous") -> str:
    return (
        f'<link name="{name}_link"/>\n<joint name="{name}" type="{kind}"><parent link="base"/>'
        f'<child link="{name}_link"/>{inside}</joint>\n'
    )


def cart(right: str, *more: str, names: str = "{}_wheel") -> str:
    both = wheel(names.format("left"), LEFT) + wheel(names.format("right"), right)
    return f'<link name="base"/>\n{both}{"".join(more)}'


def test_opposite_axes() -> None:
    text = cart(RIGHT.format(-1))
    message = "joint 'right_wheel' turns its wheel against the other one, 'left_wheel'"
    assert messages("JNT043", text) == [message]
    assert places("JNT043", text) == [(6, '<axis xyz="0 -1 0"/>')]


def test_the_frames_of_a_pair_count() -> None:
    turned = RIGHT.format(1).replace("/><axis", ' rpy="3.14159265 0 0"/><axis')
    assert len(messages("JNT043", cart(turned))) == 1
    assert messages("JNT043", cart(turned.replace("0 1 0", "0 -1 0"))) == []


REAR = wheel("rear_left_wheel", LEFT) + wheel("rear_right_wheel", RIGHT.format(-1))


@pytest.mark.parametrize(
    "text",
    [
        cart(RIGHT.format(1)),
        cart(RIGHT.format(-1), REAR),  # four wheels are compared
        cart(RIGHT.format(-1), names="{}_caster_wheel"),
        cart(RIGHT.format(-1), names="{}_arm"),
        cart(RIGHT.format(-1)).replace("continuous", "revolute"),
        cart('<origin xyz="0 -0.2 0"/><axis xyz="1 0 0"/>'),  # JNT025
    ],
)
def test_no_opposite_pair(text: str) -> None:
    assert messages("JNT043", text) == []
