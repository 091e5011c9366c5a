"""RCT032: see the rule."""

import pytest

from tests.controls import CLASSIC, GZ, MOCK, ROBOT, control
from tests.reported import fixed, messages, reported

IMU = '<sensor name="{}"><state_interface name="orientation.x"/></sensor>'
GAZEBO = '<gazebo reference="swing_link"><sensor name="base_imu" type="imu"/></gazebo>'


@pytest.mark.parametrize("hardware", [GZ, CLASSIC])
def test_a_sensor_that_gazebo_does_not_have(hardware: str) -> None:
    text = ROBOT + control(IMU.format("base_immu"), plugin=hardware) + GAZEBO
    assert messages("RCT032", text) == [
        (
            "sensor 'base_immu' of ros2_control: no <sensor> of <gazebo> has that name; did you "
            "mean 'base_imu'?"
        )
    ]
    assert '<sensor name="base_imu"><state' in fixed("RCT032", text)


def test_others_are_calm() -> None:
    assert reported("RCT032", ROBOT + control(IMU.format("base_imu"), plugin=GZ) + GAZEBO) == []
    assert reported("RCT032", ROBOT + control(IMU.format("own"), plugin=MOCK) + GAZEBO) == []
