"""LAU016: see the rule."""

from pathlib import Path

import pytest

from tests.launched import reported

CREATE = "Node(package='ros_gz_sim', executable='create', arguments=[{}])"
ENTITY = "Node(package='gazebo_ros', executable='spawn_entity.py', arguments=[{}])"
MODEL = '<node pkg="gazebo_ros" type="spawn_model" name="s" args="{}"/>'


@pytest.mark.parametrize(
    ("node", "message"),
    [
        (CREATE.format("'-name', 'r'"), "create needs -file or -param or -string or -topic"),
        (CREATE.format("'-topic', '/a/robot_descripton'"), "'robot_descripton' is not 'robot_d"),
        (CREATE.format("'-file', '/no/such/robot.sdf'"), "'/no/such/robot.sdf' does not exist"),
        (CREATE.format("'-file', '/r/robot.xacro'"), "'robot.xacro' is a xacro, and Gazebo does"),
        (ENTITY.format("'-topic', 'robot_description'"), "spawn_entity.py needs -entity"),
        (ENTITY.format("'-entity', x, '-name', 'r', '-file', f"), "spawn_entity.py has no option"),
    ],
)
def test_ros_2(tmp_path: Path, node: str, message: str) -> None:
    (found,) = reported(tmp_path, "LAU016", "a.launch.py", node)
    assert found.message.startswith(message)


@pytest.mark.parametrize(
    ("args", "message"),
    [
        ("-urdf -param robot_description", "spawn_model needs -model"),
        ("-model r -param robot_description", "spawn_model needs -urdf or -sdf"),
        ("-urdf -model r", "spawn_model needs -file or -param or -database or -stdin"),
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
        CREATE.format("'-topic', 't', '-entity', 'r'"),  # which LAU018 tells
        CREATE.format("") + "\n" + CREATE.format("'-file', x, '--ros-args', '-q'"),
        CREATE.format("'-topic', 'robot_description_sim'"),
        CREATE.format("").replace("]", "], parameters=[{'topic': 'x'}]"),
        ENTITY.format("'-entity', 'r', '-file', find(), '-J', 'x'").replace("'-J', 'x'", "'-b'"),
        "Node(package='a', executable='create', arguments=['-q'])",
    ],
)
def test_whole_or_unknown_is_calm(tmp_path: Path, node: str) -> None:
    assert reported(tmp_path, "LAU016", "a.launch.py", node) == []


@pytest.mark.parametrize(
    "args",
    [
        "-urdf -param robot_description -model r -J a 1 -J b 2 -unpause",
        "-sdf -file $(env MODEL) -model r",
        "-urdf -param /r/robot_description -model $(arg m)",
        "",
    ],
)
def test_ros_1_is_calm(tmp_path: Path, args: str) -> None:
    text = '<arg name="m" default=""/>' + MODEL.format(args)
    assert reported(tmp_path, "LAU016", "a.launch", text) == []
