"""Launch files as text, for the examples of rules."""

from urdfkit.robot.samples import element_xml

#: Starts Gazebo with the world ``bad.sdf`` of `world_files`.
WORLD_LAUNCH = """\
from ament_index_python.packages import get_package_share_directory
from launch.actions import ExecuteProcess

share = get_package_share_directory("cart")
gazebo = ExecuteProcess(cmd=["gz", "sim", "-r", share + "/worlds/bad.sdf"])
"""
#: The same with the robot.
CART_LAUNCH = """\
from ament_index_python.packages import get_package_share_directory
from launch.actions import ExecuteProcess
from launch.substitutions import Command

share = get_package_share_directory("cart")
gazebo = ExecuteProcess(cmd=["gz", "sim", "-r", share + "/worlds/bad.sdf"])
robot = Command(["xacro ", share + "/cart.urdf"])
"""


def world_files(bad: str, good: str, *robot: str) -> dict[str, bytes]:
    """The package ``cart`` with two worlds, ``bad.sdf`` and ``good.sdf``, and maybe a robot.

    Args:
        bad: what is in the ``<world>`` of ``bad.sdf``.
        good: the same of ``good.sdf``.
        robot: the elements of ``cart.urdf``.
    """
    files = {"package.xml": "<package><name>cart</name></package>"}
    for name, inside in (("bad", bad), ("good", good)):
        world = element_xml('world name="hall"', inside)
        files[f"worlds/{name}.sdf"] = element_xml('sdf version="1.9"', world)
    if robot:
        files["cart.urdf"] = element_xml('robot name="cart"', *robot)
    return {path: text.encode() for path, text in files.items()}


def nav2_launch(package: str, executable: str, parameters: str) -> str:
    """A launch file with a node of Nav2, its parameters in Python, and a lifecycle manager."""
    return f"""\
from launch_ros.actions import Node

nodes = [
    Node(package="{package}", executable="{executable}", parameters=[{parameters}]),
    Node(
        package="nav2_lifecycle_manager",
        executable="lifecycle_manager",
        parameters=[{{"autostart": True, "node_names": ["{executable}"]}}],
    ),
]
"""
