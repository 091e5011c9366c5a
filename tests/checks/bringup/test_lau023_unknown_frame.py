"""LAU023: see the rule."""

from pathlib import Path

import pytest

from tests.launched import reported
from tests.naming import naming
from tests.workspaces import add_files
from urdfkit import check

ROBOT = """<robot name="r"><link name="base_link"/><link name="lidar"/>
<joint name="j" type="fixed"><parent link="base_link"/><child link="lidar"/></joint></robot>"""
HEAD = "from launch_ros.actions import Node\n"
PUBLISHER = """Node(package="robot_state_publisher", executable="robot_state_publisher",
     parameters=[{{"robot_description": open("../r.urdf").read(){}}}])
"""
FILTER = 'Node(package="robot_localization", executable="ekf_node", parameters=["../f.yaml"{}])\n'
RVIZ = 'Node(package="rviz2", executable="rviz2", arguments=["-d", "../v.rviz"])\n'
SLIDERS = 'Node(package="joint_state_publisher_gui", executable="joint_state_publisher_gui")\n'
STATIC = """Node(package="tf2_ros", executable="static_transform_publisher",
     arguments=["--frame-id", "{}", "--child-frame-id", "{}"])
"""
VIEW = """Visualization Manager:
  Global Options: {{Fixed Frame: {}}}
  Displays:
    - {{Class: rviz_default_plugins/Axes, Enabled: {}, Reference Frame: {}}}
"""


def messages(directory: Path, text: str, *, other: str = "", **files: str) -> list[str]:
    data = {"r.urdf": ROBOT, **{name.replace("_", "."): text for name, text in files.items()}}
    if other:
        data["launch/other.launch.py"] = HEAD + other
    return [one.message for one in reported(directory, "LAU023", "a.launch.py", HEAD + text, data)]


@pytest.mark.parametrize(
    ("frame", "count"),
    [
        ("base_link_frame: base_link", 0),
        ("base_link_frame: /base_link", 0),
        ("base_link_frame: base", 1),
        ("base_link_frame: $(var base)", 0),
        ("base_link_frame: ''", 0),
        ("costmap: {robot_base_frame: chassis}", 1),
        ("base_frame_id: link", 1),
        ("{camera_name: arm, base_frame_id: link}", 0),  # realsense2_camera: arm_link
        ("odom_frame: odometry", 0),
        ("{base_link_frame: base_link, odom_frame: o, map_frame: m, world_frame: o}", 0),
        ("{base_link_frame: base_link, odom_frame: o, map_frame: m, world_frame: w}", 1),
    ],
)
def test_parameters(tmp_path: Path, frame: str, count: int) -> None:
    text = f"ekf:\n  ros__parameters:\n    {frame}\n"
    assert len(messages(tmp_path, PUBLISHER.format("") + FILTER.format(""), f_yaml=text)) == count


@pytest.mark.parametrize(
    ("node", "count"),
    [("amcl", 1), ("local_costmap/local_costmap", 1), ("ekf", 0), ("drive", 0)],
)
def test_a_leading_slash(tmp_path: Path, node: str, count: int) -> None:
    """tf2 rejects it; robot_localization removes it, and of a drive it is removed elsewhere."""
    text = f"{node}: {{ros__parameters: {{base_frame_id: /base_link}}}}\n"
    found = messages(tmp_path, PUBLISHER.format("") + FILTER.format(""), f_yaml=text)
    assert found == [naming("base_frame_id", "/base_link", "tf2")] * count


SLAM = 'Node(package="slam_toolbox", executable="async_slam_toolbox_node"{})\n'
INCLUDED_SLAM = """IncludeLaunchDescription(PythonLaunchDescriptionSource(
    get_package_share_directory("slam_toolbox") + "/launch/online_async_launch.py"){})
"""


@pytest.mark.parametrize(
    ("text", "count"),
    [
        (SLAM.format(""), 1),
        (SLAM.format(', parameters=[{"use_sim_time": True}]'), 1),
        (SLAM.format(', parameters=[{"base_frame": "base_link"}]'), 0),
        (SLAM.format(', parameters=[{"base_frame": x}]'), 0),
        (SLAM.format(', parameters=["../f.yaml"]'), 0),
        (SLAM.format(", parameters=[x]"), 0),
        (SLAM.format("") + STATIC.format("base_link", "base_footprint"), 0),
        (INCLUDED_SLAM.format(""), 1),
        (INCLUDED_SLAM.format(', launch_arguments={"slam_params_file": x}.items()'), 0),
    ],
)
def test_default_frames(tmp_path: Path, text: str, count: int) -> None:
    file = "slam_toolbox:\n  ros__parameters:\n    base_frame: base_link\n"
    found = messages(tmp_path, PUBLISHER.format("") + text, f_yaml=file)
    assert ["'base_footprint' is neither" in one for one in found] == [True] * count


