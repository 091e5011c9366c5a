import pytest

from tests.jointed import joint, limit, of_xacro, robot
from tests.naming import naming
from tests.reported import fixed, messages, places, reported


@pytest.mark.parametrize(
    ("content", "shown", "corrected"),
    [
        (
            limit("-6.28", "6.28"),
            ['lower="-6.28"', 'upper="6.28"'],
            '<limit effort="10" velocity="1"/>',
        ),
        (
            '<limit effort="1" upper="0"\n  velocity="2"\n  lower = "0"/>',
            ['upper="0"', 'lower="0"'],
            '<limit effort="1"\n  velocity="2"/>',
        ),
        ('<limit effort="1" velocity="2" upper="7"/>', ['upper="7"'], None),
        ('<limit effort="1" velocity="2" lower="0" upper="0"/>', ['lower="0"', 'upper="0"'], None),
        ("<limit  upper='x' effort='1' velocity='2' />", ['upper="x"'], None),
    ],
)
def test_limits_without_effect(content: str, shown: list[str], corrected: str | None) -> None:
    text = robot(joint("j", "continuous", content))
    assert messages("JNT020", text) == [naming("j", "continuous", *shown, "Drake")]
    after = fixed("JNT020", text)
    assert reported("JNT020", after) == []
    if corrected:
        assert corrected in after


@pytest.mark.parametrize(
    ("ends", "severity"), [("3.14", "info"), ("3.13", "warning"), ("0", "info")]
)
def test_less_than_a_turn_narrows(ends: str, severity: str) -> None:
    (found,) = reported("JNT020", robot(joint("j", "continuous", limit(f"-{ends}", ends))))
    assert found.severity.value == severity
    assert (found.fix is None) == (severity == "warning")  # it may be revolute


def test_the_place_is_the_first_of_the_two() -> None:
    assert places("JNT020", robot(joint("j", "continuous", limit("-3", "4")))) == [(4, "-3")]


@pytest.mark.parametrize(
    ("kind", "content"),
    [
        ("continuous", '<limit effort="1" velocity="1"/>'),
        ("continuous", ""),
        ("revolute", limit("-1", "1")),
    ],
)
def test_no_finding(kind: str, content: str) -> None:
    assert reported("JNT020", robot(joint("j", kind, content))) == []


def test_another_call_of_a_macro_may_need_the_limits() -> None:
    macro = joint("${kind}", "${kind}", limit("-1", "1"))
    text = of_xacro(
        f'<xacro:macro name="arm" params="kind">{macro}</xacro:macro><link name="base"/>'
        '<xacro:arm kind="revolute"/><xacro:arm kind="continuous"/>'
    )
    assert [found.fix for found in reported("JNT020", text, "robot.xacro")] == [None]


def test_outside_of_macros_a_xacro_is_fixed() -> None:
    text = of_xacro(robot(joint("j", "continuous", limit("${-2*pi}", "3"))))
    corrected = fixed("JNT020", text, "robot.xacro")
    assert '<limit effort="10" velocity="1"/>' in corrected
