"""Actions and launch files of ros_gz that start a bridge, spawn a model or start Gazebo."""

from pathlib import Path

import pytest

from urdfkit.ros.launch import read_launch
from urdfkit.ros.launch.contents import Launch, StartedProgram
from urdfkit.ros.launch.forwarding import file_of_action, is_forwarding
from urdfkit.ros.launch.worlds import worlds
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver

SHARE = 'os.path.join(get_package_share_directory("{}"), "launch", "{}")'
INCLUDE = "IncludeLaunchDescription(PythonLaunchDescriptionSource({}), launch_arguments={})\n"
BRIDGE = '{"config_file": "/b.yaml", "bridge_name": "b", "namespace": "/bot"}'
TAG = '<ros_gz_bridge bridge_name="b" config_file="/b.yaml" namespace="bot"/>'
MODEL = '{"topic": "description", "world": "hall", "z": "0.2", "Y": "1", "file": ""}'


def read(package: Path, name: str, text: str) -> Launch:
    path = package / "launch" / name
    path.write_text(text)
    return read_launch(Source.read(path), Resolver(environment={}), {})


def included(package: str, file: str, arguments: str) -> str:
    return INCLUDE.format(SHARE.format(package, file), f"{arguments}.items()")


def is_bridge(node: StartedProgram) -> bool:
    assert (node.name, node.namespace) == ("b", "bot")
    assert node.parameters.every == {"config_file": "/b.yaml"}
    assert node.parameters.at["config_file"].text.strip("\"'") == "/b.yaml"
    return node.key == "ros_gz_bridge/bridge_node"


def is_spawner(node: StartedProgram) -> bool:
    words = [word.text for word in node.words]
    expected = {"-topic": "description", "-world": "hall", "-z": "0.2", "-Y": "1"}
    assert dict(zip(words[::2], words[1::2], strict=True)) == expected
    return node.key == "ros_gz_sim/create"


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.launch", f"<launch>{TAG}</launch>"),
        ("a.py", included("ros_gz_bridge", "ros_gz_bridge.launch.py", BRIDGE)),
        ("a.py", 'RosGzBridge(bridge_name="b", config_file="/b.yaml", namespace="bot")'),
    ],
)
def test_a_bridge(package: Path, name: str, text: str) -> None:
    launch = read(package, name, text)
    (node,) = launch.programs
    assert is_bridge(node)
    assert not launch.unread
    assert ("/b.yaml", False) in [(file.path, file.exists) for file in launch.files]


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.py", included("ros_gz_sim", "gz_spawn_model.launch.py", MODEL)),
        ("a.py", 'GzSpawnModel(topic="description", world="hall", z="0.2", yaw="1")'),
        (
            "a.launch",
            '<launch><gz_spawn_model topic="description" world="hall" z="0.2" yaw="1"/></launch>',
        ),
    ],
)
def test_a_model(package: Path, name: str, text: str) -> None:
    launch = read(package, name, text)
    (node,) = launch.programs
    assert is_spawner(node)
    assert not launch.unread


def test_a_bridge_and_a_model(package: Path) -> None:
    arguments = BRIDGE.replace("}", f", {MODEL[1:]}")
    text = included("ros_gz_sim", "ros_gz_spawn_model.launch.py", arguments)
    bridge, spawner = read(package, "a.py", text).programs
    assert is_bridge(bridge)
    assert is_spawner(spawner)


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.py", included("ros_gz_sim", "gz_server.launch.py", '{"world_sdf_file": "/w.sdf"}')),
        ("a.py", 'GzServer(world_sdf_file="/w.sdf")'),
        ("a.launch", '<launch><gz_server world_sdf_file="/w.sdf"/></launch>'),
    ],
)
def test_a_world(package: Path, name: str, text: str) -> None:
    launch = read(package, name, text)
    assert [world.name for world in worlds(launch)] == ["/w.sdf"]
    assert not launch.programs
    assert not launch.unread


@pytest.mark.parametrize(
    "text",
    [
        INCLUDE.format(SHARE.format("ros_gz_bridge", "ros_gz_bridge.launch.py"), "unknown"),
        "RosGzBridge(**settings)",
        'RosGzBridge(bridge_name="b", config_file="/b.yaml", extra_bridge_params="x")',
    ],
)
def test_a_bridge_with_unknown_topics(package: Path, text: str) -> None:
    (node,) = read(package, "a.py", text).programs
    assert node.parameters.every is None


def test_a_condition(package: Path) -> None:
    text = 'RosGzBridge(bridge_name="b", config_file="/b", condition=IfCondition({}))'
    (node,) = read(package, "a.py", text.format("unknown")).programs
    assert not node.is_sure
    assert not read(package, "a.py", text.format('"false"')).programs


def test_other_files_and_actions() -> None:
    assert not file_of_action("Node")
    assert not is_forwarding("/opt/ros/jazzy/share/ros_gz_sim/launch/gz_sim.launch.py")
