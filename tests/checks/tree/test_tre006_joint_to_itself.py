from __future__ import annotations

from tests.reported import messages, places, reported

JOINT = (
    '<link name="a"/><link name="b"/>\n'
    '<joint name="j" type="fixed"><parent link="{}"/><child link="{}"/></joint>'
)


def test_the_child_is_the_place() -> None:
    robot = JOINT.format("a", "a")
    assert messages("TRE006", robot) == ["joint 'j' has link 'a' as parent and as child"]
    assert places("TRE006", robot) == [(3, "a")]
    assert reported("TRE003", robot) == reported("TRE004", robot) == [], "one defect is one finding"


def test_two_links_are_right() -> None:
    assert reported("TRE006", JOINT.format("a", "b")) == []


def test_a_joint_without_ends_is_told_elsewhere() -> None:
    for end in ('<parent link="a"/>', '<child link="a"/>', ""):
        assert (
            reported("TRE006", f'<link name="a"/><joint name="j" type="fixed">{end}</joint>') == []
        )
