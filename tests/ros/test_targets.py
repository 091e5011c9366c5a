"""The programs that a check is for: as they are named, and as a model gives them away."""

from pathlib import Path

import pytest

from tests.conftest import CorpusRobot, manifest, model_id, needs_corpus
from tests.gazebos import BASE, plugin
from urdfkit.lint import rule_index
from urdfkit.lint.context import Context
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.ros.catalog import data
from urdfkit.ros.targets import GAZEBO, TARGETS, TargetFacts, Targets, UnknownTarget, parse
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver

MOVE = "libgazebo_ros_planar_move.so"
OLD, NEW = "<odometryFrame>o</odometryFrame>", "<odometry_frame>o</odometry_frame>"
ROS = "<ros><namespace>a</namespace></ros>"


def inferred(text: str, directory: Path, build: str = "") -> tuple[str, ...]:
    if build:
        manifest = f"<package><name>p</name><buildtool_depend>{build}</buildtool_depend></package>"
        (directory / "package.xml").write_text(manifest)
    source = Source(str(directory / "robot.urdf"), whole_robot(BASE + text).encode())
    names = Context(source, Resolver(environment={})).targets.names
    return tuple(name for name in names if name.startswith(("classic", "gz")))


@pytest.mark.parametrize(
    ("file", "tags", "build", "generation"),
    [
        (MOVE, "", "", "classic-ros1"),
        (MOVE, OLD, "", "classic-ros1"),
        (MOVE, NEW, "", "classic-ros2"),
        (MOVE, OLD, "ament_cmake", "classic-ros2"),
        (MOVE, NEW, "catkin", "classic-ros1"),
        (MOVE, ROS, "catkin", "classic-ros2"),
        ("libgazebo_ros_ray_sensor.so", "", "", "classic-ros2"),
        ("libgazebo_ros_laser.so", NEW, "", "classic-ros1"),
        ("libgazebo_ros_laser.so", "", "ament_cmake", "classic-ros2"),
        ("gz-sim-imu-system", "", "", "gz-harmonic"),
        ("ignition-gazebo-imu-system", "", "", "gz-fortress"),
    ],
)
def test_generation(file: str, tags: str, build: str, generation: str, tmp_path: Path) -> None:
    assert inferred(plugin(file, tags), tmp_path, build) == (generation,)


def test_names_are_sorted() -> None:
    assert parse(["moveit", "ros2", "moveit"]) == Targets(("ros2", "moveit"))
    assert parse(TARGETS) == Targets(tuple(TARGETS))
    assert set(GAZEBO) < set(TARGETS)


@pytest.mark.parametrize(
    ("name", "hint"),
    [
        ("mojoco", "; did you mean 'mujoco'?"),
        ("gz-harmonik", "; did you mean 'gz-harmonic'?"),
        ("unreal", ""),
    ],
)
def test_an_unknown_name_is_an_error_with_the_nearest(name: str, hint: str) -> None:
    with pytest.raises(UnknownTarget) as error:
        parse(["ros2", name])
    assert str(error.value) == f"unknown target '{name}'{hint} ({', '.join(TARGETS)})"


def test_any_of() -> None:
    assert Targets(("ros1", "classic-ros1")).any_of(GAZEBO)
    assert not Targets(("ros1",)).any_of(GAZEBO)


def test_given_targets_are_not_inferred() -> None:
    source = Source("robot.urdf", whole_robot(BASE + plugin("gz-sim-imu-system", "")).encode())
    given = parse(["mujoco"])
    assert Context(source, Resolver(environment={}), targets=given).targets == given
    inferred = Context(source, Resolver(environment={})).targets
    assert inferred == Targets(("gz-harmonic",), ("gz-harmonic: plugin gz-sim-imu-system",))


def test_a_plain_robot_implies_no_target() -> None:
    source = Source("robot.urdf", whole_robot(BASE).encode())
    assert Context(source, Resolver(environment={})).targets == Targets(())


def test_the_namespace_of_drake_implies_it() -> None:
    data = b'<robot name="r" xmlns:drake="http://drake.mit.edu"><link name="a"/></robot>'
    inferred = Context(Source("robot.urdf", data), Resolver(environment={})).targets
    assert inferred == Targets(("drake",), ("drake: xmlns:drake",))


WITH_PLUGINS = [
    entry for entry in manifest() if entry.facts.get("expect", {}).get("gazebo_plugins")
]


def generation(plugins: list[str], is_ros2: bool) -> str:
    """What a person says who knows the plugins and the package."""
    if any(name.startswith(("gz_ros2_control", "gz-sim")) for name in plugins):
        return "gz-harmonic"
    return "classic-ros2" if is_ros2 else "classic-ros1"


@needs_corpus
@pytest.mark.parametrize("entry", WITH_PLUGINS, ids=model_id)
def test_the_generation_of_real_robots(entry: CorpusRobot) -> None:
    path, facts = entry.path, entry.facts
    targets = Context(Source.read(path), Resolver(), entry.arguments).targets
    package = next(at for at in path.parents if (at / "package.xml").is_file())
    is_ros2 = b"ament" in (package / "package.xml").read_bytes()
    expected = generation(facts["expect"]["gazebo_plugins"], is_ros2)
    assert targets.names == ("ros2" if is_ros2 else "ros1", expected)
    assert targets.evidence[0] == f"{targets.names[0]}: package.xml"
    named = targets.evidence[1].removeprefix(f"{expected}: plugin ")
    assert named in facts["expect"]["gazebo_plugins"]


@pytest.mark.parametrize("name", TARGETS)
def test_each_fact_has_a_source(name: str) -> None:
    facts = data(f"targets/{name}")
    assert facts.keys() - {"sources", "title"} <= facts.get("sources", {}).keys()
    assert facts.keys() - {"sources"} <= set(TargetFacts._fields)
    assert set(facts.get("severities", {})) <= set(rule_index.codes())
