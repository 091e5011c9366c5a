"""WLD001: see the rule."""

from pathlib import Path

import pytest

from tests.checks.worlds.started import CLASSIC, INCLUDE, SENSOR, findings, messages, systems
from tests.naming import naming
from urdfkit import Severity

CODE = "WLD001"
DEFAULTS = ("physics", "user-commands", "scene-broadcaster")


@pytest.mark.parametrize(
    ("kind", "system"),
    [
        ("camera", "Sensors"),
        ("gpu_lidar", "Sensors"),
        ("gpu_ray", "Sensors"),
        ("rgbd", "Sensors"),
        ("imu", "Imu"),
        ("contact", "Contact"),
        ("gps", "NavSat"),
        ("force_torque", "ForceTorque"),
        ("altimeter", "Altimeter"),
        ("magnetometer", "Magnetometer"),
        ("air_pressure", "AirPressure"),
    ],
)
def test_each_sensor_requires_its_system(kind: str, system: str, tmp_path: Path) -> None:
    world = systems(*DEFAULTS) + "<spherical_coordinates/>"
    (one,) = findings(tmp_path, CODE, world=world, robot=SENSOR.format(kind))
    assert one.message == naming("hall", system, "without", "s", kind)
    assert (one.span.source.path, one.span.line) == (str(tmp_path / "worlds/hall.sdf"), 2)
    assert [note.span.source.path.rpartition("/")[2] for note in one.related] == [
        "robot.urdf",
        "robot.launch.py",
    ]


def test_a_world_without_plugins_has_the_defaults(tmp_path: Path) -> None:
    (one,) = messages(
        tmp_path, CODE, world="<gravity>0 0 -9.8</gravity>", robot=SENSOR.format("imu")
    )
    assert "the system Imu" in one


@pytest.mark.parametrize(
    "more",
    [
        systems("sensors"),
        '<plugin filename="libignition-gazebo6-sensors-system.so" name="x"/>',
        '<model name="m"><plugin filename="gz-sim-sensors-system" name="x"/></model>',
    ],
)
def test_the_world_loads_it(more: str, tmp_path: Path) -> None:
    world = f"{systems(*DEFAULTS)}\n{more}"
    assert messages(tmp_path, CODE, world=world, robot=SENSOR.format("camera")) == []


def test_the_robot_loads_it(tmp_path: Path) -> None:
    robot = f"{SENSOR.format('imu')}<gazebo>{systems('imu')}</gazebo>"
    assert messages(tmp_path, CODE, world=systems(*DEFAULTS), robot=robot) == []


def test_a_model_in_the_world_loads_it(tmp_path: Path) -> None:
    include = "<include><uri>model://lamp</uri></include>"
    files = {"models/lamp/model.sdf": f"<sdf><model>{systems('imu')}</model></sdf>"}
    robot = SENSOR.format("imu")
    assert messages(tmp_path, CODE, world=include, robot=robot, files=files) == []
    (tmp_path / "models/lamp/model.sdf").write_text("<sdf/>")
    assert len(messages(tmp_path, CODE, world=include, robot=robot)) == 1


def test_a_server_configuration_may_load_it(tmp_path: Path) -> None:
    launch = f"import os\nos.environ['GZ_SIM_SERVER_CONFIG_PATH'] = share\n{INCLUDE}"
    assert messages(tmp_path, CODE, world="", robot=SENSOR.format("imu"), launch=launch) == []


@pytest.mark.parametrize(
    "start",
    [
        INCLUDE.replace('["-r ", share, "/worlds/hall.sdf"]', '"-r -v4 empty.sdf"'),
        INCLUDE.replace('["-r ", share, "/worlds/hall.sdf"]', '[" empty.sdf --verbose 4 -r"]'),
        INCLUDE.replace('"gz_args": ["-r ", share, "/worlds/hall.sdf"]', ""),
        INCLUDE + 'ExecuteProcess(cmd=["ign gazebo -r -v 4", "shapes.sdf"], shell=True)\n',
    ],
)
def test_worlds_of_gazebo(start: str, tmp_path: Path) -> None:
    if "ign gazebo" in start:
        start = start.replace("[gazebo, robot]", "[robot]").replace("ros_gz_sim", "other")
    (one,) = findings(tmp_path, CODE, robot=SENSOR.format("camera"), launch=start)
    assert "the system Sensors" in one.message
    assert one.span.source.path == str(tmp_path / "launch/robot.launch.py")


def test_world_with_all_systems(tmp_path: Path) -> None:
    start = INCLUDE.replace('["-r ", share, "/worlds/hall.sdf"]', '"-r sensors_demo.sdf"')
    assert messages(tmp_path, CODE, robot=SENSOR.format("camera"), launch=start) == []


