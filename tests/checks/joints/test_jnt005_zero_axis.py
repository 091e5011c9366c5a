from __future__ import annotations

import pytest

from tests.jointed import joint, robot
from tests.reported import messages, places, reported


@pytest.mark.parametrize("kind", ["revolute", "continuous", "prismatic", "planar"])
@pytest.mark.parametrize("axis", ["0 0 0", "0 0.0 -0", "0 0 1e-07"])
def test_an_axis_without_direction(kind: str, axis: str) -> None:
    text = robot(joint("j", kind, f'<axis xyz="{axis}"/>'))
    shown = " ".join(f"{float(part):g}" for part in axis.split())
    assert messages("JNT005", text) == [f"joint 'j': the axis {shown} has no direction"]
    assert places("JNT005", text) == [(4, axis)]


def test_an_axis_without_xyz() -> None:
    text = robot(joint("j", "continuous", "<axis/>"))
    assert messages("JNT005", text) == ["joint 'j': <axis> has no xyz and is read as 0 0 0"]
    assert places("JNT005", text) == [(4, "<axis/>")]


@pytest.mark.parametrize(
    ("kind", "content"),
    [
        ("continuous", ""),  # JNT007
        ("continuous", '<axis xyz="0 0 1"/>'),
        ("continuous", '<axis xyz="0 0 0.001"/>'),  # JNT006
        ("continuous", '<axis xyz="0 0"/>'),  # URD005
        ("fixed", '<axis xyz="0 0 0"/>'),  # JNT020
        ("floating", '<axis xyz="0 0 0"/>'),
    ],
)
def test_no_finding(kind: str, content: str) -> None:
    assert reported("JNT005", robot(joint("j", kind, content))) == []
