"""MoveIt's planning for the porter."""

import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node
from moveit_configs_utils import MoveItConfigsBuilder


def generate_launch_description():
    description = get_package_share_directory("porter_description")
    config = (
        MoveItConfigsBuilder("porter", package_name="porter_moveit_config")
        .robot_description(os.path.join(description, "urdf", "porter.urdf.xacro"))
        .robot_description_semantic(file_path="config/porter.srdf")
        .joint_limits(file_path="config/joint_limits.yaml")
        .robot_description_kinematics(file_path="config/kinematics.yaml")
        .trajectory_execution(file_path="config/moveit_controllers.yaml")
        .planning_pipelines(pipelines=["ompl"])
        .to_moveit_configs()
    )
    move_group = Node(
        package="moveit_ros_move_group",
        executable="move_group",
        parameters=[config.to_dict(), {"use_sim_time": True}],
    )
    return LaunchDescription([move_group])
