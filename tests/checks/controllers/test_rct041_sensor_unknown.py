"""RCT041: see the rule."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.checks.controllers.test_rct013_controllers_name_unknown_joint import controller
from tests.controls import GZ, ROBOT, control, driven, plugin
from urdfkit import Diagnostic, check
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.text.diagnostic import Confidence, Severity

SENSOR = '<sensor name="imu"><state_interface name="orientation.x"/></sensor>'
OFFERED = control(driven("swing"), SENSOR, plugin=GZ)
IMU = "imu_sensor_broadcaster/IMUSensorBroadcaster"
FORCE = "force_torque_sensor_broadcaster/ForceTorqueSensorBroadcaster"


def reported(folder: Path, text: str, blocks: str = OFFERED) -> list[Diagnostic]:
    (folder / "c.yaml").write_text(text)
    names = plugin("gz_ros2_control-system", f"<parameters>{folder}/c.yaml</parameters>")
    (folder / "r.urdf").write_text(whole_robot(ROBOT + blocks + names))
    report = check(folder / "r.urdf", select=["RCT041"])
    assert report.crashed == ()
    return list(report.diagnostics)


@pytest.mark.parametrize("kind", [IMU, FORCE])
def test_a_sensor_that_is_not_there(tmp_path: Path, kind: str) -> None:
    (found,) = reported(tmp_path, controller("b", kind, sensor_name="imuu"))
    assert found.message == (
        "controller 'b' publishes the sensor 'imuu', which no <ros2_control> has; "
        "did you mean 'imu'?"
    )
    assert (found.span.line, found.span.text) == (4, "imuu")
    # A driver may export what the description does not name, as that of a robot with sonars.
    assert (found.severity, found.confidence) == (Severity.WARNING, Confidence.INFERRED)


@pytest.mark.parametrize(
    "text",
    [
        controller("b", IMU, sensor_name="imu"),
        controller("b", IMU),
        controller("b", FORCE, sensor_name="''"),
        controller("b", "acme/Own", sensor_name="x"),
        controller("b", IMU, sensor_name="$(var prefix)imu"),
    ],
)
def test_there_or_unknown_is_calm(tmp_path: Path, text: str) -> None:
    assert reported(tmp_path, text) == []


@pytest.mark.parametrize("blocks", ["", control(driven("swing"))])
def test_a_robot_without_sensors_is_calm(tmp_path: Path, blocks: str) -> None:
    assert reported(tmp_path, controller("b", IMU, sensor_name="x"), blocks) == []
