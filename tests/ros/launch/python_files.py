"""Launch files in Python, written into a package and read."""

from pathlib import Path

from urdfkit.ros.launch import read_launch
from urdfkit.ros.launch.contents import Launch
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver

HEAD = """
import os
import xacro
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import Command, FindExecutable, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
"""


def read(package: Path, body: str) -> Launch:
    path = package / "launch" / "a.launch.py"
    lines = "".join(f"    {line}\n" for line in body.strip().splitlines())
    path.write_text(HEAD + lines)
    return read_launch(Source.read(path), Resolver(environment={}))


def include(name: str, rest: str = "") -> str:
    return (
        "IncludeLaunchDescription(PythonLaunchDescriptionSource(os.path.join(\n"
        f"    get_package_share_directory('arm'), 'launch', '{name}')){rest})"
    )


ARM = """
side = LaunchConfiguration('side')
DeclareLaunchArgument('side', default_value='none')
Command(['xacro ', FindPackageShare('arm'), '/urdf/arm.xacro side:=', side])
"""


def included(package: Path, name: str = "rsp.launch.py", body: str = ARM) -> None:
    lines = "".join(f"    {line}\n" for line in body.strip().splitlines())
    (package / "launch" / name).write_text(HEAD + lines)
