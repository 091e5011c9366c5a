"""What was wrong on robots of hobbyists and competitions, for which nobody had tuned."""

from pathlib import Path

import pytest

from tests.gazebos import BASE, plugin, sensor
from tests.jointed import joint, limit
from tests.jointed import robot as jointed
from tests.launched import reported as of_launch
from tests.naming import naming
from tests.reported import reported

_IMPORTS = "from launch_ros.actions import Node\n"
_PUBLISHER = "package='robot_state_publisher', executable='robot_state_publisher'"
_ROBOT = "parameters=[{'robot_description': open('../robot.urdf').read()}]"


@pytest.mark.parametrize(
    ("words", "count"),
    [
        ("'-z 0.5'", 0),
        ("'-x -0.5'", 0),
        ("'-z0.5'", 0),
        ("'-z', '0.5'", 0),
        ("'-w 0.5'", 1),
        ("'-entity r'", 1),
    ],
)
def test_an_option_and_its_number_in_one_word(tmp_path: Path, words: str, count: int) -> None:
    """A quadruped's `'-z 0.5'`: argparse takes the rest of the word as the value."""
    program = (
        f"{_IMPORTS}nodes = [Node(package='gazebo_ros', executable='spawn_entity.py',\n"
        f"    arguments=['-topic', 'robot_description', '-entity', 'r', {words}])]\n"
    )
    assert len(of_launch(tmp_path / "arm", "LAU016", "a.launch.py", program)) == count


def test_a_second_publisher_without_the_robot(tmp_path: Path) -> None:
    """A robot with two publishers, of which one has no robot: it stops, and publishes nothing."""
    nodes = [f"Node({_PUBLISHER}, {given})" for given in (_ROBOT, "parameters=[{'a': 1}]", _ROBOT)]
    files = {"robot.urdf": "<robot name='r'><link name='base'/></robot>"}
    for count, is_second in ((2, False), (3, True)):
        program = f"{_IMPORTS}nodes = [{', '.join(nodes[:count])}]\n"
        found = of_launch(tmp_path / "arm", "LAU015 LAU021", "a.launch.py", program, files)
        assert [one.code for one in found] == ["LAU015"] + ["LAU021"] * is_second
        assert found[0].help == "remove the node: another one publishes the robot"


def test_a_map_among_the_parameters(tmp_path: Path) -> None:
    """A line follower gives its map to slam_toolbox: no section of a node would help."""
    program = f"{_IMPORTS}nodes = [Node(package='p', executable='e', parameters=['../m.yaml'])]\n"
    for text, word in (
        ("image: m.pgm\nresolution: 0.1\norigin: [0, 0, 0]", "map_server"),
        ("a: 1", "above"),
    ):
        (found,) = of_launch(tmp_path / "arm", "LAU044", "a.launch.py", program, {"m.yaml": text})
        assert word in (found.help or "")


def test_a_drive_of_a_robot_without_wheels() -> None:
    """WAVE ROVER's first model: there is no joint to name."""
    drive = plugin("libgazebo_ros_diff_drive.so", "<left_joint>left</left_joint>")
    for kind, help in (("fixed", "add the joint"), ("continuous", "name a joint")):
        (found,) = reported("GAZ021", jointed(joint("arm", kind)) + drive)
        assert (found.help or "").startswith(help)


def test_the_topic_of_depth_images() -> None:
    """A robot for Robocon: the help named the topic of the coloured images."""
    lines = "<ros><remapping>depth/image_raw:=/depth</remapping></ros>"
    camera = f'<plugin name="c" filename="libgazebo_ros_camera.so">{lines}</plugin>'
    (found,) = reported("GAZ016", BASE + sensor("depth", camera))
    assert found.help == "write s/depth/image_raw:=/depth"


@pytest.mark.parametrize(
    ("kind", "velocity", "count"),
    [("continuous", "30", 0), ("continuous", "0", 1), ("revolute", "30", 1)],
)
def test_the_passive_joint_of_a_double_pendulum(kind: str, velocity: str, count: int) -> None:
    """An environment of Isaac Lab, whose second arm swings freely."""
    free = joint("free", kind, limit("-1", "1", effort="0", velocity=velocity))
    text = jointed(joint("driven", "revolute", limit("-1", "1")), free)
    found = [one.message for one in reported("JNT008", text) if "effort" in one.message]
    assert found == [naming("free", "effort", "0 N·m")] * count