@pytest.mark.parametrize(
    ("text", "other", "count"),
    [
        (FILTER.format(""), PUBLISHER.format(""), 1),  # that another launch file publishes
        (FILTER.format(""), "", 0),  # unknown robot
        (FILTER.format("") + PUBLISHER.format(", 'frame_prefix': 'a/'"), "", 1),
        (FILTER.format("") + PUBLISHER.format(", 'frame_prefix': x"), "", 0),
        (FILTER.format(', {"base_link_frame": "base_link"}') + PUBLISHER.format(""), "", 0),
        (FILTER.format("") + PUBLISHER.format("") + STATIC.format("base_link", "base"), "", 0),
    ],
)
def test_published_topics(tmp_path: Path, text: str, other: str, count: int) -> None:
    file = "ekf:\n  ros__parameters:\n    base_link_frame: base\n"
    assert len(messages(tmp_path, text, other=other, f_yaml=file)) == count


@pytest.mark.parametrize(
    ("fixed", "is_on", "frame", "started", "count"),
    [
        ("base_link", "true", "lidar", RVIZ, 0),
        ("base", "true", "lidar", RVIZ, 1),
        ("base_link", "true", "laser", RVIZ, 1),
        ("base_link", "false", "laser", RVIZ, 0),
        ("base_link", "true", "<Fixed Frame>", RVIZ, 0),
        ("map", "true", "lidar", RVIZ, 0),
        ("map", "true", "lidar", RVIZ + SLIDERS, 1),  # nothing localizes the robot
        ("map", "true", "lidar", RVIZ + FILTER.format(""), 0),
    ],
)
def test_rviz(tmp_path: Path, fixed: str, is_on: str, frame: str, started: str, count: int) -> None:
    view = VIEW.format(fixed, is_on, frame)
    assert len(messages(tmp_path, PUBLISHER.format("") + started, v_rviz=view)) == count


@pytest.mark.parametrize(
    ("program", "count"),
    [
        ('goal.header.frame_id = "map"', 1),  # only names it
        ('msg.header.frame_id = "map"\nTransformBroadcaster(self).sendTransform(msg)', 0),
    ],
)
def test_a_map_that_a_program_publishes(tmp_path: Path, program: str, count: int) -> None:
    view = VIEW.format("map", "true", "lidar")
    text = PUBLISHER.format("") + RVIZ + SLIDERS
    assert len(messages(tmp_path, text, v_rviz=view, node_py=program)) == count


SLAM = "Node(package='slam_toolbox', executable='async_slam_toolbox_node')\n"
BRIDGE = "Node(package='ros_gz_bridge', executable='parameter_bridge', arguments=[{}])\n"
SIMULATED = BRIDGE.format("'/scan@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan'") + (
    "Node(package='ros_gz_sim', executable='create', arguments=['-topic', 'robot_description'])\n"
    "Node(package='controller_manager', executable='spawner', arguments=['arm'])\n"
    "Node(package='moveit_ros_move_group', executable='move_group')\n"
)


@pytest.mark.parametrize(
    ("more", "count"),
    [
        (SLAM, 1),
        ("", 0),  # not localized
        (
            SLAM + "Node(package='mocap', executable='node')\n",
            0,
        ),
        (SLAM + STATIC.format("world", "map"), 0),
        (SLAM + SIMULATED, 1),
        (SLAM + SIMULATED + BRIDGE.format("'/tf@tf2_msgs/msg/TFMessage[gz.msgs.Pose_V'"), 0),
        (SLAM + SIMULATED + BRIDGE.format("topic"), 0),
    ],
)
def test_the_world_in_rviz(tmp_path: Path, more: str, count: int) -> None:
    view = VIEW.format("world", "true", "lidar")
    found = messages(tmp_path, PUBLISHER.format("") + RVIZ + more, v_rviz=view)
    assert sum("'world'" in one for one in found) == count


@pytest.mark.parametrize(("parent", "count"), [("base_link", 0), ("map", 0), ("chassis", 1)])
def test_static_transforms(tmp_path: Path, parent: str, count: int) -> None:
    text = PUBLISHER.format("") + STATIC.format(parent, "tag") + STATIC.format("tag", "eye")
    assert len(messages(tmp_path, text)) == count


def test_the_prefix_is_in_the_names_of_the_links(tmp_path: Path) -> None:
    """ardacihan/leo_rover_gazebo: a loop starts leo1 and leo2."""
    robot = ROBOT.replace("base_link", "leo1/base_link").replace("lidar", "leo1/lidar")
    text = PUBLISHER.format("") + STATIC.format("leo1/lidar", "leo1/base_footprint/gpu_lidar")
    assert messages(tmp_path, text, r_urdf=robot) == []


def test_a_root_above_the_robot(tmp_path: Path) -> None:
    text = PUBLISHER.format("") + STATIC.format("cell", "base_link")
    assert messages(tmp_path, text) == []


