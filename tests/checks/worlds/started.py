"""A robot, a world and a launch file that starts both, for the tests of the rules WLD."""

from pathlib import Path
from typing import Any

from tests.launched import reported
from urdfkit import Diagnostic

ROBOT = """<robot name="cart">
<link name="base"><inertial><mass value="1"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
<collision><geometry><box size="1 1 0.2"/></geometry></collision></link>
{}
</robot>
"""
SENSOR = """<gazebo reference="base"><sensor name="s" type="{}">
<update_rate>30</update_rate></sensor></gazebo>"""
WORLD = """<sdf version="1.9">
<world name="hall">
{}
</world>
</sdf>
"""
INCLUDE = """\
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import ExecuteProcess, IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import Command, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare

share = get_package_share_directory("arm")

def generate_launch_description():
    robot = Command(["xacro ", share, "/robot.urdf"])
    gazebo = IncludeLaunchDescription(
        PythonLaunchDescriptionSource([FindPackageShare("ros_gz_sim"), "/launch/gz_sim.launch.py"]),
        launch_arguments={"gz_args": ["-r ", share, "/worlds/hall.sdf"]}.items(),
    )
    return LaunchDescription([gazebo, robot])
"""
#: The same in Gazebo Classic.
CLASSIC = (
    INCLUDE.replace("ros_gz_sim", "gazebo_ros")
    .replace("gz_sim", "gazebo")
    .replace('"gz_args": ["-r ", share', '"world": [share')
)


def systems(*names: str) -> str:
    """The plugins of a world: ``physics``, ``sensors``..."""
    classes = ("".join(map(str.title, name.split("-"))) for name in names)
    return "\n".join(
        f'<plugin filename="gz-sim-{name}-system" name="gz::sim::systems::{kind}"/>'
        for name, kind in zip(names, classes, strict=True)
    )


def findings(
    directory: Path,
    code: str,
    *,
    world: str | None = None,
    robot: str = "",
    launch: str = INCLUDE,
    name: str = "robot.launch.py",
    files: dict[str, str] | None = None,
) -> list[Diagnostic]:
    """The findings of a rule for a launch file.

    Args:
        directory: of the package ``arm``.
        code: of the rule.
        world: content of the ``<world>`` in ``worlds/hall.sdf``, from line 3; no file if None.
        robot: content of ``robot.urdf`` after the link ``base``, from line 5.
        launch: content of the launch file.
        name: of the launch file.
        files: further files, by path.
    """
    contents = {"robot.urdf": ROBOT.format(robot), **(files or {})}
    if world is not None:
        contents["worlds/hall.sdf"] = WORLD.format(world)
    return reported(directory, code, name, launch, contents)


def messages(directory: Path, code: str, **files: Any) -> list[str]:
    """The messages of these findings."""
    return [finding.message for finding in findings(directory, code, **files)]


def only_finding(directory: Path, code: str, **files: Any) -> Diagnostic:
    """The finding of a rule that has one."""
    (found,) = findings(directory, code, **files)
    return found
