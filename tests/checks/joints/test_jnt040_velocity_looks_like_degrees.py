"""JNT040: see the rule."""

from __future__ import annotations

from math import radians

import pytest

from tests.jointed import joint, limit, robot
from tests.reported import fixed, messages, reported


def arm(*velocities: str, kind: str = "revolute") -> str:
    """Joints ``j0``, ``j1`` ... of some velocities."""
    return robot(
        *(
            joint(f"j{number}", kind, limit("-1", "1", velocity=velocity))
            for number, velocity in enumerate(velocities)
        )
    )


@pytest.mark.parametrize(
    ("velocities", "suspects"),
    [
        (("180",), ["j0"]),
        (("90", "90", "90"), ["j0", "j1", "j2"]),
        (("155", "155", "230"), ["j0", "j1", "j2"]),  # a data sheet
        (("3.1", "2.5", "183"), ["j2"]),  # 3.2 rad/s
    ],
)
def test_degrees(velocities: tuple[str, ...], suspects: list[str]) -> None:
    found = [message.partition(" may")[0] for message in messages("JNT040", arm(*velocities))]
    assert found == [f"joint '{name}'" for name in suspects]


def test_a_wheel_whose_ends_are_none_may_be_fast() -> None:
    wheels = [joint(f"j{i}", "revolute", limit("-1e9", "1e9", velocity=v)) for i, v in
              enumerate(("73", "92"))]  # fmt: skip
    assert reported("JNT040", robot(*wheels)) == []


def test_the_fix_is_the_same_speed_in_radians() -> None:
    (found,) = reported("JNT040", arm("225"))
    assert found.message == (
        "joint 'j0' may turn at 225 rad/s; that looks like degrees per second, 3.93 rad/s"
    )
    mended = fixed("JNT040", arm("225"))
    assert f'velocity="{radians(225):.10g}"' in mended
    assert reported("JNT040", mended) == []


@pytest.mark.parametrize(
    "velocities",
    [
        ("100", "100"),
        ("1000",),
        ("50", "3"),
        ("20", "30", "37"),  # a G1
        ("30.1", "28.6"),
        ("111", "28.8"),  # the wheels of an Upkie
        ("100", "100.7"),
        ("50000", "1.79769e+308"),
        ("155",),
    ],
)
def test_fast_motors_and_placeholders(velocities: tuple[str, ...]) -> None:
    assert messages("JNT040", arm(*velocities)) == []


def test_wheels_are_fast() -> None:
    assert messages("JNT040", arm("180", kind="continuous")) == []
