from tests.naming import naming
from tests.reported import messages, places, reported

JOINT = '<joint name="{0}" type="fixed"><parent link="{1}"/><child link="{2}"/></joint>\n'
LINKS = '<link name="a"/><link name="b"/><link name="c"/>\n'


def test_every_further_joint_is_reported_with_the_first() -> None:
    robot = LINKS + JOINT.format("i", "a", "c") + JOINT.format("j", "b", "c")
    (found,) = reported("TRE004", robot)
    assert found.message == naming("c", "j", "i")
    assert places("TRE004", robot) == [(4, "c")]
    assert [(one.span.line, one.message) for one in found.related] == [(3, "joint 'i'")]


def test_two_joints_between_the_same_links() -> None:
    assert messages("TRE004", LINKS + "".join(JOINT.format(n, "a", "b") for n in "ijk")) == [
        naming("b", "j", "i"),
        naming("b", "k", "i"),
    ]


def test_the_same_joint_twice_is_another_finding() -> None:
    robot = LINKS + JOINT.format("j", "a", "b") * 2
    assert reported("TRE004", robot) == []
    assert len(reported("NAM001", robot)) == 1


def test_one_joint_for_each_child() -> None:
    assert (
        reported("TRE004", LINKS + JOINT.format("i", "a", "b") + JOINT.format("j", "a", "c")) == []
    )
