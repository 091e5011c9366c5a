import pytest

from tests.jointed import joint, limit, mimic, robot
from tests.naming import naming
from tests.reported import messages, places, reported


def pair(leading: tuple[str, str], own: tuple[str, str], rest: str, kind: str = "revolute") -> str:
    return robot(
        joint("a", kind, limit(*leading)),
        joint("b", kind, limit(*own) + mimic("a", rest)),
    )


@pytest.mark.parametrize(
    ("leading", "own", "rest", "taken"),
    [
        (("0", "0.8"), ("0", "0.8757"), 'multiplier="-1"', "[-0.8, 0] rad"),
        (("-0.1", "0.6"), ("0", "0.8"), 'multiplier="1.6"', "[-0.16, 0.96] rad"),
        (("0", "1"), ("0", "1"), 'offset="0.5"', "[0.5, 1.5] rad"),
        (("-1", "1"), ("-1", "1"), 'multiplier="-1.05"', "[-1.05, 1.05] rad"),
        (("1", "1"), ("2", "3"), "", "[1, 1] rad"),
    ],
)
def test_a_follower_beyond_its_limits(
    leading: tuple[str, str], own: tuple[str, str], rest: str, taken: str
) -> None:
    text = pair(leading, own, rest)
    assert messages("JNT016", text) == [naming("b", "a", taken, f"[{own[0]}, {own[1]}]")]
    is_multiplier = rest.startswith("multiplier")
    place = rest.split('"')[1] if is_multiplier else f'<mimic joint="a" {rest}/>'
    assert places("JNT016", text) == [(6, place)]


def test_the_unit_of_a_prismatic_joint() -> None:
    (message,) = messages("JNT016", pair(("0", "0.1"), ("0", "0.05"), "", "prismatic"))
    assert message == naming("b", "a", "[0, 0.1] m", "[0, 0.05]")


def test_a_sign_that_would_do_is_reported() -> None:
    (found,) = reported("JNT016", pair(("0", "0.8"), ("-0.8", "0"), ""))
    assert found.help == naming("right", 'lower="0"', 'upper="0.8"', "-1")
    (found,) = reported("JNT016", pair(("0", "0.8"), ("0", "0.5"), ""))
    assert found.help == naming("multiplier")


@pytest.mark.parametrize(
    ("leading", "own", "rest"),
    [
        (("0", "0.8"), ("0", "0.8"), ""),
        (("0", "0.8"), ("-2", "2"), 'multiplier="-2"'),
        (("0", "0.58291"), ("0", "0.28833"), 'multiplier="0.5"'),  # rounded by 1 %
        (("0", "1"), ("0", "0"), ""),  # JNT003
        (("0", "1"), ("1", "-1"), ""),  # JNT003
        (("1", "-1"), ("0", "0.1"), ""),  # JNT003
    ],
)
def test_no_finding(leading: tuple[str, str], own: tuple[str, str], rest: str) -> None:
    assert reported("JNT016", pair(leading, own, rest)) == []


def test_joints_without_end() -> None:
    tight = limit("-0.1", "0.1") + mimic("a")
    for leader in (joint("a", "continuous"), joint("a", "fixed"), ""):
        assert reported("JNT016", robot(leader, joint("b", "revolute", tight))) == []
    free = joint("b", "continuous", mimic("a"))
    assert reported("JNT016", robot(joint("a", "revolute", limit("-9", "9")), free)) == []


def test_a_joint_that_mimics_itself_is_left_to_its_own_rule() -> None:
    own = limit("0", "1") + mimic("a", 'multiplier="5"')
    assert reported("JNT016", robot(joint("a", "revolute", own))) == []
