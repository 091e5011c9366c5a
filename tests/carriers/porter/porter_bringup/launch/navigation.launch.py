"""Planner and controller of Nav2; the porter itself is started by another file."""

import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node

NODES = ["controller_server", "planner_server"]


def generate_launch_description():
    share = get_package_share_directory("porter_bringup")
    parameters = os.path.join(share, "config", "nav2.yaml")
    controller = Node(
        package="nav2_controller",
        executable="controller_server",
        parameters=[parameters],
        remappings=[("cmd_vel", "/base_controller/cmd_vel")],
    )
    planner = Node(
        package="nav2_planner",
        executable="planner_server",
        parameters=[parameters],
    )
    manager = Node(
        package="nav2_lifecycle_manager",
        executable="lifecycle_manager",
        name="lifecycle_manager_navigation",
        parameters=[{"use_sim_time": True, "autostart": True, "node_names": NODES}],
    )
    return LaunchDescription([controller, planner, manager])
