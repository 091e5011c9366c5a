"""MoveIt and ros2_control of an arm, without MoveItConfigsBuilder."""

import os

import yaml
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.substitutions import Command
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue


def load_yaml(package, path):
    with open(os.path.join(get_package_share_directory(package), path)) as file:
        return yaml.safe_load(file)


def generate_launch_description():
    share = get_package_share_directory("arm")
    robot_description = {
        "robot_description": ParameterValue(
            Command(["xacro ", os.path.join(share, "urdf", "arm.urdf.xacro")]), value_type=str
        )
    }
    with open(os.path.join(share, "config", "arm.srdf")) as file:
        semantic = {"robot_description_semantic": file.read()}
    kinematics = {"robot_description_kinematics": load_yaml("arm", "config/kinematics.yaml")}
    limits = {"robot_description_planning": load_yaml("arm", "config/joint_limits.yaml")}
    pipelines = {
        "planning_pipelines": ["ompl"],
        "default_planning_pipeline": "ompl",
        "ompl": load_yaml("arm", "config/ompl_planning.yaml"),
    }
    move_group = Node(
        package="moveit_ros_move_group",
        executable="move_group",
        output="screen",
        parameters=[
            robot_description,
            semantic,
            kinematics,
            limits,
            pipelines,
            load_yaml("arm", "config/moveit_controllers.yaml"),
        ],
    )
    rsp = Node(
        package="robot_state_publisher",
        executable="robot_state_publisher",
        parameters=[robot_description],
    )
    control = Node(
        package="controller_manager",
        executable="ros2_control_node",
        parameters=[os.path.join(share, "config", "ros2_controllers.yaml")],
    )
    spawner = Node(
        package="controller_manager",
        executable="spawner",
        arguments=["joint_state_broadcaster", "arm_controller", "hand_controller"],
    )
    rviz = Node(
        package="rviz2",
        executable="rviz2",
        arguments=["-d", os.path.join(share, "rviz", "moveit.rviz")],
        parameters=[robot_description, semantic, kinematics, limits],
    )
    return LaunchDescription([move_group, rsp, control, spawner, rviz])
