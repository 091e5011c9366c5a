"""GAZ062: see the rule."""

from tests.gazebos import BASE, BODY, child, sensor
from tests.reported import messages, reported

ROBOT = BASE + child("tip", inside=BODY)


def test_forces_are_measured_in_a_joint() -> None:
    (found,) = reported("GAZ062", ROBOT + sensor("force_torque", "", "tip"))
    assert found.message == (
        "sensor 's' of type 'force_torque' is given to link 'tip': it measures in a joint"
    )
    assert found.help == 'write reference="tip_joint"'


def test_pictures_are_taken_from_a_link() -> None:
    assert messages("GAZ062", ROBOT + sensor("camera", "", "tip_joint")) == [
        "sensor 's' of type 'camera' is given to joint 'tip_joint', and belongs to a link"
    ]


def test_where_they_belong_they_are_calm() -> None:
    assert messages("GAZ062", ROBOT + sensor("force_torque", "", "tip_joint")) == []
    assert messages("GAZ062", ROBOT + sensor("camera", "", "tip")) == []
    assert messages("GAZ062", ROBOT + sensor("of_ours", "", "tip_joint")) == []