@pytest.mark.parametrize(("text", "count"), [("", 0), (PUBLISHER.format(""), 1)])
def test_a_robot_that_another_launch_file_starts_in_a_namespace(
    tmp_path: Path, text: str, count: int
) -> None:
    frame = "ekf: {ros__parameters: {base_link_frame: leo1/base_link}}\n"
    found = messages(tmp_path, text + FILTER.format(""), other=PUBLISHER.format(""), f_yaml=frame)
    assert len(found) == count


def test_a_robot_in_sdf_is_not_known(tmp_path: Path) -> None:
    sdf = PUBLISHER.format("").replace("r.urdf", "model.sdf")
    frame = "ekf: {ros__parameters: {base_link_frame: chassis}}\n"
    assert not messages(tmp_path, sdf + FILTER.format(""), other=PUBLISHER.format(""), f_yaml=frame)


@pytest.mark.parametrize(
    ("prefix", "frame", "count"),
    [
        (', "frame_prefix": "r/"', "base_link", 1),
        (', "frame_prefix": "r/"', "r/base_link", 0),
        (', "frame_prefix": "/"', "base_link", 0),  # as TurtleBot 3 writes it; tf2 strips it
        (', "frame_prefix": "/r/"', "base_link", 1),
        (', "frame_prefix": LaunchConfiguration("p")', "base_link", 0),
        ('}], remappings=[("a", "b")]) #', "r/base_link", 1),
    ],
)
def test_the_prefix_of_frames(tmp_path: Path, prefix: str, frame: str, count: int) -> None:
    text = f"ekf:\n  ros__parameters:\n    base_link_frame: {frame}\n"
    program = PUBLISHER.format(prefix) + FILTER.format("")
    data = {"r.urdf": ROBOT, "f.yaml": text}
    found = reported(tmp_path, "LAU023", "a.launch.py", HEAD + program, data)
    assert len(found) == count
    if prefix.startswith(', "frame_prefix": "r/"') and found:
        assert found[0].help == naming("r/base_link", "frame_prefix", "robot_state_publisher")


def test_frames_that_a_launch_file_rewrites(tmp_path: Path) -> None:
    text = "ekf:\n  ros__parameters:\n    base_link_frame: base_link\n"
    program = PUBLISHER.format(', "frame_prefix": "r/"') + FILTER.format("")
    assert messages(tmp_path, program + "# RewrittenYaml\n", f_yaml=text) == []


@pytest.mark.parametrize(
    ("build", "depends", "count"),
    [("add_executable(driver driver.cpp)", "", 0), ("", "", 1), ("add_library(a)", "arm", 1)],
)
def test_the_frame_of_a_driver(tmp_path: Path, build: str, depends: str, count: int) -> None:
    """Ouster's and Livox's drivers in the workspace of a robot: RViz shows their own frames."""
    (tmp_path / "LICENSE").touch()
    files = {"r.urdf": ROBOT}
    text = HEAD + PUBLISHER.format("")
    assert reported(tmp_path / "arm", "LAU023", "a.launch.py", text, files) == []
    depend = f"<exec_depend>{depends}</exec_depend>" if depends else ""
    driver = {
        "package.xml": f"<package><name>lidar</name>{depend}</package>",
        "CMakeLists.txt": f"project(lidar)\n{build}\n",
        "v.rviz": VIEW.format("lidar_frame", "false", "base_link"),
        "launch/v.launch.py": HEAD + RVIZ,
    }
    add_files(tmp_path / "lidar", driver)
    report = check(tmp_path / "lidar" / "launch" / "v.launch.py", select=["LAU023"])
    assert len(report.diagnostics) == count


def test_a_robot_whose_base_an_argument_chooses(tmp_path: Path) -> None:
    """A kit for several vehicles: without an argument, it has no base."""
    part = ROBOT.replace('<link name="base_link"/>', "")
    view = VIEW.format("base_link", "false", "base_link")
    assert messages(tmp_path, PUBLISHER.format("") + RVIZ, v_rviz=view, r_urdf=part) == []


@pytest.mark.parametrize(
    ("program", "count"),
    [
        ("rate = 5", 1),
        ("from tf2_ros import TransformBroadcaster", 0),
        ("tf = node.create_publisher(TFMessage, '/tf', 10)", 0),
        ("", 0),  # it may publish transforms
    ],
)
def test_the_world_next_to_an_own_program(tmp_path: Path, program: str, count: int) -> None:
    data = {
        "r.urdf": ROBOT,
        "v.rviz": VIEW.format("world", "true", "lidar"),
        "src/mine/package.xml": "<package><name>mine</name></package>",
    }
    data |= {"src/mine/watch.py": program} if program else {}
    text = HEAD + PUBLISHER.format("") + RVIZ + SLAM + "Node(package='mine', executable='watch')\n"
    found = [one.message for one in reported(tmp_path, "LAU023", "a.launch.py", text, data)]
    assert sum("'world'" in one for one in found) == count
