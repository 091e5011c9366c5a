from __future__ import annotations

import pytest

from tests.jointed import joint, limit, robot
from tests.reported import messages, places, reported


@pytest.mark.parametrize(("kind", "unit"), [("revolute", "rad"), ("prismatic", "m")])
def test_marks_beyond_the_limits(kind: str, unit: str) -> None:
    marks = '<calibration rising="1.6" falling="-2"/>'
    text = robot(joint("j", kind, limit("-1.5", "1.5") + marks))
    assert messages("JNT024", text) == [
        f"joint 'j': the rising edge at 1.6 {unit} is not within its limits -1.5 to 1.5 {unit}",
        f"joint 'j': the falling edge at -2 {unit} is not within its limits -1.5 to 1.5 {unit}",
    ]
    assert places("JNT024", text) == [(4, "1.6"), (4, "-2")]


@pytest.mark.parametrize(
    ("kind", "content"),
    [
        ("revolute", limit("-1.5", "1.5") + '<calibration rising="1.5" falling="0"/>'),
        ("revolute", limit("-1.5", "1.5") + '<calibration rising="1.5029"/>'),
        ("revolute", limit("-1.5", "1.5") + '<calibration rising="x"/>'),  # URD005
        ("revolute", limit("-1.5", "1.5") + '<calibration reference_position="9"/>'),
        ("revolute", limit("0", "0") + '<calibration rising="1"/>'),  # JNT004
        ("continuous", '<calibration rising="9"/>'),
        ("fixed", '<calibration rising="9"/>'),
    ],
)
def test_no_finding(kind: str, content: str) -> None:
    assert reported("JNT024", robot(joint("j", kind, content))) == []
