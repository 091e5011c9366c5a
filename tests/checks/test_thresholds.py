"""Thresholds of rules: what is just within is not reported, and what is just beyond is."""

from collections.abc import Callable

import pytest

from tests.checks.collision.test_col001_overlapping_links import bent
from tests.checks.joints.test_jnt006_missing_or_non_unit_axis import moved
from tests.checks.joints.test_jnt012_looks_like_millimetres import at
from tests.checks.ros2_control.test_rct009_command_range_outside_limits import starting
from tests.controls import ROBOT, control
from tests.false_alarms.test_low_caster import on_wheels
from tests.jointed import joint, robot
from tests.massive import BALL, link, part, shape
from tests.reported import messages


def origins(near: float, far: float) -> str:
    """Joints at one, two and three times a distance, and one far away."""
    return robot(*(at(f"j{n}", f"0 0 {n * near}") for n in (1, 2, 3)), at("far", f"0 0 {far}"))


def travel(longest: float, upper: int) -> str:
    limit = f'<axis xyz="1 0 0"/><limit lower="0" upper="{upper}" effort="1" velocity="1"/>'
    return link("s", shape("visual", f'<box size="{longest} 0.1 0.1"/>')) + robot(
        joint("j", "prismatic", limit)
    )


#: By rule and bound: the robot of a number, a number within the bound, and one beyond it.
THRESHOLDS: dict[str, tuple[Callable[[float], str], float, float]] = {
    "JNT006 length": (lambda x: moved(f"0 0 {x}"), 1.0099, 1.0101),
    "JNT006 deviation": (lambda x: moved(f"0 {x} 1"), 0.0051, 0.0049),
    "JNT006 rounding": (lambda x: moved(f"0 {x} 1"), 0.9e-9, 1.1e-9),
    "JNT012 origin": (lambda x: origins(0.01, x), 9.99, 10.0),
    "JNT012 ratio": (lambda x: origins(0.1, x), 20.0, 20.1),
    "JNT012 travel": (lambda x: travel(0.1, int(x)), 4, 5),
    "JNT012 travel by length": (lambda x: travel(0.5, int(x)), 10, 11),
    "RCT009 initial value": (
        lambda x: ROBOT + control(starting("slide", "position", str(x))),
        0.5009,
        0.5011,
    ),
    "COL001 depth": (bent, 0.0009, 0.0011),
}


@pytest.mark.parametrize("bound", THRESHOLDS)
def test_what_is_beyond_is_reported(bound: str) -> None:
    if bound.startswith("COL"):
        pytest.importorskip("coal")
    make, within, beyond = THRESHOLDS[bound]
    code = bound.partition(" ")[0]
    assert messages(code, make(within)) == []
    assert len(messages(code, make(beyond))) == 1


#: The same of what messages add.
NOTES: dict[str, tuple[Callable[[float], str], float, float, str]] = {
    "TRE008 wheels": (
        lambda x: on_wheels(-0.03 - x),
        0.101,
        0.099,
        "the wheels left, right are 0.099 m higher",
    ),
    "INE006 gyration": (
        lambda x: part("ball", 1, (x * x,) * 3, BALL),
        0.99,
        1.01,
        "radius of gyration is 1.01 m",
    ),
}


@pytest.mark.parametrize("bound", NOTES)
def test_what_is_beyond_is_said(bound: str) -> None:
    make, within, beyond, note = NOTES[bound]
    code, word = bound.split()
    (plain,), (noted,) = (messages(code, make(number)) for number in (within, beyond))
    assert word not in plain
    assert note in noted
