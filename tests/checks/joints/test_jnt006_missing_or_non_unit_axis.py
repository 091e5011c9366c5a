import pytest

from tests.jointed import joint, of_xacro, robot
from tests.naming import naming
from tests.reported import fixed, messages, places, reported
from urdfkit.text.diagnostic import Severity


def moved(axis: str, kind: str = "continuous") -> str:
    return robot(joint("j", kind, f'<axis xyz="{axis}"/>'))


@pytest.mark.parametrize("kind", ["revolute", "continuous", "prismatic", "planar"])
@pytest.mark.parametrize("axis", ["0 0 0", "0 0.0 -0", "0 0 1e-07"])
def test_an_axis_without_direction(kind: str, axis: str) -> None:
    (found,) = reported("JNT006", moved(axis, kind))
    assert found.severity is Severity.ERROR
    assert places("JNT006", moved(axis, kind)) == [(4, axis)]


def test_an_axis_without_xyz() -> None:
    text = robot(joint("j", "continuous", "<axis/>"))
    (found,) = reported("JNT006", text)
    assert found.severity is Severity.ERROR
    assert places("JNT006", text) == [(4, "<axis/>")]


@pytest.mark.parametrize(
    ("axis", "norm", "unit"),
    [
        ("0 0 2", "2", "0 0 1"),
        ("0 -3 0", "3", "0 -1 0"),
        ("1 1 0", "1.414", "0.7071067812 0.7071067812 0"),
        ("-0 0 0.5", "0.5", "0 0 1"),
        ("0 0 0.9899", "0.9899", "0 0 1"),
        ("0 0 0.001", "0.001", "0 0 1"),
        ("0 0.001 2", "2", "0 0.0004999999375 0.999999875"),
    ],
)
def test_an_axis_of_another_length(axis: str, norm: str, unit: str) -> None:
    (found,) = reported("JNT006", moved(axis))
    assert f" {norm}, not 1" in found.message
    assert found.severity is Severity.WARNING
    assert places("JNT006", moved(axis)) == [(4, axis)]
    assert f'<axis xyz="{unit}"/>' in fixed("JNT006", moved(axis))


@pytest.mark.parametrize(
    ("axis", "deviation", "suggested"),
    [
        ("0.0039668 0 -0.99999", "-z by 0.004", "0 0 -1"),
        ("0 -1 -4.37114e-08", "-y by 4.4e-08", "0 -1 0"),
        ("1 1e-3 1e-3", "x by 0.0014", "1 0 0"),
        ("-1 2e-09 0", "-x by 2e-09", "-1 0 0"),
    ],
)
def test_nearly_a_basis_vector(axis: str, deviation: str, suggested: str) -> None:
    (found,) = reported("JNT006", moved(axis))
    assert f"from {deviation} rad" in found.message
    assert found.severity is Severity.INFO
    assert places("JNT006", moved(axis)) == [(4, axis)]
    assert f'<axis xyz="{suggested}"/>' in fixed("JNT006", moved(axis))


@pytest.mark.parametrize(
    ("kind", "does"),
    [
        ("revolute", "about"),
        ("continuous", "about"),
        ("prismatic", "along"),
        ("planar", "across"),
    ],
)
def test_a_joint_that_moves_without_an_axis(kind: str, does: str) -> None:
    text = robot(joint("j", kind))
    (found,) = reported("JNT006", text)
    assert found.message == naming("j", "<axis>", does, "1 0 0")
    assert found.severity is Severity.INFO
    assert places("JNT006", text) == [(4, f'<joint name="j" type="{kind}">')]


@pytest.mark.parametrize(
    ("kind", "content"),
    [
        ("fixed", ""),
        ("floating", ""),
        ("revolute", '<axis xyz="0 0 1"/>'),
        ("revolute", '<axis xyz="0 0.707106 -0.707106"/>'),
        ("revolute", '<axis xyz="0.71 0.71 0"/>'),
        ("revolute", '<axis xyz="0.577 0.577 0.577"/>'),
        ("revolute", '<axis xyz="0 0 -0.99999"/>'),
        ("revolute", '<axis xyz="-2.220446049250313e-16 -0.9999999999999998 0.0"/>'),
        ("revolute", '<axis xyz="0 0.0069 1"/>'),
        ("planar", '<axis xyz="0 0.001 1"/>'),
        ("fixed", '<axis xyz="0 0 2"/>'),  # JNT020
        ("floating", '<axis xyz="0 0 0"/>'),
        ("revolute", '<axis xyz="0 0 x"/>'),  # URD005
        ("revolute", '<axis xyz="0 0"/>'),  # URD006
    ],
)
def test_no_finding(kind: str, content: str) -> None:
    assert reported("JNT006", robot(joint("j", kind, content))) == []


@pytest.mark.parametrize("axis", ["${2} 0 0", "0 ${0.001} 1"])
def test_the_result_of_an_expression_is_not_edited(axis: str) -> None:
    (found,) = reported("JNT006", of_xacro(moved(axis)), "robot.xacro")
    assert found.fix is None


def test_a_macro_is_fixed_once_for_all_of_its_calls() -> None:
    macro = joint("${name}", "continuous", '<axis xyz="0 0 2"/>')
    text = of_xacro(
        f'<xacro:macro name="wheel" params="name">{macro}</xacro:macro><link name="base"/>'
        '<xacro:wheel name="a"/><xacro:wheel name="b"/>'
    )
    (found,) = reported("JNT006", text, "robot.xacro")
    assert len(found.calls) == 2
    assert messages("JNT006", fixed("JNT006", text, "robot.xacro"), "robot.xacro") == []
