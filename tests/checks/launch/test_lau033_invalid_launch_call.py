"""LAU033: see the rule."""

from pathlib import Path

import pytest

from tests.checks.launch.actions import HANDLED, LASTING, PROGRAM, SPAWNER, described
from tests.launched import PYTHON, reported


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (described(SPAWNER, "LaunchDescription([a, TimerAction(actions=b)])"), "actions of Timer"),
        (described(SPAWNER, "LaunchDescription(a)"), "initial_entities of LaunchDescription is"),
        (PROGRAM.format("LaunchDescription([])"), "generate_launch_description() returns nothing"),
        (
            PROGRAM.replace("ption", "pton").format("return LaunchDescription([])"),
            "launch calls generate_launch_description(), ",
        ),
        (
            "def  generate_launch_descripton():\n    return LaunchDescription([])\n",
            "launch calls generate_launch_description(), ",
        ),
        (
            "XMLLaunchDescriptionSource('/a/b.launch.py')",
            "XMLLaunchDescriptionSource does not read 'b",
        ),
        ("Node(package='a', node_executable='b')", "Node has no argument 'node_executable'"),
        ("Node(package='a', executable='b', remappings=['a:=b'])", "'a:=b' in remappings"),
        ("a = [b]\nLaunchDescription([a])", "initial_entities of LaunchDescription contains"),
        ("Node(package='a', parameters=[{'topics': []}])", "topics is an empty list"),
        (
            "xacro.process_file('a.xacro', mappings={'sim': True})",
            "the value of an argument of xacro is a bool",
        ),
        (
            "Node(package='a', parameters=[{'robot_description': xacro.parse('a.xacro')}])",
            "parse() returns an XML document",
        ),
        ("builder.robot_description('a.xacro', {'n': 2})", "the value of an argument of xacro is"),
    ],
)
def test_programs_that_launch_rejects(tmp_path: Path, text: str, message: str) -> None:
    (found,) = reported(tmp_path, "LAU033", "a.launch.py", text)
    assert found.message.startswith(message)


@pytest.mark.parametrize(
    "text",
    [
        described(SPAWNER, HANDLED.format("a, ")),
        described(SPAWNER, "LaunchDescription([a, TimerAction(actions=[b])])"),
        described(LASTING, HANDLED.format("a, ").replace("[b]", "[Shutdown()]")) + "b.x\n",
        PROGRAM.format("raise ValueError"),
        PROGRAM.format("if x:\n        return LaunchDescription([])"),
        PROGRAM.format("a = " + "b + " * 900 + "b\n    return LaunchDescription([])"),
        "from a import generate_launch_description\nLaunchDescription([])\n",
        "PythonLaunchDescriptionSource('/a/b.launch.py')",
        "if ROS_DISTRO == 'foxy':\n    Node(package='a', node_executable='b')",
        "ExecuteProcess(cmd=['ros2 topic list'], shell=True)",
        "ExecuteProcess(cmd=['xacro', '/a b/c.xacro'])",
        "Node(package='a', executable='b', remappings=[('a', 'b')])",
        "a = [b]\nLaunchDescription([*a, c])",
        "a = LaunchConfiguration('b').perform(context)\nc = 'd' + a",
        "PythonLaunchDescriptionSource([FindPackageShare('a'), '/launch/b.launch.py'])",
        # hsrb_moveit_config: a function of the package, which returns the text
        "Node(package='a', parameters=[{'robot_description': description.parse('a.xacro')}])",
    ],
)
def test_programs_that_launch_accepts(tmp_path: Path, text: str) -> None:
    assert reported(tmp_path, f"LAU003 {PYTHON}", "a.launch.py", text) == []


@pytest.mark.parametrize(("text", "count"), [(PROGRAM.format("return a"), 0), ("<launch/>", 1)])
def test_a_program_with_the_suffix_of_xml(tmp_path: Path, text: str, count: int) -> None:
    """ros2_control_sim_boilerplate: launch imports the file of this source, whatever its name."""
    include = "PythonLaunchDescriptionSource(get_package_share_directory('arm') + '/b.launch')"
    found = reported(tmp_path, "LAU033", "a.launch.py", include, {"b.launch": text})
    assert ["does not read 'b.launch'" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(
    ("default", "choices", "help"),
    [
        ("'True'", "['true', 'false']", "write 'true'"),
        ("'x'", "['true', 'false']", "add 'x' to choices"),
        ("'true'", "['true', 'false']", ""),
        ("'true'", "['TRUE', other]", ""),
        ("LaunchConfiguration('b')", "['true']", ""),
    ],
)
def test_a_default_that_is_no_choice(tmp_path: Path, default: str, choices: str, help: str) -> None:
    text = f"DeclareLaunchArgument('a', default_value={default}, choices={choices})\n"
    found = reported(tmp_path, "LAU033", "a.launch.py", text)
    assert [one.help.startswith(help) for one in found] == [True] * bool(help)
