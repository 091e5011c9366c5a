from __future__ import annotations

import pytest

from tests.jointed import joint, of_xacro, robot
from tests.reported import fixed, messages, places, reported


@pytest.mark.parametrize(
    ("axis", "norm", "unit"),
    [
        ("0 0 2", "2", "0 0 1"),
        ("0 -3 0", "3", "0 -1 0"),
        ("1 1 0", "1.414", "0.7071067812 0.7071067812 0"),
        ("1 0 0.5", "1.118", "0.894427191 0 0.4472135955"),
        ("-0 0 0.5", "0.5", "0 0 1"),
        ("0 0 0.98", "0.98", "0 0 1"),
    ],
)
def test_an_axis_of_another_length(axis: str, norm: str, unit: str) -> None:
    text = robot(joint("j", "continuous", f'<axis xyz="{axis}"/>'))
    shown = " ".join(f"{float(part):g}" for part in axis.split())
    assert messages("JNT006", text) == [f"joint 'j': the axis {shown} has length {norm}, not 1"]
    assert places("JNT006", text) == [(4, axis)]
    mended = fixed("JNT006", text)
    assert f'<axis xyz="{unit}"/>' in mended
    assert reported("JNT006", mended) == []


@pytest.mark.parametrize(
    ("kind", "axis"),
    [
        ("revolute", "0 0 1"),
        ("revolute", "0 0.707106 -0.707106"),
        ("revolute", "0.71 0.71 0"),
        ("revolute", "0.577 0.577 0.577"),
        ("revolute", "0 0 0"),  # JNT005
        ("fixed", "0 0 2"),  # JNT020
        ("revolute", "0 0 x"),  # URD005
    ],
)
def test_no_finding(kind: str, axis: str) -> None:
    assert reported("JNT006", robot(joint("j", kind, f'<axis xyz="{axis}"/>'))) == []


def test_what_an_expression_gave_is_not_edited() -> None:
    content = joint("j", "continuous", '<axis xyz="${2} 0 0"/>')
    (found,) = reported("JNT006", of_xacro(robot(content)), "robot.xacro")
    assert found.fix is None


def test_a_macro_is_mended_once_for_all_of_its_calls() -> None:
    macro = joint("${name}", "continuous", '<axis xyz="0 0 2"/>')
    text = of_xacro(
        f'<xacro:macro name="wheel" params="name">{macro}</xacro:macro><link name="base"/>'
        '<xacro:wheel name="a"/><xacro:wheel name="b"/>'
    )
    (found,) = reported("JNT006", text, "robot.xacro")
    assert len(found.calls) == 2
    mended = fixed("JNT006", text, "robot.xacro")
    assert reported("JNT006", mended, "robot.xacro") == []
