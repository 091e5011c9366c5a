import pytest

from tests.jointed import joint, mimic, robot
from tests.naming import naming
from tests.reported import messages, places, reported
from urdfkit.text.diagnostic import Severity


def following(**leaders: str) -> str:
    joints = [
        joint(name, "continuous", mimic(leader) if leader else "")
        for name, leader in leaders.items()
    ]
    return robot(*joints)


def test_two_joints() -> None:
    text = following(a="b", b="a")
    (found,) = reported("JNT015", text)
    assert found.message.endswith("'a' -> 'b' -> 'a'")
    assert found.severity is Severity.ERROR
    assert places("JNT015", text) == [(4, "b")]
    assert [other.message for other in found.related] == ["joint 'b'"]


def test_a_follower_of_a_cycle_is_not_in_it() -> None:
    (message,) = messages("JNT015", following(x="a", a="b", b="c", c="a", y="x"))
    assert message == naming("a", "b", "c", "a")


def test_every_cycle_once() -> None:
    assert len(messages("JNT015", following(a="b", b="a", c="d", d="c"))) == 2


def test_a_joint_that_mimics_itself() -> None:
    text = robot(joint("j", "continuous", mimic("j")))
    assert messages("JNT015", text) == [naming("j")]
    assert places("JNT015", text) == [(4, "j")]
    assert len(reported("JNT015", following(a="a", b="a"))) == 1
    assert len(reported("JNT015", robot(joint("a", "fixed", mimic("a"))))) == 1


@pytest.mark.parametrize(
    "text",
    [
        following(a="b", b="c", c=""),
        following(a="z"),  # REF001
        robot(joint("j", "continuous", "<mimic/>"), joint("k", "continuous")),
        robot(joint("", "continuous", mimic("")), joint("k", "continuous")),
    ],
)
def test_no_cycle(text: str) -> None:
    assert reported("JNT015", text) == []


def test_a_long_cycle_is_named_in_part() -> None:
    count = 2_000
    names = {f"j{number}": f"j{(number + 1) % count}" for number in range(count)}
    (found,) = reported("JNT015", following(**names))
    assert found.message.endswith(" -> 'j5' -> 1994 more -> 'j0'")
    assert len(found.related) == 20


@pytest.mark.parametrize("kind", ["fixed", "floating", "planar"])
def test_a_leader_without_a_position(kind: str) -> None:
    text = robot(joint("a", kind), joint("b", "continuous", mimic("a")))
    (found,) = reported("JNT015", text)
    assert (found.message, found.severity) == (
        naming("b", "<mimic>", "a", kind),
        Severity.WARNING,
    )
    assert places("JNT015", text) == [(6, mimic("a"))]


def test_all_followers_of_a_leader_are_one_finding() -> None:
    followers = [joint(name, "continuous", mimic("a")) for name in "bcd"]
    (found,) = reported("JNT015", robot(joint("a", "fixed"), *followers))
    assert found.message == naming("b", "c", "1", "<mimic>", "a", "fixed")


@pytest.mark.parametrize("kind", ["revolute", "continuous", "prismatic", "screw"])
def test_a_leader_that_moves(kind: str) -> None:
    assert reported("JNT015", robot(joint("a", kind), joint("b", "continuous", mimic("a")))) == []


def test_drake_rejects_a_fixed_joint_that_follows() -> None:
    text = robot(joint("a", "continuous"), joint("b", "fixed", mimic("a")))
    assert reported("JNT015", text) == []
    (found,) = reported("JNT015", text, targets=("drake",))
    assert (found.severity, found.message) == (
        Severity.ERROR,
        naming("b", "<mimic>", "fixed"),
    )


@pytest.mark.parametrize(
    ("rest", "count"),
    [
        ('multiplier="0"', 1),
        ('multiplier="0.0"', 1),
        ("", 0),
        ('multiplier="-1"', 0),
        ('offset="0"', 0),
    ],
)
def test_multiplier_zero(rest: str, count: int) -> None:
    """A fixed joint, as in the qb hand of Halodi's EVE, stays where it is with any multiplier."""
    found = reported(
        "JNT015", robot(joint("j", "continuous"), joint("f", "continuous", mimic("j", rest)))
    )
    assert [one.severity for one in found] == [Severity.WARNING] * count
    assert [one.span.text for one in found] == [rest[12:-1]] * count
    assert (
        messages("JNT015", robot(joint("j", "continuous"), joint("f", "fixed", mimic("j", rest))))
        == []
    )
