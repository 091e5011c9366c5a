from __future__ import annotations

from tests.gazebos import BASE, plugin, sensor
from tests.reported import fixed, messages, reported

MOVE = "libgazebo_ros_planar_move.so"
TEXT = BASE + plugin(MOVE, "<robotBaseFrme>base</robotBaseFrme><odometryFrame>o</odometryFrame>")


def test_a_slip_is_mended() -> None:
    assert messages("GAZ032", TEXT) == [f"plugin 'p' ({MOVE}) does not read <robotBaseFrme>"]
    assert "<robotBaseFrame>base</robotBaseFrame>" in fixed("GAZ032", TEXT)


def test_a_tag_that_is_there_already_is_not_meant() -> None:
    text = TEXT.replace("<odometryFrame>", "<robotBaseFrame>base</robotBaseFrame><odometryFrame>")
    assert reported("GAZ032", text) == []


def test_left_is_no_slip_of_right() -> None:
    tags = "<frontLeftJoint>a</frontLeftJoint>"
    assert reported("GAZ032", BASE + plugin("libgazebo_ros_diff_drive.so", tags)) == []


def test_a_tag_of_another_meaning_is_not_made_active() -> None:
    """Taken for <hackBaseline>, it would move the second camera of a stereo pair."""
    camera = '<plugin name="c" filename="libgazebo_ros_camera.so"><{0}>0.2</{0}></plugin>'
    for tag, suggested in (("baseline", []), ("hackBaselin", ["did you mean <hackBaseline>?"])):
        text = BASE + sensor("camera", camera.format(tag))
        assert [found.help for found in reported("GAZ032", text)] == suggested


def test_other_generations_and_vendors() -> None:
    text = BASE + plugin(MOVE, "<odometryFrame>o</odometryFrame>")
    assert reported("GAZ032", text, targets=("classic-ros2",)) == []
    assert reported("GAZ032", TEXT.replace(MOVE, "libvendor.so")) == []
