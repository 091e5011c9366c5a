"""WLD002: see the rule."""

from pathlib import Path

import pytest

from tests.checks.worlds.started import INCLUDE, SENSOR, WORLD, findings, messages, systems
from tests.naming import naming
from urdfkit import Diagnostic, Severity

CODE = "WLD002"
CLASSIC = INCLUDE.replace("ros_gz_sim", "gazebo_ros").replace("gz_sim", "gazebo")
CLASSIC = CLASSIC.replace('"gz_args": ["-r ", share', '"world": [share')
SPAWN = '\nNode(package="ros_gz_sim", executable="create", arguments=["-topic", "r", {}])\n'


def one(directory: Path, world: str, **files: object) -> Diagnostic:
    (found_one,) = findings(directory, CODE, world=world, **files)  # type: ignore[arg-type]
    return found_one


@pytest.mark.parametrize(
    "file", ["libgazebo_ros_init.so", "libgazebo_ros_factory.so", "libgazebo_ros_state.so"]
)
def test_a_plugin_of_classic_in_gz(file: str, tmp_path: Path) -> None:
    reported = one(tmp_path, f'<plugin name="p" filename="{file}"/>')
    assert reported.message == naming("p", file, "Gazebo", "Classic", "hall")
    assert (reported.severity, reported.span.text) == (Severity.WARNING, file)


def test_a_system_of_gz_in_classic(tmp_path: Path) -> None:
    reported = one(tmp_path, systems("physics"), launch=CLASSIC)
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
    reported = one(tmp_path, world, robot=SENSOR.format(kind))
    assert reported.message == naming("ogre", kind, "s")
    assert messages(tmp_path, CODE, world=world, robot=SENSOR.format("camera")) == []
    newer = world.replace("ogre", "ogre2")
    assert messages(tmp_path, CODE, world=newer, robot=SENSOR.format(kind)) == []


def test_missing_models(tmp_path: Path) -> None:
    include = "<include><uri>model://{}</uri></include>"
    files = {"models/big_shelf/model.config": "<model/>"}
    assert messages(tmp_path, CODE, world=include.format("big_shelf"), files=files) == []
    (typo,) = messages(tmp_path, CODE, world=include.format("big_shlef"))
    assert typo == naming("model://big_shlef", "big_shelf")
    unknown = one(tmp_path, include.format("cafe"))
    assert (unknown.severity, "not in the workspace" in unknown.message) == (Severity.INFO, True)
    for name in ("sun", "ground_plane"):
        (online,) = messages(tmp_path, CODE, world=include.format(name))
        assert online == naming(f"model://{name}", "Gazebo", "Classic")
        assert messages(tmp_path, CODE, world=include.format(name), launch=CLASSIC) == []


PLANE = (
    '<model name="floor">{}<link name="link"><{shape} name="s">'
    "<geometry><plane><normal>0 0 1</normal></plane></geometry></{shape}></link></model>"
)


@pytest.mark.parametrize(
    ("state", "shape", "count"),
    [
        ("<static>true</static>", "collision", 0),
        ("<static>1</static>", "collision", 0),
        ("", "collision", 1),
        ("<static>false</static>", "collision", 1),
        ("", "visual", 0),
        ('<joint name="j" type="fixed"/>', "collision", 0),  # to the world
        ('<link name="l"><gravity>false</gravity></link>', "collision", 0),
    ],
)
def test_a_ground_that_falls(tmp_path: Path, state: str, shape: str, count: int) -> None:
    world = PLANE.format(state, shape=shape)
    found = findings(tmp_path, CODE, world=world)
    words = naming("floor", "not static")
    assert [(one.span.line, one.message) for one in found] == [(3, words)] * count
    assert findings(tmp_path, CODE, world=f"<gravity>0 0 0</gravity>{world}") == []


def test_files_that_are_not_worlds(tmp_path: Path) -> None:
    path = tmp_path / "worlds/hall.sdf"
    reported = one(tmp_path, "<model>")
    assert reported.message == naming("hall.sdf", "<model>", "before", "</world>")
    assert reported.span.source.path == str(path)
    path.write_text("<sdf><light name='l'/></sdf>")
    (none,) = messages(tmp_path, CODE)
    assert none == naming("hall.sdf", "<world>", "<sdf>")
    path.write_text(f"<% n = 3 %>{WORLD.format('')}")
    assert messages(tmp_path, CODE) == []


@pytest.mark.parametrize(
    "argument", ['"-world", "halle"', '"-world=default"', '"--world", "empty"']
)
def test_spawned_into_another_world(argument: str, tmp_path: Path) -> None:
    reported = one(tmp_path, "", launch=INCLUDE + SPAWN.format(argument))
    assert "'hall' is started" in reported.message
    same = SPAWN.format('"-world", "hall"')
    assert messages(tmp_path, CODE, world="", launch=INCLUDE + same) == []
    assert messages(tmp_path, CODE, world="", launch=INCLUDE + SPAWN.format("")) == []


@pytest.mark.parametrize(
    ("text", "severity", "words"),
    [
        ("<pose>0 0 0.5 0 0 0</pose>", None, ""),
        ("<pose>0 0 0.5</pose>", Severity.ERROR, "<pose> is '0 0 0.5', must be 6 numbers"),
        ('<pose degrees="true">0 0 0 0 0 90</pose>', None, ""),
        ("<pose/>", None, ""),
        ("<static>yes</static>", Severity.ERROR, "true or false"),
        ("<link name='l'><inertial><mass>2,5</mass></inertial></link>", Severity.WARNING, "as 2"),
        ("<link name='l'><inertial><mass>two</mass></inertial></link>", Severity.ERROR, "a number"),
        ("<link/>", Severity.ERROR, "<link> has no name"),
        ("<joint name='j' type='hinge'/>", Severity.ERROR, "'hinge' of <joint>"),
    ],
)
def test_values(tmp_path: Path, text: str, severity: Severity | None, words: str) -> None:
    found = findings(tmp_path, CODE, world=f'<model name="m">{text}</model>')
    assert [one.severity for one in found] == ([severity] if severity else [])
    assert all(words in one.message for one in found)


@pytest.mark.parametrize(
    ("uri", "count"),
    [
        ("model://shelf/shelf.dae", 0),
        ("model://shelf/other.dae", 1),
        ("model://elsewhere/shelf.dae", 0),
        ("file:///opt/shelf.dae", 0),
        ("shelf.dae", 1),
    ],
)
def test_meshes_of_a_world(tmp_path: Path, uri: str, count: int) -> None:
    shape = f"<geometry><mesh><uri>{uri}</uri></mesh></geometry>"
    world = f'<model name="m"><link name="l"><visual name="v">{shape}</visual></link></model>'
    files = {"models/shelf/model.config": "<model/>", "models/shelf/shelf.dae": "x"}
    found = messages(tmp_path, CODE, world=world, files=files)
    assert ["is not found" in one for one in found] == [True] * count


@pytest.mark.parametrize(("name", "count"), [("hall", 0), ("empty", 1)])
def test_topics_of_another_world(tmp_path: Path, name: str, count: int) -> None:
    topic = f"/world/{name}/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock"
    bridge = (
        f'\nNode(package="ros_gz_bridge", executable="parameter_bridge", arguments=["{topic}"])'
    )
    found = messages(tmp_path, CODE, world="", launch=INCLUDE + bridge)
    assert ["'empty', but world 'hall'" in each for each in found] == [True] * count
