"""Options of programs; the planted defects have those of the spawner."""

from pathlib import Path

import pytest

from tests.launched import reported
from tests.naming import naming
from urdfkit import Severity

AGENT = """from launch_ros.actions import Node

nodes = [Node(package="micro_ros_agent", executable="micro_ros_agent", arguments={})]
"""


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ('["serial", "--dev", "/dev/ttyACM0", "--baudrate", "921600", "-v6"]', ""),
        ('["udp4", "--port", "8888", "--ros-args", "--log-level", "info"]', ""),
        ('[transport, "--dev", "/dev/ttyACM0"]', ""),
        ('"serial --dev /dev/ttyACM0".split()', ""),
        ("[]", "name no transport"),
        ('["udp4", "8888"]', "udp4 requires --port"),
        ('["udp4", "-p", "8888"]', ""),
        ('["serial"]', "serial requires --dev"),
        ('["udp4", *more]', ""),
        ('["serial --dev /dev/ttyACM0"]', "is one word"),
        ('["usb", "--dev", "/dev/ttyACM0"]', "no transport 'usb'"),
        ('["serial", "--dev", "/dev/ttyACM0", "--baud", "921600"]', "ignores '--baud'"),
    ],
)
def test_the_agent_of_micro_ros(tmp_path: Path, words: str, message: str) -> None:
    found = reported(tmp_path / "arm", "LAU036", "a.launch.py", AGENT.format(words))
    assert [message in one.message for one in found] == [True] * bool(message)


@pytest.mark.parametrize(
    ("words", "count"),
    [
        ("[]", 1),
        ('["--controller-manager", "/controller_manager"]', 1),
        ('["arm"]', 0),
        ("[name]", 0),
        ("name.split()", 0),
        ('["--controller", "arm"]', 0),
        ('["--help"]', 0),
    ],
)
def test_a_spawner_of_nothing(tmp_path: Path, words: str, count: int) -> None:
    text = AGENT.replace("micro_ros_agent", "controller_manager", 1).format(words)
    text = text.replace("micro_ros_agent", "spawner")
    found = reported(tmp_path / "arm", "LAU036", "a.launch.py", text)
    assert ["name no controller" in one.message for one in found] == [True] * count
    misnamed = text.replace("arguments=", "args=")
    assert reported(tmp_path / "arm", "LAU036", "a.launch.py", misnamed) == []


@pytest.mark.parametrize(
    ("transport", "severity"),
    [("serail", Severity.ERROR), ("can", Severity.WARNING), ("spi", Severity.WARNING)],
)
def test_a_transport_that_a_team_has_added(
    tmp_path: Path, transport: str, severity: Severity
) -> None:
    """Underwater robots of students: their agent speaks CAN."""
    text = AGENT.format(f'["{transport}", "--dev", "can0"]')
    (found,) = reported(tmp_path / "arm", "LAU036", "a.launch.py", text)
    assert (found.message, found.severity) == (naming("micro_ros_agent", transport), severity)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ('["--yaw", "1.57", "--frame-id", "a", "--child-frame-id", "b"]', ""),
        ('["--yaw", "90", "--frame-id", "a", "--child-frame-id", "b"]', "is 90 rad"),
        ('["--x", "90", "--frame-id", "a", "--child-frame-id", "b"]', ""),
        ('["--", "yaw", "0", "--frame-id", "a", "--child-frame-id", "b"]', "no option '--'"),
        ('["_own:=a", "--frame-id", "a", "--child-frame-id", "b"]', "a parameter of ROS 1"),
    ],
)
def test_words_of_a_static_transform(tmp_path: Path, words: str, message: str) -> None:
    text = AGENT.replace("micro_ros_agent", "tf2_ros", 1)
    text = text.replace("micro_ros_agent", "static_transform_publisher").format(words)
    found = reported(tmp_path / "arm", "LAU036", "a.launch.py", text)
    assert [message in one.message for one in found] == [True] * bool(message)


@pytest.mark.parametrize(
    ("words", "count"),
    [
        ('"gazebo", "--ros-args", "--world", "a.world"', 0),
        ('"gzserver", "-s", "libgazebo_ros_init.so", "--ros-args", "--world", "a"', 1),
        ('"ros2", "run", "a", "b", "--ros-args", "--world", "a"', 1),
    ],
)
def test_ros_arguments_of_gazebo(tmp_path: Path, words: str, count: int) -> None:
    """Gazebo Classic is a node only with the plugin that makes it one."""
    text = f"from launch.actions import ExecuteProcess\n\na = [ExecuteProcess(cmd=[{words}])]\n"
    found = reported(tmp_path / "arm", "LAU036", "a.launch.py", text)
    assert ["--world" in one.message for one in found] == [True] * count
