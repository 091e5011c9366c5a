"""LAU016: see the rule."""

import shutil
import subprocess
from pathlib import Path

import pytest

from tests.launched import reported
from tests.naming import naming

CREATE = "Node(package='ros_gz_sim', executable='create', arguments=[{}])"
ENTITY = "Node(package='gazebo_ros', executable='spawn_entity.py', arguments=[{}])"
MODEL = '<node pkg="gazebo_ros" type="spawn_model" name="s" args="{}"/>'


@pytest.mark.parametrize(
    ("node", "message"),
    [
        (CREATE.format("'-name', 'r'"), "create requires -file or -param or -string or -topic"),
        (
            CREATE.format("'-topic', '/a/robot_descripton'"),
            "unknown topic 'robot_descripton'",
        ),
        (CREATE.format("'-file', '/no/such/robot.sdf'"), "file not found: /no/such/robot.sdf"),
        (CREATE.format("'-file', '/r/robot.xacro'"), "'robot.xacro' is a xacro"),
        (ENTITY.format("'-topic', 'robot_description'"), "spawn_entity.py requires -entity"),
        (ENTITY.format("'-entity', x, '-name', 'r', '-file', f"), "spawn_entity.py has no option"),
    ],
)
def test_ros_2(tmp_path: Path, node: str, message: str) -> None:
    (found,) = reported(tmp_path, "LAU016", "a.launch.py", node)
    assert found.message.startswith(message)


@pytest.mark.parametrize("more", ["", ", arguments=[]", ", parameters=[]"])
def test_no_arguments(tmp_path: Path, more: str) -> None:
    node = f"Node(package='ros_gz_sim', executable='create'{more})"
    (found,) = reported(tmp_path, "LAU016", "a.launch.py", node)
    assert found.message.startswith("create requires -file or")


@pytest.mark.parametrize(
    ("args", "message"),
    [
        ("-urdf -param robot_description", "spawn_model requires -model"),
        ("-model r -param robot_description", "spawn_model requires -urdf or -sdf"),
        ("-urdf -model r", "spawn_model requires -file or -param or -database or -stdin"),
        (
            "-urdf -param robot_description -entity r -model r",
            "spawn_model has no option '-entity'",
        ),
    ],
)
def test_ros_1(tmp_path: Path, args: str, message: str) -> None:
    (found,) = reported(tmp_path, "LAU016", "a.launch", MODEL.format(args))
    assert (found.message.startswith(message), found.span.line) == (True, 2)


@pytest.mark.parametrize(
    "node",
    [
        CREATE.format("'-topic', 'robot_description', '-name', 'r', '-z', '-0.5'"),
        CREATE.format("'-topic', topic, '--name=r', '-allow-renaming', 'true'"),
        CREATE.format("*more"),
        CREATE.format("'-file', x, '--ros-args', '-q'"),
        "Node(package='ros_gz_sim', executable='create', **given)",
        "Node(package='ros_gz_sim', executable='create', parameters=['a.yaml'])",
        CREATE.format("'-topic', 'robot_description_sim'"),
        CREATE.format("'-topic', 'robot_descriptions'") + "  # publishes robot_descriptions",
        CREATE.format("").replace("]", "], parameters=[{'topic': 'x'}]"),
        ENTITY.format("'-entity', 'r', '-file', find(), '-J', 'x'").replace("'-J', 'x'", "'-b'"),
        "Node(package='a', executable='create', arguments=['-q'])",
    ],
)
def test_complete_or_unknown_arguments_are_accepted(tmp_path: Path, node: str) -> None:
    assert reported(tmp_path, "LAU016", "a.launch.py", node) == []


@pytest.mark.parametrize(
    "args",
    [
        "-urdf -param robot_description -model r -J a 1 -J b 2 -unpause",
        "-sdf -file $(env MODEL) -model r",
        "-urdf -param /r/robot_description -model $(arg m)",
        "-urdf -param robot_description2 -model r",
        "",
    ],
)
def test_valid_in_ros_1(tmp_path: Path, args: str) -> None:
    text = '<arg name="m" default=""/>' + MODEL.format(args)
    assert reported(tmp_path, "LAU016", "a.launch", text) == []


CREATE_IGNORED = "Node(package='ros_gz_sim', executable='create', arguments=['-topic', 't', {}])"


@pytest.mark.parametrize(
    ("words", "message", "help"),
    [
        (
            "'-entity', 'r'",
            naming("-entity", "ignored"),
            naming("-model", "ROS 1", "-name"),
        ),
        (
            "'-nam', 'r'",
            naming("-nam", "ignored", "-name"),
            naming("-name"),
        ),
    ],
)
def test_unknown_option(tmp_path: Path, words: str, message: str, help: str) -> None:
    (found,) = reported(tmp_path, "LAU016", "a.launch.py", CREATE_IGNORED.format(words))
    assert (found.message, found.help) == (message, help)


@pytest.mark.parametrize(
    "node",
    [
        CREATE_IGNORED.format("'-name', 'r', '-allow-renaming', 'true', '-z', '-1'"),
        CREATE_IGNORED.format("*more"),
        CREATE_IGNORED.format("'-entity', 'r'").replace("ros_gz_sim", "acme"),
    ],
)
def test_known_option_is_accepted(tmp_path: Path, node: str) -> None:
    assert reported(tmp_path, "LAU016", "a.launch.py", node) == []


@pytest.mark.skipif(shutil.which("git") is None, reason="git is not installed")
@pytest.mark.parametrize(("ignored", "count"), [("*.urdf", 0), ("build/", 1)])
def test_a_file_that_git_ignores(tmp_path: Path, ignored: str, count: int) -> None:
    """A Dockerfile expands the xacro into it."""
    subprocess.run(["git", "init", "-q", str(tmp_path)], check=True)
    (tmp_path / ".gitignore").write_text(f"{ignored}\n")
    words = "-file $(find arm)/urdf/arm.urdf -urdf -model arm"
    text = f'<node pkg="gazebo_ros" type="spawn_model" name="s" args="{words}"/>'
    assert len(reported(tmp_path / "arm", "LAU016", "a.launch", text)) == count


@pytest.mark.parametrize(("default", "count"), [("''", 0), ("'m'", 1)])
def test_a_directory_that_the_caller_names(tmp_path: Path, default: str, count: int) -> None:
    """Dave: a launch file for any model, which another one includes with the name of one."""
    text = "from launch.substitutions import LaunchConfiguration, PathJoinSubstitution\n"
    text += f"DeclareLaunchArgument('model', default_value={default})\n"
    model = "PathJoinSubstitution(['/models', LaunchConfiguration('model'), 'model.sdf'])"
    text += CREATE.format(f"'-name', 'r', '-file', {model}")
    assert len(reported(tmp_path, "LAU016", "a.launch.py", text)) == count


@pytest.mark.parametrize(("name", "help"), [("PAROL6.urdf", "did you mean"), ("x.urdf", "create")])
def test_a_file_whose_name_is_written_otherwise(tmp_path: Path, name: str, help: str) -> None:
    """The exporter of SolidWorks writes the name of the package, in lower case, for the file."""
    text = MODEL.format("-urdf -model r -file $(find arm)/urdf/parol6.urdf")
    (found,) = reported(tmp_path, "LAU016", "a.launch", text, {f"urdf/{name}": "<robot/>"})
    assert found.message == naming(tmp_path / "urdf" / "parol6.urdf")
    assert found.help.startswith(help)
