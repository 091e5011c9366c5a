"""WLD005: see the rule."""

from pathlib import Path

import pytest

from tests.checks.worlds.started import (
    CLASSIC,
    INCLUDE,
    SENSOR,
    findings,
    messages,
    only_finding,
    systems,
)
from tests.naming import naming
from urdfkit import Severity

CODE = "WLD005"


@pytest.mark.parametrize(
    "file", ["libgazebo_ros_init.so", "libgazebo_ros_factory.so", "libgazebo_ros_state.so"]
)
def test_a_plugin_of_classic_in_gz(file: str, tmp_path: Path) -> None:
    reported = only_finding(tmp_path, CODE, world=f'<plugin name="p" filename="{file}"/>')
    assert reported.message == naming("p", file, "Gazebo", "Classic", "hall")
    assert (reported.severity, reported.span.text) == (Severity.WARNING, file)


def test_a_system_of_gz_in_classic(tmp_path: Path) -> None:
    reported = only_finding(tmp_path, CODE, world=systems("physics"), launch=CLASSIC)
    assert "'hall' is started in Gazebo Classic" in reported.message
    state = '<plugin name="p" filename="libgazebo_ros_state.so"/>'
    assert messages(tmp_path, CODE, world=state, launch=CLASSIC) == []


@pytest.mark.parametrize(
    ("file", "name", "problem"),
    [
        ("gz-sim-physcis-system", "gz::sim::systems::Physics", "unknown plugin library"),
        ("gz-sim-sensor-system", "gz::sim::systems::Sensors", "unknown plugin library"),
        ("libros_gz_sim_imu-system.so", "gz::sim::systems::Imu", "unknown plugin library"),
        ("gz-sim-sensors-system", "gz::sim::systems::Sensor", "only gz::sim::systems::Sensors"),
        ("gz-sim-imu-system", "imu", "only gz::sim::systems::Imu"),
        ("ignition-gazebo-imu-system", "ignition::gazebo::systems::v6::Imu", ""),
        ("ignition-gazebo-imu-system", "gz::sim::systems::Imu", ""),
        ("libgz-sim8-imu-system.so", "gz::sim::systems::Imu", ""),
        ("libmy_weather.so", "anything", ""),
    ],
)
def test_names_of_plugins(file: str, name: str, problem: str, tmp_path: Path) -> None:
    reported = findings(tmp_path, CODE, world=f'<plugin filename="{file}" name="{name}"/>')
    assert [problem in one.message for one in reported] == [True] * bool(problem)
    assert all(one.severity is Severity.ERROR for one in reported)


@pytest.mark.parametrize(
    ("engine", "problem"),
    [("ogre3", "render engine 'ogre3'"), ("orge2", "'ogre2'"), ("ogre", ""), ("ogre2", "")],
)
def test_render_engines(engine: str, problem: str, tmp_path: Path) -> None:
    world = '<plugin filename="gz-sim-sensors-system" name="gz::sim::systems::Sensors">'
    world += f"<render_engine>{engine}</render_engine></plugin>"
    assert [problem in one for one in messages(tmp_path, CODE, world=world)] == [True] * bool(
        problem
    )
    line = INCLUDE.replace('"-r "', f'"-r --render-engine {engine} "')
    written = messages(tmp_path, CODE, world="", launch=line)
    assert [problem in one for one in written] == [True] * bool(problem)


@pytest.mark.parametrize("kind", ["segmentation", "boundingbox_camera"])
def test_sensors_that_the_old_engine_lacks(kind: str, tmp_path: Path) -> None:
    world = '<plugin filename="gz-sim-sensors-system" name="gz::sim::systems::Sensors">'
    world += "<render_engine>ogre</render_engine></plugin>"
    reported = only_finding(tmp_path, CODE, world=world, robot=SENSOR.format(kind))
    assert reported.message == naming("ogre", kind, "s")
    assert messages(tmp_path, CODE, world=world, robot=SENSOR.format("camera")) == []
    newer = world.replace("ogre", "ogre2")
    assert messages(tmp_path, CODE, world=newer, robot=SENSOR.format(kind)) == []
