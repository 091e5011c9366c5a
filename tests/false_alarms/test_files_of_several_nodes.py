"""LAU016, LAU024: files that another program of the launch file writes, or other nodes read."""

from pathlib import Path

import pytest

from tests.launched import reported

MADE = "$(find-pkg-share arm)/made/robot.urdf"
SPAWN = f'<node pkg="gazebo_ros" exec="spawn_entity.py" args="-entity r -file {MADE}"/>'


@pytest.mark.parametrize(
    ("command", "count"),
    [
        (f"xacro a.xacro -o {MADE}", 0),
        (f"bash -c 'xacro a.xacro > {MADE}'", 0),
        ("xacro a.xacro -o $(find-pkg-share arm)/made/arm.urdf", 1),
    ],
)
def test_a_robot_that_another_command_expands(tmp_path: Path, command: str, count: int) -> None:
    """An underwater vehicle: the launch file runs xacro in a shell, and spawns its output."""
    text = f'<executable cmd="{command}" shell="true"/>\n{SPAWN}'
    assert len(reported(tmp_path / "arm", "LAU016", "a.launch.xml", text)) == count


BRIDGE = """\
from launch_ros.actions import Node

nodes = [Node(package="p", executable="bridge", name="arm_bridge", parameters=["../can.yaml"{}])]
"""
SECTION = "{}:\n  ros__parameters:\n    rate: 1.0\n"


@pytest.mark.parametrize(
    ("more", "own", "count"),
    [("", "arm_bridge", 1), (', "../arm.yaml"', "arm_bridge", 0), (', "../arm.yaml"', "other", 2)],
)
def test_a_file_for_the_nodes_of_another_launch_file(
    tmp_path: Path, more: str, own: str, count: int
) -> None:
    """A rover: the bridge of the arm also gets the file of the CAN buses, beside its own."""
    files = {"can.yaml": SECTION.format("can_bridge"), "arm.yaml": SECTION.format(own)}
    found = reported(tmp_path / "arm", "LAU024", "a.launch.py", BRIDGE.format(more), files)
    assert len(found) == count


@pytest.mark.parametrize(
    ("executable", "file", "count"),
    [("can_bridge.py", "can", 0), ("can_bridge.py", "arm", 1), ("bridge", "can", 1)],
)
def test_a_file_that_another_launch_file_loads_for_its_node(
    tmp_path: Path, executable: str, file: str, count: int
) -> None:
    """Another rover: the node of a second launch file loads the parameters of the arm as well."""
    files = {
        "can.yaml": SECTION.format("can_bridge"),
        "launch/b.launch.py": (
            "from launch_ros.actions import Node\n"
            f"nodes = [Node(package='p', executable='{executable}', parameters=['../{file}.yaml'])]"
        ),
    }
    found = reported(tmp_path / "arm", "LAU024", "a.launch.py", BRIDGE.format(""), files)
    assert len(found) == count
