"""A drone in Gazebo, and the bridge to its sensors and commands."""

import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import Command
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue


def generate_launch_description():
    share = get_package_share_directory("drone")
    world = os.path.join(share, "worlds", "field.sdf")
    robot = ParameterValue(
        Command(["xacro ", os.path.join(share, "urdf", "drone.urdf.xacro")]), value_type=str
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
        arguments=["-topic", "robot_description", "-name", "drone", "-z", "0.1"],
    )
    bridge = Node(
        package="ros_gz_bridge",
        executable="parameter_bridge",
        arguments=[
            "/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock",
            "/imu@sensor_msgs/msg/Imu[gz.msgs.IMU",
            "/gps@sensor_msgs/msg/NavSatFix[gz.msgs.NavSat",
            "/camera@sensor_msgs/msg/Image[gz.msgs.Image",
            "/camera_info@sensor_msgs/msg/CameraInfo[gz.msgs.CameraInfo",
            "/tf@tf2_msgs/msg/TFMessage[gz.msgs.Pose_V",
            "/odom@nav_msgs/msg/Odometry[gz.msgs.Odometry",
            "/drone/cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist",
            "/drone/enable@std_msgs/msg/Bool]gz.msgs.Boolean",
        ],
    )
    map_frame = Node(
        package="tf2_ros",
        executable="static_transform_publisher",
        arguments=["--frame-id", "map", "--child-frame-id", "odom"],
    )
    return LaunchDescription([gazebo, rsp, spawn, bridge, map_frame])
