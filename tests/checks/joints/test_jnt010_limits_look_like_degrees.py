from __future__ import annotations

from math import radians

import pytest

from tests.jointed import joint, limit, of_xacro, robot
from tests.reported import fixed, messages, places, reported
from urdfkit.text.diagnostic import Confidence


@pytest.mark.parametrize(
    ("lower", "upper", "turns"),
    [
        ("-180", "180", "28.6"),
        ("-90", "90", "14.3"),
        ("0", "45.0", "7.2"),
        ("-1", "135", "21.5"),
        ("-360", "360", "57.3"),
    ],
)
def test_an_angle_that_has_a_name(lower: str, upper: str, turns: str) -> None:
    text = robot(joint("j", "revolute", limit(lower, upper)))
    (found,) = reported("JNT010", text)
    assert found.message == (
        f"joint 'j' may turn from {float(lower):g} to {float(upper):g} rad, {turns} times round; "
        "that looks like degrees"
    )
    assert found.confidence is Confidence.INFERRED
    assert places("JNT010", text) == [(4, limit(lower, upper))]
    mended = fixed("JNT010", text)
    ends = [f"{radians(float(end)):.10g}" for end in (lower, upper)]
    assert limit(*(end if end != "0" else "0" for end in ends)) in mended
    assert reported("JNT010", mended) == []


def test_ranges_that_differ_from_joint_to_joint() -> None:
    text = robot(
        joint("a", "revolute", limit("-170", "170")), joint("b", "revolute", limit("-120", "65"))
    )
    assert [message.partition(" may")[0] for message in messages("JNT010", text)] == [
        "joint 'a'",
        "joint 'b'",
    ]


def test_one_end_in_degrees() -> None:
    others = [joint(name, "revolute", limit("-1.7", "2.4")) for name in "ab"]
    for lower, upper in (("-94", "4.69"), ("-3.1", "180")):
        text = robot(*others, joint("j", "revolute", limit(lower, upper)))
        (message,) = messages("JNT010", text)
        assert message.endswith("that looks like degrees, or lacks a decimal point")
        assert limit(lower, upper) in fixed("JNT010", text)
    assert messages("JNT010", robot(*others, joint("j", "revolute", limit("-3.1", "100")))) == []


@pytest.mark.parametrize(
    ("lower", "upper"),
    [
        ("-6.28", "6.28"),
        ("-6.9813", "6.9813"),  # an IRB 1600
        ("-7", "7"),
        ("-9.42477796077", "9.42477796077"),  # an ANYmal
        ("-10", "10"),  # a Solo
        ("-12", "12"),
        ("-100", "100"),
        ("-50", "50"),
        ("0", "1000"),
        ("-999999", "999999"),  # a Fetch
        ("-1e+16", "1e+16"),  # an Iris
        ("-174.532925", "174.532925"),  # a Jaco
        ("-31.4", "31.4"),
        ("90", "-90"),  # JNT003
        ("90", "90"),  # JNT004
    ],
)
def test_limits_of_real_robots_in_radians(lower: str, upper: str) -> None:
    assert reported("JNT010", robot(joint("j", "revolute", limit(lower, upper)))) == []


def test_round_numbers_alone_are_no_evidence() -> None:
    free = [joint(f"j{size}", "revolute", limit(f"-{size}", f"{size}")) for size in (50, 100, 300)]
    assert reported("JNT010", robot(*free)) == []
    assert reported("JNT010", robot(*free, joint("a", "revolute", limit("-33", "33")))) == []
    assert len(reported("JNT010", robot(*free, joint("a", "revolute", limit("-65", "20"))))) == 4


@pytest.mark.parametrize("kind", ["prismatic", "continuous", "fixed"])
def test_only_revolute_joints_have_angles_for_limits(kind: str) -> None:
    assert reported("JNT010", robot(joint("j", kind, limit("-90", "90")))) == []


def test_what_an_expression_gave_is_not_edited() -> None:
    text = of_xacro(robot(joint("j", "revolute", limit("${-90}", "90"))))
    assert [found.fix for found in reported("JNT010", text, "robot.xacro")] == [None]
    right = of_xacro(robot(joint("j", "revolute", limit("${radians(-90)}", "${pi/2}"))))
    assert reported("JNT010", right, "robot.xacro") == []


def test_one_joint_in_degrees_among_others_in_radians() -> None:
    small = [joint(f"j{n}", "revolute", limit("-2", "2")) for n in range(2)]
    odd = joint("odd", "revolute", limit("-137", "137"))
    assert len(messages("JNT010", robot(*small, odd))) == 1
    assert messages("JNT010", robot(odd)) == []
    free = joint("free", "revolute", limit("-100", "100"))
    assert messages("JNT010", robot(*small, free)) == []
