"""LAU036: see the rule."""

from pathlib import Path

import pytest

from tests.launched import reported
from tests.naming import naming

ROS_2 = '<let name="x" value="$(var x)"/>\n'


@pytest.mark.parametrize(
    ("text", "message", "help"),
    [
        (
            ROS_2 + '<node pkg="a" exec="b" args="--ros-args -p c=d"/>',
            naming("c=d"),
            naming("c:=d"),
        ),
        (
            ROS_2 + '<node pkg="a" exec="b" args="--ros-args --params-fil c"/>',
            naming("unknown", "--params-fil"),
            naming("--params-file"),
        ),
        (
            ROS_2 + '<node pkg="controller_manager" exec="spawner" args="a --inactve"/>',
            naming("--inactve"),
            naming("--inactive"),
        ),
        (
            ROS_2 + '<node pkg="controller_manager" exec="spawner" args="a --stopped"/>',
            naming("--stopped", "Humble"),
            naming("--inactive"),
        ),
        (
            ROS_2 + '<executable cmd="ros2 control load_controller --set-state start a"/>',
            naming("ros2", "start", "Galactic"),
            "write active",
        ),
    ],
)
def test_what_this_ros_does_not_have(tmp_path: Path, text: str, message: str, help: str) -> None:
    found = reported(tmp_path, "LAU036", "a.launch", text)
    assert [(one.message, one.help) for one in found] == [(message, help)]


@pytest.mark.parametrize(
    "text",
    [
        ROS_2 + '<node pkg="a" exec="b" args="-p c=d --ros-args -p c:=d -r e:=f -- -p g"/>',
        ROS_2 + '<node pkg="a" exec="b" args="--ros-args --log-level info"/>',
        ROS_2 + '<node pkg="a" exec="b" args="--ros-args -p $(var x)"/>',
        ROS_2 + '<node pkg="controller_manager" exec="spawner" args="a -c=/b --load-only -p c"/>',
        ROS_2 + '<node pkg="controller_manager" exec="spawner" args="a --controller-manager-t 5"/>',
        ROS_2 + '<node pkg="controller_manager" exec="spawner" '
        """args="a --controller-ros-args '-r b:=c'"/>""",
        ROS_2 + '<executable cmd="ros2 control load_controller --set-state active a"/>',
    ],
)
def test_what_this_ros_has(tmp_path: Path, text: str) -> None:
    assert reported(tmp_path, "LAU036", "a.launch", text) == []


@pytest.mark.parametrize(
    ("args", "help"),
    [
        ("-configuration_directory /c -configuration_basename a.lua", None),
        ("--configuration_directory=/c --configuration_basename=a.lua", None),
        ("-flagfile /c/flags", None),
        ("$(arg all)", None),
        ("", None),
        (
            "-configuration_directory /c -configuration_basenames a.lua",
            "write -configuration_basename for -configuration_basenames",
        ),
        ("-configuration_directory /c", "add -configuration_basename and its value"),
    ],
)
def test_options_of_cartographer(tmp_path: Path, args: str, help: str | None) -> None:
    text = f'<node name="c" pkg="cartographer_ros" type="cartographer_node" args="{args}"/>'
    found = reported(tmp_path, "LAU036", "a.launch", text)
    assert [one.help for one in found] == ([help] if help else [])


@pytest.mark.parametrize(
    ("pieces", "word", "help"),
    [
        ("'xacro', path", "path", naming("xacro ")),
        ("FindExecutable(name='xacro'), path", "path", naming("xacro ")),
        ("'xacro ', path, 'sim:=true'", "'sim:=true'", naming(" sim:=", "before")),
        ("'xacro ', path, ' a:=', path, 'b:=1'", "'b:=1'", naming(" b:=", "before")),
    ],
)
def test_missing_space_in_a_command(tmp_path: Path, pieces: str, word: str, help: str) -> None:
    text = f"path = LaunchConfiguration('model')\nCommand([{pieces}])"
    (found,) = reported(tmp_path, "LAU036", "a.launch.py", text)
    assert (found.span.text, found.help) == (word, help)


@pytest.mark.parametrize(("mode", "count"), [(0o644, 1), (0o755, 0)])
def test_a_description_that_is_run_as_a_program(tmp_path: Path, mode: int, count: int) -> None:
    """mini_pupper_ros: the description's path is the whole command."""
    robot = tmp_path / "r.urdf.xacro"
    robot.write_text('<robot name="r"><link name="base"/></robot>')
    robot.chmod(mode)
    text = f"path = LaunchConfiguration('m', default={str(robot)!r})\nCommand([path])"
    found = reported(tmp_path, "LAU036", "a.launch.py", text)
    assert [one.message for one in found] == [naming("r.urdf.xacro", "xacro ")] * count


@pytest.mark.parametrize(
    "command",
    [
        "['xacro ', path, ' sim:=true']",
        "['xacro', ' ', path, ' ', 'sim:=', sim]",
        "['xacro ', '/opt/xacro', '/robot.xacro']",
        "[*pieces, 'sim:=true']",
        "'xacro robot.xacro'",
        "",
    ],
)
def test_separate_or_unknown_parts_of_a_command(tmp_path: Path, command: str) -> None:
    assert reported(tmp_path, "LAU036", "a.launch.py", f"Command({command})") == []


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("ExecuteProcess(cmd=['ros2 topic list'])", "'ros2 topic list' is one word"),
        ("ExecuteProcess(cmd='ros2 topic list')", "cmd of ExecuteProcess is"),
    ],
)
def test_a_command_line_that_is_one_word(tmp_path: Path, text: str, message: str) -> None:
    (found,) = reported(tmp_path, "LAU036", "a.launch.py", text)
    assert found.message.startswith(message)


@pytest.mark.parametrize(
    ("package", "more", "count"),
    [
        ("teleop_twist_keyboard", "", 1),
        ("teleop_twist_keyboard", ", prefix='xterm -e'", 0),
        ("teleop_twist_joy", "", 0),
    ],
)
def test_a_node_that_reads_the_keyboard(
    tmp_path: Path, package: str, more: str, count: int
) -> None:
    text = f"Node(package='{package}', executable='{package}'{more})\n"
    found = reported(tmp_path, "LAU036", "a.launch.py", text)
    assert ["reads the keyboard" in one.message for one in found] == [True] * count
