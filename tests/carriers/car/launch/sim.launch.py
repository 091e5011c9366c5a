"""A car that steers two wheels, in Gazebo with ros2_control."""

import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription, RegisterEventHandler
from launch.event_handlers import OnProcessExit
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import Command
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue


def generate_launch_description():
    share = get_package_share_directory("car")
    world = os.path.join(share, "worlds", "field.sdf")
    robot = ParameterValue(
        Command(["xacro ", os.path.join(share, "urdf", "car.urdf.xacro")]), value_type=str
    )
    gazebo = IncludeLaunchDescription(
        PythonLaunchDescriptionSource(
            os.path.join(get_package_share_directory("ros_gz_sim"), "launch", "gz_sim.launch.py")
        ),
        launch_arguments={"gz_args": ["-r ", world]}.items(),
    )
    rsp = Node(
        package="robot_state_publisher",
        executable="robot_state_publisher",
        parameters=[{"robot_description": robot, "use_sim_time": True}],
    )
    spawn = Node(
        package="ros_gz_sim",
        executable="create",
        arguments=["-topic", "robot_description", "-name", "car", "-z", "0.01"],
    )
    bridge = Node(
        package="ros_gz_bridge",
        executable="parameter_bridge",
        arguments=["/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock"],
    )
    broadcaster = Node(
        package="controller_manager",
        executable="spawner",
        arguments=["joint_state_broadcaster"],
    )
    ackermann = Node(
        package="controller_manager",
        executable="spawner",
        arguments=[
            "ackermann_controller",
            "--param-file",
            os.path.join(share, "config", "controllers.yaml"),
        ],
    )
    ekf = Node(
        package="robot_localization",
        executable="ekf_node",
        name="ekf_filter_node",
        parameters=[os.path.join(share, "config", "ekf.yaml")],
    )
    then = RegisterEventHandler(OnProcessExit(target_action=broadcaster, on_exit=[ackermann]))
    return LaunchDescription([gazebo, rsp, spawn, bridge, broadcaster, then, ekf])
