"""Frames and joint states of launch files that are right."""

from pathlib import Path

import pytest

from tests.launched import reported
from tests.naming import naming
from tests.workspaces import add_file, add_package

_FILTER = (
    "from launch_ros.actions import Node\n"
    "nodes = [\n"
    "    Node(package='robot_state_publisher', executable='robot_state_publisher',\n"
    "         parameters=[{'robot_description': open('../robot.urdf').read()}]),\n"
    "    Node(package='tf2_ros', executable='static_transform_publisher',\n"
    "         arguments=['--frame-id', 'pole', '--child-frame-id', 'imu']),\n"
    "    Node(package='robot_localization', executable='ekf_node', parameters=['../ekf.yaml']),\n"
    "]\n"
)


@pytest.mark.parametrize(
    ("name", "program", "child", "count"),
    [
        ("map", "", "imu", 1),
        ("pole", "", "imu", 0),
        ("map", 'frame = "pole"', "imu", 0),
        ("map", "", "base", 0),
    ],
)
def test_frames_that_others_publish(
    tmp_path: Path, name: str, program: str, child: str, count: int
) -> None:
    """A filter of its own tree (bumperbot), CMU's `sensor`, and a footprint above the robot."""
    files = {
        "robot.urdf": '<robot name="r"><link name="base"/></robot>',
        "ekf.yaml": f"ekf:\n  ros__parameters:\n    base_link_frame: {name}\n",
        "src/node.py": program,
    }
    text = _FILTER.replace("'imu'", f"'{child}'")
    assert len(reported(tmp_path / "arm", "LAU023", "a.launch.py", text, files)) == count


@pytest.mark.parametrize(
    ("package", "suffix", "count"),
    [("astra_camera", "_link", 0), ("astra_camera", "_frame", 1), ("tf2_ros", "_link", 1)],
)
def test_a_driver_in_the_workspace_that_composes_its_frames(
    tmp_path: Path, package: str, suffix: str, count: int
) -> None:
    """astra_camera, next to the robot: camera_name + "_link" is a frame of the camera."""
    files = {
        "robot.urdf": '<robot name="r"><link name="base"/></robot>',
        "launch/robot.launch.xml": (
            '<launch><node pkg="robot_state_publisher" exec="robot_state_publisher">'
            '<param name="robot_description" value="$(command \'cat $(dirname)/../robot.urdf\')"/>'
            "</node></launch>"
        ),
    }
    driver = add_package(tmp_path / "astra_camera", "astra_camera")
    add_file(driver / "src/camera.cpp", f'frame_ = camera_name_ + "{suffix}";'.encode())
    text = (
        f'<node pkg="{package}" exec="camera"/><node pkg="tf2_ros" '
        'exec="static_transform_publisher" args="0 0 0 0 0 0 camera1_link camera2_link"/>'
    )
    found = reported(tmp_path / "arm", "LAU023", "a.launch.xml", text, files)
    parent = naming("camera1_link", "static")
    assert [one.message for one in found] == [parent] * count  # its child is no suggestion


@pytest.mark.parametrize(("package", "count"), [("realsense2_camera", 0), ("arm", 1)])
def test_a_camera_that_names_its_frames_itself(tmp_path: Path, package: str, count: int) -> None:
    """realsense-ros in the workspace of a Go2: its driver makes camera1_link from camera_name."""
    files = {
        "robot.urdf": '<robot name="r"><link name="base"/></robot>',
        "launch/robot.launch.py": (
            "nodes = [Node(package='robot_state_publisher', executable='robot_state_publisher',\n"
            "    parameters=[{'robot_description': open('../robot.urdf').read()}])]\n"
        ),
        "launch/camera.launch.py": f"nodes = [Node(package='{package}', executable='camera')]\n",
    }
    text = (
        "nodes = [IncludeLaunchDescription(PythonLaunchDescriptionSource("
        "[ThisLaunchFileDir(), '/camera.launch.py'])),\n"
        "    Node(package='tf2_ros', executable='static_transform_publisher',\n"
        "         arguments=['0', '0', '0', '0', '0', '0', 'camera1_link', 'camera2_link'])]\n"
    )
    add_package(tmp_path / "realsense2_camera", "realsense2_camera")
    assert len(reported(tmp_path / "arm", "LAU023", "a.launch.py", text, files)) == count


@pytest.mark.parametrize(("namespace", "count"), [("/stick", 0), ("/", 1)])
def test_joint_states_of_two_namespaces(tmp_path: Path, namespace: str, count: int) -> None:
    """sensor_stick: its controllers, and so their topics, are in /sensor_stick."""
    text = (
        '<node name="j" pkg="joint_state_publisher" type="joint_state_publisher"/>'
        f'<node name="s" pkg="controller_manager" type="spawner" ns="{namespace}" '
        'args="joint_state_controller"/>'
    )
    assert len(reported(tmp_path / "arm", "LAU021", "a.launch", text)) == count


