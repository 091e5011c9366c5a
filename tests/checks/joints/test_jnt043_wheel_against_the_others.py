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
