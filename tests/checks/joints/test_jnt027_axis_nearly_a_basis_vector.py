from __future__ import annotations

import pytest

from tests.jointed import joint, of_xacro, robot
from tests.reported import fixed, messages, places, reported


@pytest.mark.parametrize(
    ("axis", "off", "which", "suggested"),
    [
        ("0.0039668 0 -0.99999", "0.004", "-z", "0 0 -1"),
        ("0 -1 -4.37114e-08", "4.4e-08", "-y", "0 -1 0"),
        ("1 1e-3 1e-3", "0.0014", "x", "1 0 0"),
        ("-1 2e-09 0", "2e-09", "-x", "-1 0 0"),
    ],
)
def test_nearly_a_basis_vector(axis: str, off: str, which: str, suggested: str) -> None:
    text = robot(joint("j", "continuous", f'<axis xyz="{axis}"/>'))
    assert messages("JNT027", text) == [f"joint 'j': the axis is {off} rad off {which}"]
    assert places("JNT027", text) == [(4, axis)]
    mended = fixed("JNT027", text)
    assert f'<axis xyz="{suggested}"/>' in mended
    assert reported("JNT027", mended) == []


@pytest.mark.parametrize(
    ("kind", "axis"),
    [
        ("continuous", "0 0 1"),
        ("continuous", "0 0 -0.99999"),
        ("continuous", "-2.220446049250313e-16 -0.9999999999999998 0.0"),
        ("continuous", "0 0.0069 1"),
        ("continuous", "0 0.707 0.707"),
        ("continuous", "0 0.001 2"),  # JNT006
        ("continuous", "0 0 0"),  # JNT005
        ("fixed", "0 0.001 1"),  # JNT020
    ],
)
def test_no_finding(kind: str, axis: str) -> None:
    assert reported("JNT027", robot(joint("j", kind, f'<axis xyz="{axis}"/>'))) == []


def test_what_an_expression_gave_is_not_edited() -> None:
    text = of_xacro(robot(joint("j", "continuous", '<axis xyz="0 ${0.001} 1"/>')))
    assert [found.fix for found in reported("JNT027", text, "robot.xacro")] == [None]
