import pytest

from tests.jointed import joint, limit, mimic, robot
from tests.naming import naming
from tests.reported import messages, places, reported


@pytest.mark.parametrize(
    ("kind", "lower", "upper", "unit"),
    [
        ("revolute", "0.5", "2.5", "rad"),
        ("revolute", "-2.77", "-0.54", "rad"),
        ("prismatic", "0.1", "0.2", "m"),
        ("revolute", "-1.54462", "-0.0349066", "rad"),  # the elbow of a NAO
    ],
)
def test_0_is_outside(kind: str, lower: str, upper: str, unit: str) -> None:
    text = robot(joint("j", kind, limit(lower, upper)))
    assert messages("JNT019", text) == [
        naming("j", "position", "0", "outside", f"[{lower}, {upper}] {unit}")
    ]
    assert places("JNT019", text) == [(4, limit(lower, upper))]


def test_all_joints_are_one_finding() -> None:
    legs = [joint(name, "revolute", limit("-2", "-1")) for name in "abcd"]
    (found,) = reported("JNT019", robot(*legs))
    assert found.message == naming("a", "b", "2", "position", "0", "outside", "[-2, -1] rad")
    assert [other.span.line for other in found.related] == [6, 8, 10]


@pytest.mark.parametrize(
    ("kind", "content"),
    [
        ("revolute", limit("-1", "1")),
        ("revolute", limit("0", "1")),
        ("revolute", limit("0.00872665", "1.64934")),  # a margin of half a degree
        ("revolute", limit("0.5", "0.5")),  # JNT003
        ("revolute", limit("2", "1")),  # JNT003
        ("continuous", limit("1", "2")),  # JNT020
        ("revolute", limit("1", "2") + mimic("b")),
    ],
)
def test_no_finding(kind: str, content: str) -> None:
    assert reported("JNT019", robot(joint("a", kind, content), joint("b", "continuous"))) == []