@pytest.mark.parametrize(
    ("missing", "effect"),
    [("physics", "nothing moves"), ("scene-broadcaster", "stays empty")],
)
def test_missing_default_systems(missing: str, effect: str, tmp_path: Path) -> None:
    world = systems(*(one for one in DEFAULTS if one != missing))
    (one,) = messages(tmp_path, CODE, world=world)
    assert effect in one
    assert "Harmonic" in one
    policy = "<include_server_config_plugins>{}</include_server_config_plugins>"
    kept = f"<gz:policies>{policy.format('true')}</gz:policies>"
    assert messages(tmp_path, CODE, world=world + kept) == []
    (one,) = messages(tmp_path, CODE, world=world + kept.replace("true", "false"))
    assert "Harmonic" not in one


def test_spawning_requires_user_commands(tmp_path: Path) -> None:
    world = systems("physics", "scene-broadcaster")
    assert messages(tmp_path, CODE, world=world) == []
    spawn = '\nNode(package="ros_gz_sim", executable="create", arguments=["-file", "a.sdf"])\n'
    (one,) = messages(tmp_path, CODE, world=world, launch=INCLUDE + spawn)
    assert one == naming("hall", "UserCommands", "Gazebo", "Harmonic")


def test_scene_is_optional_without_a_window(tmp_path: Path) -> None:
    launch = INCLUDE.replace('"-r "', '"-s -r "')
    assert messages(tmp_path, CODE, world=systems("physics", "user-commands"), launch=launch) == []


def test_classic_has_no_systems(tmp_path: Path) -> None:
    launch = """
<include file="$(find gazebo_ros)/launch/empty_world.launch">
  <arg name="world_name" value="$(dirname)/../worlds/hall.sdf"/>
</include>
<param name="robot_description" command="xacro $(dirname)/../robot.urdf"/>"""
    name = "robot.launch"
    robot = SENSOR.format("camera")
    assert messages(tmp_path, CODE, world="", robot=robot, launch=launch, name=name) == []
    gz = launch.replace("gazebo_ros", "ros_gz_sim").replace(
        "empty_world.launch", "gz_server.launch"
    )
    gz = gz.replace("world_name", "world_sdf_file")
    (one,) = messages(tmp_path, CODE, world="", robot=robot, launch=gz, name=name)
    assert "Sensors" in one


SPAWN = 'Node(package="gazebo_ros", executable="spawn_entity.py", arguments=["-entity", "c"])\n'
START = "ExecuteProcess(cmd=[{}])\n"


@pytest.mark.parametrize(
    "command",
    [
        '"gazebo", "--verbose"',
        '"gzserver", "-s", "libgazebo_ros_init.so"',
        '"gazebo", get_package_share_directory("arm") + "/worlds/hall.sdf"',
    ],
)
def test_classic_without_the_factory(command: str, tmp_path: Path) -> None:
    launch = INCLUDE.replace("[gazebo, robot]", "[robot]").replace("ros_gz_sim", "other")
    (one,) = findings(tmp_path, CODE, world="", launch=launch + START.format(command) + SPAWN)
    assert one.message == naming("Gazebo", "without", "libgazebo_ros_factory.so", "spawn_entity.py")
    assert one.severity is Severity.ERROR
    loaded = START.format(f'{command}, "-s", "libgazebo_ros_factory.so"')
    assert messages(tmp_path, CODE, world="", launch=launch + loaded + SPAWN) == []
    assert messages(tmp_path, CODE, world="", launch=launch + START.format(command)) == []


def test_the_launch_files_of_classic_load_the_factory(tmp_path: Path) -> None:
    assert messages(tmp_path, CODE, world="", launch=CLASSIC + SPAWN) == []


def test_a_world_may_load_the_factory(tmp_path: Path) -> None:
    launch = INCLUDE.replace("[gazebo, robot]", "[robot]").replace("ros_gz_sim", "other")
    start = START.format('"gazebo", share + "/worlds/hall.sdf"')
    plugin = '<plugin name="f" filename="libgazebo_ros_factory.so"/>'
    assert messages(tmp_path, CODE, world=plugin, launch=launch + start + SPAWN) == []


@pytest.mark.parametrize("kind", ["navsat", "gps"])
def test_world_without_spherical_coordinates(kind: str, tmp_path: Path) -> None:
    world = systems(*DEFAULTS, "navsat")
    (one,) = messages(tmp_path, CODE, world=world, robot=SENSOR.format(kind))
    assert "has no <spherical_coordinates>" in one
    world += "<spherical_coordinates/>"
    assert messages(tmp_path, CODE, world=world, robot=SENSOR.format(kind)) == []