@pytest.mark.parametrize(("default", "count"), [(", default='laser'", 0), (", default='rotor'", 1)])
def test_an_argument_whose_default_is_its_own_configuration(
    tmp_path: Path, default: str, count: int
) -> None:
    """rplidar_ros: the node stamps its scans with the frame, which no transform has."""
    robot = '<robot name="r"><link name="base_link"/></robot>'
    display = "Visualization Manager:\n  Global Options:\n    Fixed Frame: laser\n"
    files = {"r.urdf": robot, "r.rviz": display}
    add_package(tmp_path / "rplidar_ros", "rplidar_ros")
    text = (
        "from launch import LaunchDescription\n"
        "from launch.actions import DeclareLaunchArgument\n"
        "from launch.substitutions import LaunchConfiguration\n"
        "from launch_ros.actions import Node\n"
        "def generate_launch_description():\n"
        f"    frame_id = LaunchConfiguration('frame_id'{default})\n"
        "    return LaunchDescription([\n"
        "        DeclareLaunchArgument('frame_id', default_value=frame_id),\n"
        "        Node(package='robot_state_publisher', executable='robot_state_publisher',\n"
        "             parameters=[{'robot_description': open('../r.urdf').read()}]),\n"
        "        Node(package='rplidar_ros', executable='rplidar_node',\n"
        "             parameters=[{'frame_id': frame_id}]),\n"
        "        Node(package='rviz2', executable='rviz2', arguments=['-d', '../r.rviz'])])\n"
    )
    found = reported(tmp_path / "arm", "LAU023", "a.launch.py", text, files)
    assert len([one for one in found if one.span.source.path.endswith(".rviz")]) == count


@pytest.mark.parametrize(("child", "count"), [("names['camera'] + '_link'", 0), ("'tip'", 1)])
def test_a_static_transform_to_a_frame_known_at_run_time(
    tmp_path: Path, child: str, count: int
) -> None:
    """realsense-ros: the frames of two cameras are named after arguments of another file."""
    robot = '<robot name="r"><link name="base_link"/></robot>'
    display = "Visualization Manager:\n  Global Options:\n    Fixed Frame: camera1_link\n"
    text = (
        "from launch import LaunchDescription\n"
        "from launch_ros.actions import Node\n"
        "from names import names\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([\n"
        "        Node(package='robot_state_publisher', executable='robot_state_publisher',\n"
        "             parameters=[{'robot_description': open('../r.urdf').read()}]),\n"
        "        Node(package='tf2_ros', executable='static_transform_publisher',\n"
        f"             arguments=['0', '0', '0', '0', '0', '0', 'base_link', {child}]),\n"
        "        Node(package='rviz2', executable='rviz2', arguments=['-d', '../r.rviz'])])\n"
    )
    files = {"r.urdf": robot, "r.rviz": display}
    assert len(reported(tmp_path / "arm", "LAU023", "a.launch.py", text, files)) == count


@pytest.mark.parametrize(("child", "count"), [("optical", 0), ("other", 1)])
def test_the_frame_of_gazebo_above_a_link_of_another_launch_file(
    tmp_path: Path, child: str, count: int
) -> None:
    """ros2_amr: 'did you mean' named the frame itself; LAU021 reports the two parents."""
    files = {
        "robot.urdf": '<robot name="r"><link name="optical"/></robot>',
        "launch/robot.launch.py": _FILTER.partition("    Node(package='tf2_ros'")[0] + "]\n",
    }
    text = (
        "from launch_ros.actions import Node\n"
        "nodes = [Node(package='tf2_ros', executable='static_transform_publisher',\n"
        f"    arguments=['--frame-id', 'amr/base/camera', '--child-frame-id', '{child}'])]\n"
    )
    assert len(reported(tmp_path / "arm", "LAU023", "a.launch.py", text, files)) == count


@pytest.mark.parametrize(
    ("parameter", "count"), [("tf_prefix", 0), ("frame_prefix", 0), ("publish_frequency", 1)]
)
def test_several_robots_whose_frames_have_prefixes(
    tmp_path: Path, parameter: str, count: int
) -> None:
    """HeRo: four robots of one description, each with its `tf_prefix`, which Noetic has again."""
    node = (
        '<node pkg="robot_state_publisher" type="robot_state_publisher" name="of_{0}">'
        '<param name="{1}" value="1{0}"/></node>'
    )
    text = '<param name="robot_description" textfile="$(dirname)/../robot.urdf"/>'
    text += "".join(node.format(number, parameter) for number in range(2))
    files = {"robot.urdf": '<robot name="r"><link name="base"/></robot>'}
    assert len(reported(tmp_path / "arm", "LAU021", "a.launch", text, files)) == count
