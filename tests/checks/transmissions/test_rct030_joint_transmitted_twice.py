"""RCT030: see the rule."""

from tests.controls import NEXT, ROBOT, transmission
from tests.reported import messages, places, reported

FIRST = transmission("swing")


def test_a_copy_in_which_one_name_was_forgotten() -> None:
    text = ROBOT + FIRST + transmission("swing").replace('name="t"', 'name="u"')
    assert messages("RCT030", text) == ["joint 'swing' has a transmission already"]
    assert places("RCT030", text) == [(NEXT + 3, "swing")]
    (found,) = reported("RCT030", text)
    assert [note.span.line for note in found.related] == [NEXT + 1]


def test_two_transmissions_of_one_name() -> None:
    text = ROBOT + FIRST + transmission("slide")
    assert messages("RCT030", text) == ["a second transmission is called 't'"]


def test_a_joint_that_is_moved_in_two_ways() -> None:
    other = transmission("swing", "hardware_interface/PositionJointInterface")
    assert reported("RCT030", ROBOT + FIRST + other.replace('name="t"', 'name="u"')) == []


def test_other_robots_are_calm() -> None:
    assert reported("RCT030", ROBOT + FIRST) == []
    assert reported("RCT030", ROBOT + FIRST + FIRST, targets=("ros2",)) == []
