"""JNT039: see the rule."""

import pytest

from tests.jointed import joint, limit, robot
from tests.naming import naming
from tests.reported import messages, places

Limits = tuple[str, str]


def arm(*limits: Limits, kind: str = "revolute") -> str:
    """Joints ``j0``, ``j1`` ... with effort and velocity."""
    return robot(
        *(
            joint(f"j{number}", kind, limit("-1", "1", effort, velocity))
            for number, (effort, velocity) in enumerate(limits)
        )
    )


REST: tuple[Limits, ...] = (("80", "3"), ("40", "2"), ("10", "4"))


def test_a_wheel_is_not_compared_with_an_arm() -> None:
    wheel = joint("wheel", "continuous", limit("0", "0", "100", "1000"))
    rest = [joint(f"j{i}", "revolute", limit("-1", "1", "10", "0.5")) for i in range(4)]
    assert messages("JNT039", robot(wheel, *rest)) == []


@pytest.mark.parametrize(
    ("odd", "said"),
    [
        (("1000000", "3"), ["effort", "1e+06 N·m", "1.25e+04", "largest"]),
        (("50", "180"), ["velocity", "180 rad/s", "45", "largest"]),
        (("0.04", "3"), ["effort", "0.04 N·m", "0.004", "smallest"]),
        (("20", "0.01"), ["velocity", "0.01 rad/s", "0.005", "smallest"]),
    ],
)
@pytest.mark.parametrize("place", [0, 3])
def test_one_of_four_is_odd(odd: Limits, said: list[str], place: int) -> None:
    limits = [*REST]
    limits.insert(place, odd)
    assert messages("JNT039", arm(*limits)) == [naming(f"j{place}", *said)]


def test_it_is_reported_where_the_number_stands() -> None:
    ((_, text),) = places("JNT039", arm(*REST, ("9e9", "3")))
    assert text == "9e9"


@pytest.mark.parametrize(
    "limits",
    [
        (*REST, ("15000", "70")),  # a strong lift, and a fast hand
        (*REST, ("1000000", "3"), ("1000000", "3")),  # two that are meant
        (*REST, ("0", "0")),  # JNT008
        (*REST[:2], ("1000000", "1000")),  # three make no rule
        (*REST, ("0.1", "0.02")),
    ],
)
def test_what_real_robots_have(limits: tuple[Limits, ...]) -> None:
    assert messages("JNT039", arm(*limits)) == []


def test_slides_are_compared_with_slides() -> None:
    fingers = joint("finger", "prismatic", limit("0", "0.1", "50000", "100"))
    assert messages("JNT039", arm(*REST) + fingers) == []
    (message,) = messages("JNT039", arm(*REST, ("90000", "3"), kind="prismatic"))
    assert message == naming("j3", "effort", "90000 N", "1.12e+03", "largest")


@pytest.mark.parametrize(
    ("ends", "kind", "count"),
    [
        (("0", "0.98175"), "prismatic", 1),
        (("-0.98175", "0"), "prismatic", 1),
        (("0", "0.98175"), "revolute", 0),
        (("0", "0.982"), "prismatic", 0),  # three digits
        (("0", "0.05"), "prismatic", 0),
    ],
)
def test_a_slide_with_the_limits_of_a_joint_that_turns(
    ends: tuple[str, str], kind: str, count: int
) -> None:
    text = robot(joint("ring", "revolute", limit(*ends)), joint("pinky", kind, limit(*ends)))
    lower, upper = (f"{float(end):g}" for end in ends)
    expected = naming("pinky", "prismatic", f"[{lower}, {upper}] m", "revolute", "ring", "rad")
    assert messages("JNT039", text) == [expected] * count
    assert places("JNT039", text) == [(6, "prismatic")] * count
