"""Messages that hid the defect: "has no <noise>" reads as if it were missing."""

from __future__ import annotations

from tests.gazebos import BASE, sensor
from tests.reported import reported


def test_an_element_that_is_ignored_is_not_said_to_be_missing() -> None:
    noise = "<imu><noise><type>gaussian</type></noise></imu>\n"
    (found,) = reported("GAZ003", BASE + sensor("imu", noise))
    assert found.message == "sensor 's': unknown element <noise> in <imu> (ignored)"
    assert "<angular_velocity>" in found.help
