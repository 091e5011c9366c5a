"""The plugins of a model, and what Gazebo makes of the names in them."""

import pytest

from tests.gazebos import BASE, block, child, plugin, sensor
from urdfkit.lint.context import Context
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.ros.gazebo.plugins import PluginUse, conversion_result, generations
from urdfkit.ros.targets import parse
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver

DRIVE = "libgazebo_ros_diff_drive.so"


def context(text: str, *targets: str) -> Context:
    source = Source("robot.urdf", whole_robot(BASE + text).encode())
    return Context(source, Resolver(environment={}), targets=parse(targets) if targets else None)


def only(text: str, *targets: str) -> PluginUse:
    (use,) = context(text, *targets).plugins
    return use


@pytest.mark.parametrize(
    ("text", "place"),
    [
        (plugin("libx.so"), "model"),
        (block('<plugin name="p" filename="libx.so"/>'), "link"),
        (sensor("ray", '<plugin name="p" filename="libx.so"/>'), "sensor"),
        (block('<visual><plugin name="p" filename="libx.so"/></visual>'), "visual"),
    ],
)
def test_parent_of_a_plugin(text: str, place: str) -> None:
    assert only(text).place == place


@pytest.mark.parametrize(
    ("tags", "targets", "generation"),
    [
        ("<leftJoint>a</leftJoint>", (), "classic-ros1"),
        ("<left_joint>a</left_joint>", (), "classic-ros2"),
        ("<leftJoint>a</leftJoint>", ("classic-ros2",), "classic-ros2"),
        ("<left_joint>a</left_joint>", ("classic-ros1",), "classic-ros1"),
        ("<left_joint>a</left_joint>", ("classic-ros1", "classic-ros2"), "classic-ros2"),
        ("<leftJoint>a</leftJoint>", ("moveit",), "classic-ros1"),
    ],
)
def test_the_generation_follows_from_target_then_tags(
    tags: str, targets: tuple[str, ...], generation: str
) -> None:
    use = only(plugin(DRIVE, tags), *targets)
    assert use.plugin is not None
    assert use.plugin.generation == generation


def test_a_plugin_of_another_target() -> None:
    use = only(plugin(DRIVE), "gz-harmonic")
    assert use.plugin is None
    assert len(use.known) == 2


def test_parameters_of_a_plugin() -> None:
    use = only(plugin("libx.so", '<a><b c="d"> e </b></a><a/>'))
    assert [(item.path, item.text) for item in use.items] == [
        ("a", ""),
        ("a/b", "e"),
        ("a/b/@c", "d"),
        ("a", ""),
    ]
    assert len(use.values("a")) == 2


def test_references() -> None:
    joints = "<jointName>a, b::c,d</jointName>"
    use = only(plugin("libgazebo_ros_joint_state_publisher.so", joints), "classic-ros1")
    assert [(one.kind, one.name) for one in use.references()] == [("joint", "a"), ("joint", "d")]


@pytest.mark.parametrize(
    ("file", "expected"),
    [
        (DRIVE, {"classic-ros1", "classic-ros2"}),
        ("libgazebo_ros_laser.so", {"classic-ros1"}),
        ("libLiftDragPlugin.so", {"classic", "classic-ros1", "classic-ros2"}),
        ("libhector_gazebo_ros_imu.so", {"classic-ros1", "classic-ros2"}),
        ("gz-sim-diff-drive-system", {"gz"}),
        ("libvendor.so", set()),
    ],
)
def test_generations(file: str, expected: set[str]) -> None:
    assert generations(only(plugin(file))) == expected


@pytest.mark.parametrize(
    ("kind", "name", "expected"),
    [
        ("link", "base", "kept"),
        ("link", "arm", "kept"),
        ("link", "cam", "merged"),
        ("link", "ghost", "dropped"),
        ("link", "hand", "dropped"),
        ("link", "extra", "kept"),
        ("link", "nothing", "unknown"),
        ("joint", "arm_joint", "kept"),
        ("joint", "cam_joint", "merged"),
        ("joint", "ghost_joint", "dropped"),
        ("joint", "float_joint", "other"),
        ("joint", "nothing", "unknown"),
    ],
)
def test_conversion_result_of_a_name(kind: str, name: str, expected: str) -> None:
    robot = child("arm") + child("cam", "fixed") + child("ghost", inside="")
    robot += child("hand", parent="ghost") + child("float", "floating")
    robot += block('<link name="extra"/>', "")
    assert conversion_result(context(robot).gazebo, kind, name) == expected
