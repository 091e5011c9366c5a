"""What was wrong in launch files of hobbyists and competitions, for which nobody had tuned."""

from pathlib import Path

import pytest

from tests.launched import launch
from tests.launched import reported as of_launch
from tests.naming import naming

_IMPORTS = "from launch_ros.actions import Node\n"
_ACTIONS = """\
import os
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import Command, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
HERE = os.path.dirname(__file__)
robot = LaunchConfiguration('robot', default='')

def generate_launch_description():
"""
_PUBLISHER = "package='robot_state_publisher', executable='robot_state_publisher'"
_ROBOT = "parameters=[{'robot_description': open('../robot.urdf').read()}]"
_PUBLISHED = "{{'robot_description': Command(['xacro ', {}])}}"
_SWITCH = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="c" default="true"/>
<link name="base"/><gazebo reference="wheel"><mu1>1</mu1></gazebo>
<xacro:unless value="$(arg c)"><xacro:include filename="drive.xacro"/></xacro:unless></robot>
"""


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


@pytest.mark.parametrize(("actions", "count"), [("", 0), ("slam", 1)])
def test_an_include_that_is_not_in_the_description(
    tmp_path: Path, actions: str, count: int
) -> None:
    """articubot_one's localizers, all but one of which are commented out."""
    include = "IncludeLaunchDescription(PythonLaunchDescriptionSource(HERE + '/slam.launch.py'))"
    program = f"{_ACTIONS}    slam = {include}\n    return LaunchDescription([{actions}])\n"
    assert len(of_launch(tmp_path / "arm", "LAU003", "a.launch.py", program)) == count


def test_what_an_excluded_file_starts(tmp_path: Path) -> None:
    """Its filters, too, which publish on the same topic."""
    nodes = "[Node(package='robot_localization', executable='ekf_node', name='n')]"
    program = "{}    other = IncludeLaunchDescription(PythonLaunchDescriptionSource({}))\n"
    program = program.format(_ACTIONS, "HERE + '/ekf.launch.py'")
    included = f"{_ACTIONS}    return LaunchDescription({nodes})\n"
    for count, extra in ((0, ""), (1, "other")):
        text = f"{program}    return LaunchDescription([*{nodes}, {extra}])\n"
        files = {"launch/ekf.launch.py": included}
        found = of_launch(tmp_path / "arm", "LAU021", "a.launch.py", text, files)
        assert len([one for one in found if "odometry/filtered" in one.message]) == count


@pytest.mark.parametrize(("between", "count"), [("", 0), ("    actions = [spawn]\n", 1)])
def test_a_node_that_another_one_replaces(tmp_path: Path, between: str, count: int) -> None:
    """barista_robot_description spawns its robot in a variable, twice."""
    words = "['-topic', 'robot_description', '-entity', 'r']"
    node = f"Node(package='gazebo_ros', executable='spawn_entity.py', arguments={words})"
    spawn = f"    spawn = {node}\n"
    actions = "*actions, spawn" if between else "spawn"
    program = f"{_ACTIONS}{spawn}{between}{spawn}    return LaunchDescription([{actions}])\n"
    found = of_launch(tmp_path / "arm", "LAU043 LAU037", "a.launch.py", program)
    assert [one.code for one in found] == ["LAU043"] * count


@pytest.mark.parametrize(("name", "parameters"), [("a.yaml", "{}"), ("a.xacro", _PUBLISHED)])
def test_a_path_with_an_argument_that_must_be_given(
    tmp_path: Path, name: str, parameters: str
) -> None:
    """articubot_one's `robots/<robot_model>/config`, for each of its robots."""
    for part, count in (("robot", 0), ("'other'", 1)):
        given = parameters.format(f"PathJoinSubstitution([HERE, '..', {part}, '{name}'])")
        node = f"Node(package='p', executable='e', parameters=[{given}])"
        text = f"{_ACTIONS}    return LaunchDescription([{node}])\n"
        assert len(of_launch(tmp_path / "arm", "LAU003", "a.launch.py", text)) == count


def test_a_text_in_a_function_with_the_context(tmp_path: Path) -> None:
    """A car's file for each namespace: in an OpaqueFunction, the value can be asked for."""
    for parameter, help in (("context", "write {robot.perform(context)}"), ("other", "list")):
        program = (
            f"{_ACTIONS}    return LaunchDescription([])\n"
            f"def setup({parameter}):\n"
            "    if robot in ['robot_1', 'robot_2']:\n"
            "        return [Node(package='p', executable='e', name=f'{robot}_ekf')]\n"
        )
        found = of_launch(tmp_path / "arm", "LAU034", "a.launch.py", program)
        assert [one.severity.value for one in found] == ["warning", "error"]
        assert help in (found[1].help or "")


@pytest.mark.parametrize(("behind", "count"), [("</xml>", 0), ("<a/>", 0), ("text", 1)])
def test_tags_behind_the_end_of_a_world(tmp_path: Path, behind: str, count: int) -> None:
    """articubot_one's world ends with `</xml>`: measured, libsdformat reads it."""
    model = "<model name='m'><static>true</static><link name='l'/></model>"
    world = f"<sdf version='1.6'><world name='w'>{model}</world></sdf>\n{behind}\n"
    program = (
        "from launch_ros.substitutions import FindPackageShare\n"
        f"{_ACTIONS}    return LaunchDescription([IncludeLaunchDescription(\n"
        "        [FindPackageShare('ros_gz_sim'), '/launch/gz_sim.launch.py'],\n"
        "        launch_arguments={'gz_args': HERE + '/../w.sdf'}.items())])\n"
    )
    found = of_launch(tmp_path / "arm", "WLD002", "a.launch.py", program, {"w.sdf": world})
    assert len(found) == count


