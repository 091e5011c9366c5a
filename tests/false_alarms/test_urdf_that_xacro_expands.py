"""XAC003: a launch file expands what is called a plain URDF."""

from pathlib import Path

import pytest

from tests.launched import MANIFEST
from tests.workspaces import add_files
from urdfkit import check

ROBOT = """<robot name="r"><link name="${'base'}"/><link name="$(arg side)_arm"/>
<joint name="j" type="fixed"><parent link="base"/><child link="left_arm"/></joint></robot>
"""
XML = '<launch><param name="robot_description" {}/></launch>'
PYTHON = """import xacro
from launch import LaunchDescription
from launch_ros.actions import Node
def generate_launch_description():
    text = {}
    return LaunchDescription([Node(package="robot_state_publisher",
        executable="robot_state_publisher", parameters=[{{"robot_description": text}}])])
"""


@pytest.mark.parametrize(
    ("name", "text", "is_expanded"),
    [
        ("a.launch", XML.format('command="xacro $(find arm)/r.urdf side:=left"'), True),
        ("a.launch", XML.format('command="cat $(find arm)/r.urdf"'), False),
        ("a.launch", XML.format('textfile="$(find arm)/r.urdf"'), False),
        (
            "a.launch.py",
            PYTHON.format("xacro.process_file('PATH', mappings={{'side': 'left'}}).toxml()"),
            True,
        ),
        ("a.launch.py", PYTHON.format("open('PATH').read()"), False),
    ],
)
def test_a_launch_file_that_expands_it(
    tmp_path: Path, name: str, text: str, is_expanded: bool
) -> None:
    (tmp_path / "launch").mkdir()
    (tmp_path / "package.xml").write_text(MANIFEST)
    robot = tmp_path / "r.urdf"
    robot.write_text(ROBOT)
    text = text.replace("PATH", str(robot)).replace("{{", "{").replace("}}", "}")
    (tmp_path / "launch" / name).write_text(text)
    for given in (robot, tmp_path):
        found = check(given, select=["XAC", "REF", "URD"])
        codes = {one.code for one in found.diagnostics if one.span.source.path.endswith("urdf")}
        assert codes == (set() if is_expanded else {"XAC003"})


@pytest.mark.parametrize(("replaced", "count"), [("$(find arm)", 0), ("$(find base)", 1)])
def test_a_launch_file_that_replaces_the_text(tmp_path: Path, replaced: str, count: int) -> None:
    """A hexapod for gz-sim: only the path of its controllers is an expression."""
    path = "<parameters>$(find arm)/config/controllers.yaml</parameters>"
    plugin = f'<plugin filename="gz_ros2_control-system" name="p">{path}</plugin>'
    robot = f'<robot name="r"><link name="base"/><gazebo>{plugin}</gazebo></robot>'
    add_files(
        tmp_path,
        {
            "package.xml": MANIFEST,
            "r.urdf": robot,
            "launch/a.launch.py": PYTHON.format(
                f"open('r.urdf').read().replace('{replaced}', '/opt/arm')"
            ),
        },
    )
    assert len(check(tmp_path / "r.urdf", select=["XAC003"]).diagnostics) == count
