from tests.naming import naming
from tests.reported import messages, places, reported

JOINT = '<joint name="{0}_{1}" type="fixed"><parent link="{0}"/>\n<child link="{1}"/></joint>\n'


def robot(links: str, *joints: str) -> str:
    return "".join(f'<link name="{name}"/>' for name in links.split()) + "".join(
        JOINT.format(*joint.split()) for joint in joints
    )


def test_the_loop_is_printed_and_its_other_joints_are_shown() -> None:
    (found,) = reported("TRE003", robot("a b c", "a b", "b c", "c a"))
    assert found.message == naming("3", "a -> b -> c -> a")
    assert found.span.text == "a"
    assert [one.message for one in found.related] == ["joint 'a_b'", "joint 'b_c'"]


def test_a_loop_that_hangs_on_the_robot() -> None:
    model = robot("root a b", "root a", "a b", "b a")
    assert messages("TRE003", model) == [naming("2", "a -> b -> a")]
    assert places("TRE003", model) == [(7, "a")]


def test_a_loop_that_has_no_parent() -> None:
    assert len(reported("TRE003", robot("root a b", "a b", "b a"))) == 1


def test_two_loops_are_two_findings() -> None:
    assert messages("TRE003", robot("a b c d", "a b", "b a", "c d", "d c")) == [
        naming("2", "a -> b -> a"),
        naming("2", "c -> d -> c"),
    ]


def test_a_long_loop_is_shortened() -> None:
    names = [f"l{number}" for number in range(50)]
    model = robot(" ".join(names), *map(" ".join, zip(names, names[1:] + names[:1], strict=True)))
    assert messages("TRE003", model) == [
        naming("50", "l0", "l1", "l2", "l3", "l4", "l5", "l6", "l7", "42", "l0")
    ]


def test_a_loop_of_eight_is_named_whole() -> None:
    names = [f"l{number}" for number in range(8)]
    model = robot(" ".join(names), *map(" ".join, zip(names, names[1:] + names[:1], strict=True)))
    (message,) = messages("TRE003", model)
    assert message.endswith("l6 -> l7 -> l0")


def test_two_ways_to_one_link_are_another_finding() -> None:
    assert reported("TRE003", robot("a b c d", "a b", "a c", "b d", "c d")) == []  # TRE004


def test_a_joint_to_itself_is_reported_once() -> None:
    model = robot("a b", "a a", "a b")
    assert messages("TRE003", model) == [naming("a_a", "a")]
    assert places("TRE003", model) == [(3, "a")]
    assert reported("TRE004", model) == []


def test_a_joint_without_ends_is_reported_elsewhere() -> None:
    for end in ('<parent link="a"/>', '<child link="a"/>', ""):
        assert not reported("TRE003", f'<link name="a"/><joint name="j" type="fixed">{end}</joint>')


def test_a_loop_through_a_link_that_is_there_twice_is_a_consequence() -> None:
    """The platform and the arm both have a `base_link`: NAM001 says it."""
    assert reported("TRE003", robot("a b a", "a b", "b a")) == []
    assert len(reported("TRE003", robot("a b c c", "a b", "b a"))) == 1
