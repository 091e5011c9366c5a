"""WLD004: see the rule."""

from pathlib import Path

import pytest

from tests.checks.worlds.started import CLASSIC, INCLUDE, SENSOR, findings, messages
from tests.naming import naming

CODE = "WLD004"
PHYSICS = '<physics name="p" type="ode"><max_step_size>{}</max_step_size></physics>'
CONTROL = """<ros2_control name="c" type="system">
<hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware></ros2_control>
<gazebo><plugin filename="gz_ros2_control-system"
name="gz_ros2_control::GazeboSimROS2ControlPlugin">
<parameters>$(find arm)/control.yaml</parameters></plugin></gazebo>"""
YAML = """controller_manager:
  ros__parameters:
    update_rate: {}
"""


@pytest.mark.parametrize(
    ("step", "rate", "steps"),
    [("0.01", 500, "100"), ("0.003", 1000, "333.333"), ("0.001", 2000, "1000")],
)
def test_the_controller_manager(step: str, rate: int, steps: str, tmp_path: Path) -> None:
    path = str(tmp_path / "control.yaml")
    (one,) = findings(
        tmp_path,
        CODE,
        world=PHYSICS.format(step),
        robot=CONTROL.replace("$(find arm)", str(tmp_path)),
        files={"control.yaml": YAML.format(rate)},
    )
    assert one.message == naming("controller_manager", f"{rate} Hz", "hall", f"{steps} Hz")
    assert (one.span.source.path, one.span.line, one.span.text) == (path, 3, str(rate))


@pytest.mark.parametrize(("step", "rate"), [("0.001", 1000), ("0.004", 250), ("0.00833", 120)])
def test_rate_is_low_enough(step: str, rate: int, tmp_path: Path) -> None:
    robot = CONTROL.replace("$(find arm)", str(tmp_path))
    files = {"control.yaml": YAML.format(rate)}
    assert messages(tmp_path, CODE, world=PHYSICS.format(step), robot=robot, files=files) == []


def test_the_default_step(tmp_path: Path) -> None:
    sensor = SENSOR.format("imu").replace(">30<", ">{}<")
    (one,) = messages(tmp_path, CODE, world="", robot=sensor.format("1500"))
    assert one == naming("s", "1500 Hz", "hall", "1000 Hz")
    assert messages(tmp_path, CODE, world="", robot=sensor.format("1000")) == []
    empty = INCLUDE.replace('["-r ", share, "/worlds/hall.sdf"]', '"-r empty.sdf"')
    assert len(messages(tmp_path, CODE, robot=sensor.format("1500"), launch=empty)) == 1


def test_a_sensor_in_a_slow_world(tmp_path: Path) -> None:
    sensor = SENSOR.format("imu").replace(">30<", ">400<")
    (one,) = messages(tmp_path, CODE, world=PHYSICS.format("0.005"), robot=sensor)
    assert one == naming("s", "400 Hz", "hall", "200 Hz")


@pytest.mark.parametrize(
    ("first", "second", "launch", "count"),
    [
        ("0.005", "0.001", INCLUDE, 1),  # gz-sim takes the first
        ("0.001", "0.005", INCLUDE, 0),
        ("0.005", "0.001", CLASSIC, 0),
    ],
)
def test_several_physics(first: str, second: str, launch: str, count: int, tmp_path: Path) -> None:
    sensor = SENSOR.format("imu").replace(">30<", ">400<")
    world = PHYSICS.format(first) + PHYSICS.format(second).replace('"p"', '"q"')
    found = messages(tmp_path, CODE, world=world, robot=sensor, launch=launch)
    assert found == [naming("s", "400 Hz", "hall", "200 Hz")] * count
