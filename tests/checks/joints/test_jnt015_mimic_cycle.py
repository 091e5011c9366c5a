from __future__ import annotations

from tests.jointed import joint, mimic, robot
from tests.reported import messages, places, reported


def following(**leaders: str) -> str:
    joints = [
        joint(name, "continuous", mimic(leader) if leader else "")
        for name, leader in leaders.items()
    ]
    return robot(*joints)


def test_two_joints() -> None:
    text = following(a="b", b="a")
    assert messages("JNT015", text) == ["joints mimic one another: 'a' -> 'b' -> 'a'"]
    assert places("JNT015", text) == [(4, "b")]
    assert [other.message for other in reported("JNT015", text)[0].related] == ["joint 'b'"]


def test_who_follows_a_circle_is_not_in_it() -> None:
    text = following(x="a", a="b", b="c", c="a", y="x")
    assert messages("JNT015", text) == ["joints mimic one another: 'a' -> 'b' -> 'c' -> 'a'"]


def test_every_circle_once() -> None:
    text = following(a="b", b="a", c="d", d="c")
    assert len(messages("JNT015", text)) == 2


def test_no_circle() -> None:
    assert reported("JNT015", following(a="b", b="c", c="")) == []
    assert reported("JNT015", following(a="a", b="a")) == []  # JNT014
    assert reported("JNT015", following(a="z")) == []  # REF004


def test_a_long_circle_is_named_in_part() -> None:
    count = 20_000
    names = {f"j{number}": f"j{(number + 1) % count}" for number in range(count)}
    (found,) = reported("JNT015", following(**names))
    assert found.message == (
        "joints mimic one another: 'j0' -> 'j1' -> 'j2' -> 'j3' -> 'j4' -> 'j5' -> 19994 more "
        "-> 'j0'"
    )
    assert len(found.related) == 20
