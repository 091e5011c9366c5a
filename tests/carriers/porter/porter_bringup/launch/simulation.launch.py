"""The porter in Gazebo, with its controllers, sensors and RViz."""

import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import Command, LaunchConfiguration
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue


def generate_launch_description():
    description = get_package_share_directory("porter_description")
    bringup = get_package_share_directory("porter_bringup")
    xacro = os.path.join(description, "urdf", "porter.urdf.xacro")
    world = os.path.join(bringup, "worlds", "depot.sdf")
    use_sim_time = LaunchConfiguration("use_sim_time")
    robot = ParameterValue(Command(["xacro ", xacro, " sim:=true"]), value_type=str)

    gazebo = IncludeLaunchDescription(
        PythonLaunchDescriptionSource(
            os.path.join(get_package_share_directory("ros_gz_sim"), "launch", "gz_sim.launch.py")
        ),
        launch_arguments={"gz_args": ["-r ", world]}.items(),
    )
    robot_state_publisher = Node(
        package="robot_state_publisher",
        executable="robot_state_publisher",
        parameters=[{"robot_description": robot, "use_sim_time": use_sim_time}],
    )
    spawn = Node(
        package="ros_gz_sim",
        executable="create",
        arguments=["-topic", "robot_description", "-name", "porter", "-z", "0.01"],
    )
    bridge = Node(
        package="ros_gz_bridge",
        executable="parameter_bridge",
        parameters=[
            {
                "config_file": os.path.join(bringup, "config", "bridge.yaml"),
                "use_sim_time": use_sim_time,
            }
        ],
    )
    joint_state_broadcaster = Node(
        package="controller_manager",
        executable="spawner",
        arguments=["joint_state_broadcaster", "--controller-manager", "/controller_manager"],
    )
    base_controller = Node(
        package="controller_manager",
        executable="spawner",
        arguments=["base_controller"],
    )
    arm_controllers = Node(
        package="controller_manager",
        executable="spawner",
        arguments=["arm_controller", "gripper_controller"],
    )
    ekf = Node(
        package="robot_localization",
        executable="ekf_node",
        name="ekf_filter_node",
        parameters=[
            os.path.join(bringup, "config", "ekf.yaml"),
            {"use_sim_time": use_sim_time},
        ],
    )
    rviz = Node(
        package="rviz2",
        executable="rviz2",
        arguments=["-d", os.path.join(bringup, "rviz", "porter.rviz")],
        parameters=[{"use_sim_time": use_sim_time}],
    )
    return LaunchDescription(
        [
            DeclareLaunchArgument("use_sim_time", default_value="true"),
            gazebo,
            robot_state_publisher,
            spawn,
            bridge,
            joint_state_broadcaster,
            base_controller,
            arm_controllers,
            ekf,
            rviz,
        ]
    )
