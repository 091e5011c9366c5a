import pytest

from tests.jointed import joint, limit, robot
from tests.naming import naming
from tests.reported import messages, places, reported

BOTH = 'soft_lower_limit="{}" soft_upper_limit="{}"'


def safe(name: str, soft: str, kind: str = "revolute", hard: tuple[str, str] = ("-1", "2")) -> str:
    return joint(name, kind, limit(*hard) + f"<safety_controller {soft}/>")


@pytest.mark.parametrize(
    ("lower", "upper"), [("-1.1", "1.9"), ("-0.9", "2.1"), ("-11", "12"), ("-1.001", "2")]
)
def test_soft_limits_beyond_the_limits(lower: str, upper: str) -> None:
    soft = BOTH.format(lower, upper)
    text = robot(safe("j", soft))
    assert messages("JNT019", text) == [naming("j", f"[{lower}, {upper}] rad", "[-1, 2]")]
    assert places("JNT019", text) == [(4, f"<safety_controller {soft}/>")]


@pytest.mark.parametrize(
    ("soft", "shown"),
    [
        ("", ["[0, 0] rad", "soft_lower_limit", "soft_upper_limit"]),
        ('soft_upper_limit="-0.5"', ["[0, -0.5] rad", "soft_lower_limit"]),
        (BOTH.format("0", "0"), ["[0, 0] rad"]),
        (BOTH.format("1.9", "-0.9"), ["[1.9, -0.9] rad"]),
        (BOTH.format("3", "4"), ["[3, 4] rad"]),
        (BOTH.format("-4", "-1"), ["[-4, -1] rad"]),
    ],
)
def test_no_range_within_the_limits(soft: str, shown: list[str]) -> None:
    text = robot(safe("j", soft))
    assert messages("JNT019", text) == [naming("j", *shown)]
    assert places("JNT019", text) == [(4, f"<safety_controller {soft}/>")]


@pytest.mark.parametrize("soft", ["", BOTH.format("-11", "12")])
def test_all_joints_with_one_defect_are_one_finding(soft: str) -> None:
    (found,) = reported("JNT019", robot(*(safe(name, soft, "prismatic") for name in "abc")))
    assert found.message.startswith("joints 'a', 'b' and 1 more: ")
    assert [other.span.line for other in found.related] == [6, 8]


def test_two_defects_are_two_findings() -> None:
    text = robot(safe("a", ""), safe("b", BOTH.format("-9", "9")))
    assert sorted(line for line, _ in places("JNT019", text)) == [4, 6]


@pytest.mark.parametrize(
    "joints",
    [
        safe("j", BOTH.format("-0.9", "1.9")),
        safe("j", BOTH.format("-1", "2")),
        safe("j", 'soft_lower_limit="-0.9"'),
        safe("j", BOTH.format("-0.9", "x")),  # URD005
        safe("j", BOTH.format("-11", "12"), "continuous"),
        safe("j", "", "continuous"),
        safe("j", "", hard=("0", "0")),  # JNT003
        joint("j", "revolute", limit("-1", "2")),
    ],
)
def test_soft_limits_within_the_limits(joints: str) -> None:
    assert reported("JNT019", robot(joints)) == []


@pytest.mark.parametrize(("kind", "unit"), [("revolute", "rad"), ("prismatic", "m")])
def test_calibration_outside_the_limits(kind: str, unit: str) -> None:
    marks = '<calibration rising="1.6" falling="-2"/>'
    text = robot(joint("j", kind, limit("-1.5", "1.5") + marks))
    assert messages("JNT019", text) == [
        naming("j", f"1.6 {unit}", "outside", "[-1.5, 1.5]"),
        naming("j", f"-2 {unit}", "outside", "[-1.5, 1.5]"),
    ]
    assert places("JNT019", text) == [(4, "1.6"), (4, "-2")]


@pytest.mark.parametrize(
    ("kind", "content"),
    [
        ("revolute", limit("-1.5", "1.5") + '<calibration rising="1.5" falling="0"/>'),
        ("revolute", limit("-1.5", "1.5") + '<calibration rising="1.5029"/>'),
        ("revolute", limit("-1.5", "1.5") + '<calibration rising="x"/>'),  # URD005
        ("revolute", limit("-1.5", "1.5") + '<calibration reference_position="9"/>'),
        ("revolute", limit("0", "0") + '<calibration rising="1"/>'),  # JNT003
        ("continuous", '<calibration rising="9"/>'),
        ("fixed", '<calibration rising="9"/>'),
    ],
)
def test_calibration_within_the_limits(kind: str, content: str) -> None:
    assert reported("JNT019", robot(joint("j", kind, content))) == []
