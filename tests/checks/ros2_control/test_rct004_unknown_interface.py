from __future__ import annotations

import pytest

from tests.controls import CLASSIC, GZ, NEXT, ROBOT, control, driven, plugin, transmission
from tests.reported import messages, places, reported


def test_a_slip() -> None:
    text = ROBOT + control(driven("swing", "velocty", "efort"))
    assert messages("RCT004", text) == [
        "joint 'swing': command interface 'velocty' is nearly 'velocity'",
        "joint 'swing': state interface 'efort' is nearly 'effort'",
    ]
    assert places("RCT004", text) == [(NEXT + 2, "velocty"), (NEXT + 2, "efort")]


@pytest.mark.parametrize(
    "name",
    "position velocity effort acceleration torque pid_gain position_pid velocity_scaling x".split(),
)
def test_names_that_hardware_and_controller_agree_on(name: str) -> None:
    assert reported("RCT004", ROBOT + control(driven("swing", name, name))) == []


def test_gazebo_has_three_and_classic_five() -> None:
    found = messages("RCT004", ROBOT + control(driven("swing", "position_pid"), plugin=GZ))
    assert found == [
        (
            "joint 'swing': command interface 'position_pid' is none that "
            "gz_ros2_control/GazeboSimSystem has (position, velocity, effort)"
        )
    ]
    assert (
        reported("RCT004", ROBOT + control(driven("swing", "position_pid"), plugin=CLASSIC)) == []
    )
    assert messages("RCT004", ROBOT + control(driven("swing", state="torque"), plugin=CLASSIC)) == [
        (
            "joint 'swing': state interface 'torque' is none that "
            "gazebo_ros2_control/GazeboSystem has (position, velocity, effort)"
        )
    ]


def test_sensors_and_gpios() -> None:
    sensor = '<sensor name="imu"><state_interface name="{}"/></sensor>'
    assert messages("RCT004", ROBOT + control(sensor.format("orientation_x"), plugin=GZ)) == [
        "sensor 'imu': state interface 'orientation_x' is nearly 'orientation.x'"
    ]
    assert messages("RCT004", ROBOT + control(sensor.format("linear_accel.x"), plugin=GZ)) == [
        (
            "sensor 'imu': state interface 'linear_accel.x' is none that "
            "gz_ros2_control/GazeboSimSystem has (such as orientation.x)"
        )
    ]
    for name in ("orientation.x", "force.z", "ft.torque.x", "temperature", "positon"):
        assert reported("RCT004", ROBOT + control(sensor.format(name))) == []
    gpio = '<gpio name="g"><command_interface name="positon"/></gpio>'
    assert reported("RCT004", ROBOT + control(gpio)) == []


def test_hardware_interfaces_of_ros1() -> None:
    mistake = ROBOT + transmission("swing", "hardware_interface/EffortJointInterfce")
    assert messages("RCT004", mistake) == [
        (
            "joint 'swing': hardware interface 'hardware_interface/EffortJointInterfce' is nearly "
            "'hardware_interface/EffortJointInterface'"
        )
    ]
    assert reported("RCT004", mistake, targets=("ros2",)) == []
    for name in ("VelocityJointInterface", "hardware_interface/PosVelJointInterface", "my/Own"):
        assert reported("RCT004", ROBOT + transmission("swing", name)) == []


def test_gazebo_of_ros1_knows_three() -> None:
    text = ROBOT + transmission("swing", "hardware_interface/PosVelJointInterface")
    (message,) = messages("RCT004", text + plugin("libgazebo_ros_control.so"))
    assert message == (
        "joint 'swing': hardware interface 'hardware_interface/PosVelJointInterface' is none that "
        "gazebo_ros_control knows (hardware_interface/EffortJointInterface, "
        "hardware_interface/PositionJointInterface, hardware_interface/VelocityJointInterface); "
        "its hardware fails to start"
    )
    own = plugin("libgazebo_ros_control.so", "<robotSimType>acme/Sim</robotSimType>")
    assert reported("RCT004", text + own) == []
