"""Messages that hid the defect: "has no <noise>" reads as if it were missing."""

from __future__ import annotations

from tests.gazebos import BASE, sensor
from tests.reported import reported
from urdfkit.core.suggest import nearest
from urdfkit.text.xml_errors import syntax_mistakes


def test_an_element_that_is_ignored_is_not_said_to_be_missing() -> None:
    noise = "<imu><noise><type>gaussian</type></noise></imu>\n"
    (found,) = reported("GAZ003", BASE + sensor("imu", noise))
    assert found.message == "sensor 's': unknown element <noise> in <imu> (ignored)"
    assert "<angular_velocity>" in found.help


def test_suggestions_are_not_alike_for_their_last_word() -> None:
    """UR3's SRDF: `upper_arm_link` for `gripper_base_link`; Kinova's meshes."""
    assert nearest("gripper_base_link", ["upper_arm_link", "wrist_link"]) is None
    meshes = ["base_link", "bicep_link", "bracelet_no_vision_link"]
    assert nearest("bracelet_link", meshes) == "bracelet_no_vision_link"
    assert nearest("whel_link", ["base_link", "wheel_link"]) == "wheel_link"


def test_a_macro_that_is_closed_in_its_first_line() -> None:
    body = b'<link name="a"><visual/></link>' * 100
    data = b'<robot><macro name="m" params="x"/>' + body + b"</macro></robot>"
    (mistake,) = syntax_mistakes(data)
    assert [note for _, _, note in mistake.notes] == [
        "<macro .../> closes itself: its '/' is one too many"
    ]
