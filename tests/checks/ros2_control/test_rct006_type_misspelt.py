from __future__ import annotations

import pytest

from tests.controls import NEXT, ROBOT, control, driven
from tests.reported import messages, places, reported


@pytest.mark.parametrize(
    ("kind", "hint"),
    [
        ("System", "; did you mean 'system'?"),
        ("sensors", "; did you mean 'sensor'?"),
        ("robot", ""),
    ],
)
def test_a_type_that_loads_nothing(kind: str, hint: str) -> None:
    text = ROBOT + control(driven("swing"), kind=kind)
    assert messages("RCT006", text) == [
        f"<ros2_control> 'c' has type '{kind}', not system, actuator, sensor{hint}"
    ]
    assert places("RCT006", text) == [(NEXT, kind)]


def test_no_type() -> None:
    text = ROBOT + control(driven("swing")).replace(' type="system"', "")
    assert messages("RCT006", text) == ["<ros2_control> 'c' has no type"]


@pytest.mark.parametrize("kind", ["system", "actuator", "sensor", "${kind}"])
def test_the_types_that_there_are(kind: str) -> None:
    assert reported("RCT006", ROBOT + control(driven("swing"), kind=kind)) == []
