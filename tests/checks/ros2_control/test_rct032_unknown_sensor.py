"""RCT032: see the rule."""

from pathlib import Path

import pytest

from tests.controls import (
    CLASSIC,
    GZ,
    MOCK,
    ROBOT,
    control,
    controller,
    driven,
    plugin,
    reported_with_file,
)
from tests.naming import naming
from tests.reported import fixed, messages, reported
from urdfkit import Diagnostic, check
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.text.diagnostic import Confidence, Severity

IMU = '<sensor name="{}"><state_interface name="orientation.x"/></sensor>'
GAZEBO = '<gazebo reference="swing_link"><sensor name="base_imu" type="imu"/></gazebo>'


@pytest.mark.parametrize("hardware", [GZ, CLASSIC])
def test_a_sensor_that_gazebo_does_not_have(hardware: str) -> None:
    text = ROBOT + control(IMU.format("base_immu"), plugin=hardware) + GAZEBO
    assert messages("RCT032", text) == [
        naming("base_immu", "<ros2_control>", "<gazebo>", "base_imu")
    ]
    assert '<sensor name="base_imu"><state' in fixed("RCT032", text)


@pytest.mark.parametrize(
    ("interface", "severity", "help"),
    [
        ("orientation.x", Severity.WARNING, "add a <sensor>"),
        ("torque.z", Severity.WARNING, "add a <sensor>"),
        ("Present Pressure 1", Severity.INFO, "leave it out"),  # robotis_hand
    ],
)
def test_a_sensor_that_gazebo_has_under_no_name(
    interface: str, severity: Severity, help: str
) -> None:
    sensor = f'<sensor name="finger"><state_interface name="{interface}"/></sensor>'
    (found,) = reported("RCT032", ROBOT + control(sensor, plugin=GZ) + GAZEBO)
    assert found.severity is severity
    assert found.help.startswith(help)


def test_other_sensors_are_accepted() -> None:
    assert reported("RCT032", ROBOT + control(IMU.format("base_imu"), plugin=GZ) + GAZEBO) == []
    assert reported("RCT032", ROBOT + control(IMU.format("own"), plugin=MOCK) + GAZEBO) == []


SENSOR = '<sensor name="imu"><state_interface name="orientation.x"/></sensor>'
OFFERED = control(driven("swing"), SENSOR)
IMU_BROADCASTER = "imu_sensor_broadcaster/IMUSensorBroadcaster"
FORCE = "force_torque_sensor_broadcaster/ForceTorqueSensorBroadcaster"


def reported_broadcaster(directory: Path, text: str, blocks: str = OFFERED) -> list[Diagnostic]:
    return reported_with_file("RCT032", directory, text, blocks)


@pytest.mark.parametrize("kind", [IMU_BROADCASTER, FORCE])
def test_missing_sensor(tmp_path: Path, kind: str) -> None:
    (found,) = reported_broadcaster(tmp_path, controller("b", kind, sensor_name="imuu"))
    assert found.message == naming("b", "imuu", "<ros2_control>", "imu")
    assert (found.span.line, found.span.text) == (4, "imuu")
    assert (found.severity, found.confidence) == (Severity.WARNING, Confidence.INFERRED)


@pytest.mark.parametrize(
    ("hardware", "sensor", "count"),
    [(MOCK, "sonar", 1), ("own/Hardware", "sonar", 0), ("own/Hardware", "imuu", 1)],
)
def test_a_driver_that_exports_what_its_block_does_not_name(
    tmp_path: Path, hardware: str, sensor: str, count: int
) -> None:
    """A robot of a hobbyist with sonars, whose driver finds them itself."""
    blocks = control(driven("swing"), SENSOR, plugin=hardware)
    text = controller("b", IMU_BROADCASTER, sensor_name=sensor)
    assert len(reported_broadcaster(tmp_path, text, blocks)) == count


@pytest.mark.parametrize(("condition", "count"), [("xacro:if", 0), ("!--", 1)])
def test_a_driver_that_an_argument_selects(tmp_path: Path, condition: str, count: int) -> None:
    """The same robot, which is simulated without arguments."""
    own = f'<{condition} value="0"><plugin>own/Driver</plugin></xacro:if>'
    own = own.replace("</xacro:if>", "-->") if count else own
    blocks = control(SENSOR, plugin=GZ).replace("<hardware>", f"<hardware>{own}")
    text = controller("b", IMU_BROADCASTER, sensor_name="sonar")
    (tmp_path / "c.yaml").write_text(text)
    names = plugin("gz_ros2_control-system", f"<parameters>{tmp_path}/c.yaml</parameters>")
    robot = whole_robot(ROBOT + blocks + names)
    path = tmp_path / "r.urdf.xacro"
    path.write_text(robot.replace("<robot", '<robot xmlns:xacro="http://ros.org/wiki/xacro"', 1))
    found = check(path, select=["RCT032"]).diagnostics
    assert sum("'sonar'" in one.message for one in found) == count


def test_an_interface_of_a_missing_sensor(tmp_path: Path) -> None:
    names = "{force: {x: imu/force.x}, torque: {x: imuu/torque.x, y: imuu/torque.y}}"
    (found,) = reported_broadcaster(tmp_path, controller("b", FORCE, interface_names=names))
    assert found.span.text == "imuu/torque.x"
    assert found.message == naming("b", "imuu", "<ros2_control>", "imu")


def test_the_sensor_of_an_admittance_controller(tmp_path: Path) -> None:
    kind = "admittance_controller/AdmittanceController"
    (found,) = reported_broadcaster(tmp_path, controller("b", kind, ft_sensor="{name: imuu}"))
    assert found.span.text == "imuu"


@pytest.mark.parametrize(
    "text",
    [
        controller("b", FORCE, interface_names="{force: {x: imu/force.x}}"),
        controller("b", IMU_BROADCASTER, sensor_name="imu"),
        controller("b", IMU_BROADCASTER),
        controller("b", FORCE, sensor_name="''"),
        controller("b", "acme/Own", sensor_name="x"),
        controller("b", IMU_BROADCASTER, sensor_name="$(var prefix)imu"),
        controller("b", IMU_BROADCASTER, sensor_name="<namespace>/imu"),  # ReplaceString of Nav2
    ],
)
def test_existing_or_unknown_sensor_is_accepted(tmp_path: Path, text: str) -> None:
    assert reported_broadcaster(tmp_path, text) == []


def test_a_sensor_in_a_namespace_is_accepted(tmp_path: Path) -> None:
    """Husarion's IMU broadcaster adds the namespace to the name."""
    blocks = OFFERED.replace('name="imu"', 'name="/imu"')
    text = controller("b", IMU_BROADCASTER, sensor_name="imu")
    assert reported_broadcaster(tmp_path, text, blocks) == []


@pytest.mark.parametrize("blocks", ["", control(driven("swing"))])
def test_robot_without_sensors_is_accepted(tmp_path: Path, blocks: str) -> None:
    assert (
        reported_broadcaster(tmp_path, controller("b", IMU_BROADCASTER, sensor_name="x"), blocks)
        == []
    )