@pytest.mark.parametrize(("shown", "count"), [("view", 0), ("other", 1)])
def test_the_view_of_several_launch_files(tmp_path: Path, shown: str, count: int) -> None:
    """barista_robot_description: one view for one robot and for two, which have other topics."""
    rviz = (
        "Visualization Manager:\n  Displays:\n  - Class: rviz_default_plugins/LaserScan\n"
        "    Topic: {Value: /morty/scan}\n"
    )
    node = '<node pkg="rviz2" exec="rviz2" args="-d $(dirname)/{}.rviz"/>'
    bridge = "/scan@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan"
    text = f'<node pkg="ros_gz_bridge" exec="parameter_bridge" args="{bridge}"/>'
    two = '<node pkg="drivers" exec="driver" name="$(env NAME)"/>'
    files = {
        "launch/view.rviz": rviz,
        "launch/other.rviz": rviz,
        "launch/two.launch.xml": launch(two + node.format(shown)),
    }
    text += node.format("view")
    found = of_launch(tmp_path / "arm", "LAU032", "a.launch.xml", text, files)
    assert len(found) == count


@pytest.mark.parametrize(
    ("parameters", "count"),
    [("{PATH}", 0), ("{PATH, PATH}", 1), ("{'use_sim_time', True}", 1), ("{'use_sim_time'}", 1)],
)
def test_a_parameter_file_in_braces(tmp_path: Path, parameters: str, count: int) -> None:
    """vikings_bot, NeuronBot: launch_ros reads a set of one path, as any iterable, as a file."""
    program = f"{_IMPORTS}PATH = __file__ + '.yaml'\n"
    program += f"nodes = [Node(package='p', executable='e', parameters=[{parameters}])]\n"
    found = of_launch(tmp_path / "arm", "LAU033", "a.launch.py", program)
    message = naming("set", "dictionary")
    assert [one.message for one in found] == [message] * count


@pytest.mark.parametrize(("function", "count"), [("print", 0), ("log.info", 0), ("Node", 1)])
def test_a_substitution_that_is_printed(tmp_path: Path, function: str, count: int) -> None:
    """A pick-and-place project shows where its robot is: launch goes on."""
    text = f"    {function}(f'robot: {{robot}}')\n    return LaunchDescription([])\n"
    assert len(of_launch(tmp_path / "arm", "LAU034", "a.launch.py", _ACTIONS + text)) == count


@pytest.mark.parametrize(("name", "count"), [("recoveries_server", 0), ("behavior_server", 1)])
def test_an_earlier_name_that_the_node_is_given(tmp_path: Path, name: str, count: int) -> None:
    """An omni robot with Nav2: its behaviour server is called as that of Galactic."""
    node = f"package='nav2_behaviors', executable='behavior_server', name='{name}'"
    text = f"{_IMPORTS}nodes = [Node({node}, parameters=['{tmp_path}/arm/nav2.yaml'])]\n"
    values = "recoveries_server: {ros__parameters: {robot_base_frame: base_link}}\n"
    values += "twist_mux: {ros__parameters: {use_stamped: true}}\n"  # of Jazzy
    files = {"nav2.yaml": values}
    found = of_launch(tmp_path / "arm", "LAU024", "a.launch.py", text, files)
    assert sum("Humble and later is" in one.message for one in found) == count


@pytest.mark.parametrize(("topic", "count"), [("cmd_vel", 0), ("other", 1)])
def test_a_drive_whose_include_is_switched_off(tmp_path: Path, topic: str, count: int) -> None:
    """A mecanum robot with ros2_control, or a drive of Gazebo: the bridge is for the latter."""
    drive = '<gazebo><plugin filename="gz-sim-diff-drive-system" name="drive">'
    drive += f"<topic>{topic}</topic></plugin></gazebo>"
    drive = f'<robot xmlns:xacro="http://www.ros.org/wiki/xacro">{drive}</robot>'
    world = '<sdf version="1.9"><world name="hall"/></sdf>'
    files = {"drive.xacro": drive, "r.urdf.xacro": _SWITCH, "w.sdf": world}
    directory = tmp_path / "arm"
    text = f"{_IMPORTS}from launch.actions import ExecuteProcess\n"
    text += "from launch.substitutions import Command\n"
    text += f"nodes = [ExecuteProcess(cmd=['gz', 'sim', '-r', '{directory}/w.sdf']),\n"
    description = f"{{'robot_description': Command(['xacro ', '{directory}/r.urdf.xacro'])}}"
    text += f"    Node({_PUBLISHER}, parameters=[{description}]),\n"
    word = "/cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist"
    bridge = f"package='ros_gz_bridge', executable='parameter_bridge', arguments=['{word}']"
    text += f"    Node({bridge})]\n"
    found = of_launch(directory, "LAU020", "a.launch.py", text, files)
    assert len(found) == count


@pytest.mark.parametrize(
    ("clocks", "at"),
    [("True False False", 0), ("False False True", 2), ("True True False", 2), ("True True", None)],
)
def test_the_only_node_with_simulation_time(tmp_path: Path, clocks: str, at: int | None) -> None:
    """A rover: one of its nodes waits for a clock, and eight do not."""
    text = _IMPORTS + "nodes = [\n"
    for number, clock in enumerate(clocks.split()):
        node = f"package='nav2_planner', executable='planner_server', name='n{number}'"
        text += f"Node({node}, parameters=[{{'use_sim_time': {clock}}}]),\n"
    found = of_launch(tmp_path / "arm", "LAU031", "a.launch.py", f"{text}]\n")
    assert [one.span.line for one in found] == ([at + 3] if at is not None else [])
