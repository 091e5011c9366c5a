"""JNT044: see the rule."""

from __future__ import annotations

import pytest

from tests.reported import messages, places

LEFT = '<origin xyz="0 0.2 0"/><axis xyz="0 1 0"/>'
RIGHT = '<origin xyz="0 -0.2 0"/><axis xyz="0 {} 0"/>'


def joint(name: str, inside: str, kind: str = "continuous") -> str:
    return (
        f'<link name="{name}_link"/>\n<joint name="{name}" type="{kind}"><parent link="base"/>'
        f'<child link="{name}_link"/>{inside}</joint>\n'
    )


def cart(right: str, *more: str, names: str = "{}_wheel") -> str:
    both = joint(names.format("left"), LEFT) + joint(names.format("right"), right)
    return f'<link name="base"/>\n{both}{"".join(more)}'


def test_opposite_axes() -> None:
    robot = cart(RIGHT.format(-1))
    message = "joint 'right_wheel' turns its wheel against the other one, 'left_wheel'"
    assert messages("JNT044", robot) == [message]
    assert places("JNT044", robot) == [(6, '<axis xyz="0 -1 0"/>')]


def test_the_frames_count() -> None:
    turned = RIGHT.format(1).replace("/><axis", ' rpy="3.14159265 0 0"/><axis')
    assert len(messages("JNT044", cart(turned))) == 1
    assert messages("JNT044", cart(turned.replace("0 1 0", "0 -1 0"))) == []


REAR = joint("rear_left_wheel", LEFT) + joint("rear_right_wheel", RIGHT.format(-1))


@pytest.mark.parametrize(
    "robot",
    [
        cart(RIGHT.format(1)),
        cart(RIGHT.format(-1), REAR),  # JNT043 knows more of four
        cart(RIGHT.format(-1), names="{}_caster_wheel"),
        cart(RIGHT.format(-1), names="{}_arm"),
        cart(RIGHT.format(-1)).replace("continuous", "revolute"),
        cart('<origin xyz="0 -0.2 0"/><axis xyz="1 0 0"/>'),  # JNT042
    ],
)
def test_what_may_be_meant(robot: str) -> None:
    assert messages("JNT044", robot) == []
