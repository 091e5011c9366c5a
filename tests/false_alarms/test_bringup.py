"""Robots with a bring-up: what is known at run time, is elsewhere, or comes from others."""

from pathlib import Path

import pytest

from tests.launched import MANIFEST, launch, reported
from tests.naming import naming
from tests.workspaces import add_file
from urdfkit import Diagnostic, check
from urdfkit.ros.launch.samples import nav2_launch
from urdfkit.text.diagnostic import Confidence

ROBOT = """<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:arg name="cell" default="false"/><link name="base"/><link name="world"/>
<xacro:if value="$(arg cell)"><joint name="j" type="fixed"><parent link="world"/>
<child link="base"/></joint></xacro:if></robot>
"""
START = """import os, xacro
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    {choice}
    path = os.path.join(get_package_share_directory("arm"), "arm.xacro")
    doc = xacro.parse(open(path))
    xacro.process_doc(doc, mappings={{"cell": cell}})
    return LaunchDescription([Node(package="robot_state_publisher", name="p",
        executable="robot_state_publisher", parameters=[{{"robot_description": doc.toxml()}}])])
"""


def errors(directory: Path, choice: str, robot: str = ROBOT) -> list[Diagnostic]:
    files = {"arm.xacro": robot}
    text = START.format(choice=choice)
    found = reported(directory, "LAU004", "a.launch.py", text, files)
    return [*found, *check(directory / "arm.xacro", select=["TRE002", "XAC001"]).diagnostics]


@pytest.mark.parametrize(
    ("choice", "severity"),
    [("cell = input()", "warning"), ("cell = 'true'", "warning"), ("cell = 'false'", "error")],
)
def test_parts_that_are_chosen_by_the_launch_file(
    tmp_path: Path, choice: str, severity: str
) -> None:
    """IFRA's robots: the launch file asks for the cell, or sets it, and the default is none."""
    (found,) = errors(tmp_path / "arm", choice)
    assert (found.code, found.severity.value) == ("TRE002", severity)
    assert (found.confidence is Confidence.GUESSED) == (severity == "warning")
    assert found.variants == (("the default of cell",) if severity == "warning" else ())


def test_parts_of_a_default_that_another_launch_file_uses(tmp_path: Path) -> None:
    found = errors(tmp_path / "arm", "cell = 'true'")
    assert [one.severity.value for one in found] == ["warning"]
    (tmp_path / "arm" / "launch" / "b.launch.py").write_text(
        START.format(choice="").replace(', mappings={"cell": cell}', "")
    )
    found = errors(tmp_path / "arm", "cell = 'true'")
    assert [one.severity.value for one in found] == ["error"]


def test_parts_that_one_of_two_launch_files_chooses_at_run_time(tmp_path: Path) -> None:
    """Monash Nova Rover: a launch file passes on arguments that it does not declare."""
    robot = ROBOT.replace("<link", '<xacro:arg name="base" default="base"/><link', 1)
    robot = robot.replace('"base"/><link name="world', '"$(arg base)"/><link name="world')
    robot = robot.replace('<child link="base"/>', '<child link="$(arg base)"/>')
    errors(tmp_path / "arm", "cell = 'true'", robot)
    text = START.format(choice="cell = input()").replace('": cell', '": cell, "base": "b"')
    (tmp_path / "arm" / "launch" / "b.launch.py").write_text(text)
    found = check(tmp_path / "arm" / "arm.xacro", select=["TRE002"]).diagnostics
    assert {one.severity.value for one in found} == {"warning"}
    assert len(found) == 1


def test_a_typo_does_not_depend_on_what_is_chosen(tmp_path: Path) -> None:
    joint = '<joint name="k" type="fixed"><parent link="wolrd"/><child link="tip"/></joint>'
    robot = ROBOT.replace("<xacro:if", f'<link name="tip"/>{joint}<xacro:if')
    errors(tmp_path / "arm", "cell = input()", robot)
    (found,) = check(tmp_path / "arm" / "arm.xacro", select=["REF001"]).diagnostics
    assert (found.severity.value, found.fix is None) == ("error", False)


def test_a_default_that_does_not_expand(tmp_path: Path) -> None:
    """ReseQ: the launch file makes the parameter file; the default lacks what it adds."""
    robot = ROBOT.replace('value="$(arg cell)"', "value=\"${dict(false=0)['$(arg cell)x']}\"")
    found = errors(tmp_path / "arm", "cell = input()", robot)
    assert {(one.code, one.severity.value) for one in found} == {("XAC001", "warning")}


URDF = '<robot name="r"><link name="a"><visual><geometry><mesh filename="{}"/></geometry>'
END = "</visual></link></robot>"


@pytest.mark.parametrize(
    ("file", "severity"),
    [
        ("file:///opt/ros/nowhere/share/arm/a.stl", "warning"),
        ("/opt/vendor/nowhere/share/arm/a.stl", "warning"),
        ("/usr/share/nowhere_description/a.stl", "warning"),
        ("file:///home/nobody/ws/install/arm/share/arm/a.stl", "error"),
    ],
)
def test_meshes_of_an_installation_that_this_computer_lacks(
    tmp_path: Path, file: str, severity: str
) -> None:
    (tmp_path / "r.urdf").write_text(URDF.format(file) + END)
    (found,) = check(tmp_path / "r.urdf", select=["MSH001"]).diagnostics
    assert found.severity.value == severity


@pytest.mark.parametrize(("name", "severity"), [("a", "error"), ("a_template", "info")])
def test_templates_of_launch_files(tmp_path: Path, name: str, severity: str) -> None:
    """The plugin loader of `gazebo-pkgs`, whose user writes a package for `<your-package>`."""
    text = '<rosparam ns="<your-package>" file="$(find <your-package>)/config/a.yaml"/>'
    (found,) = reported(tmp_path / "arm", "LAU001", f"{name}.launch", text)
    assert found.severity.value == severity


PUBLISHER = """
<param name="robot_description" command="xacro $(dirname)/../r.urdf"/>
<node pkg="robot_state_publisher" exec="robot_state_publisher"/>
"""
STATIC = '<node pkg="tf2_ros" exec="static_transform_publisher" args="0 0 0 0 0 0 {} tag"/>'
RVIZ = '<node pkg="rviz2" exec="rviz2" args="-d $(dirname)/view.rviz"/>'
VIEW = "Visualization Manager:\n  Global Options:\n    Fixed Frame: {}\n"


@pytest.mark.parametrize(
    ("more", "frame", "count"),
    [
        (STATIC.format("camera"), "map", 1),
        (STATIC.format("camera") + '<node pkg="some_camera" exec="driver"/>', "map", 0),
        (STATIC.format("camera") + '<executable cmd="ros2 bag play a"/>', "map", 0),
        (STATIC.format("camera") + '<node pkg="usb_cam" exec="usb_cam_node"/>', "map", 1),
        (RVIZ, "laser", 1),
        (
            RVIZ + '<node pkg="lidar" exec="lidar"><param name="frame_id" value="laser"/></node>',
            "laser",
            0,
        ),
        (RVIZ, "leo1/base_link", 0),
        (RVIZ, "leo1/bse_link", 1),
    ],
)
def test_frames_that_others_publish(tmp_path: Path, more: str, frame: str, count: int) -> None:
    """Drivers, bags, messages of a lidar, and robots that are started with a prefix."""
    files = {
        "r.urdf": '<robot name="r"><link name="base_link"/></robot>',
        "launch/view.rviz": VIEW.format(frame),
    }
    found = reported(tmp_path / "arm", "LAU023", "a.launch.xml", PUBLISHER + more, files)
    assert len(found) == count


MODEL = """Visualization Manager:
  Displays:
    - {Class: rviz_default_plugins/RobotModel, Description Topic: {Value: robot_description}}
"""
REMAP = '><remap from="robot_description" to="/one/robot_description"/></node>'


@pytest.mark.parametrize(
    ("shown", "count"),
    [(RVIZ, 1), (RVIZ.replace("<node", '<node namespace="one"'), 0), (RVIZ[:-2] + REMAP, 0)],
)
def test_the_topics_of_rviz_in_a_namespace(tmp_path: Path, shown: str, count: int) -> None:
    files = {
        "r.urdf": '<robot name="r"><link name="base_link"/></robot>',
        "launch/view.rviz": MODEL,
    }
    robot = PUBLISHER.replace("<node", '<node namespace="one"')
    assert len(reported(tmp_path / "arm", "LAU022", "a.launch.xml", robot + shown, files)) == count


@pytest.mark.parametrize(
    ("namespace", "help"),
    [
        ("rick", naming("/rick/robot_description", "/robot_description", "RViz")),
        ("morty", naming("/robot_description")),
    ],
)
def test_a_configuration_of_rviz_that_another_launch_file_uses(
    tmp_path: Path, namespace: str, help: str
) -> None:
    """barista_robot_description: its view is that of the launch file with two robots."""
    robots = PUBLISHER.replace("<node", f'<node namespace="{namespace}"') + RVIZ
    files = {
        "r.urdf": '<robot name="r"><link name="base_link"/></robot>',
        "launch/view.rviz": MODEL.replace("robot_desc", "/rick/robot_desc"),
        "launch/robots.launch.xml": launch(robots),
    }
    (found,) = reported(tmp_path / "arm", "LAU022", "a.launch.xml", PUBLISHER + RVIZ, files)
    assert found.help == help


@pytest.mark.parametrize(("tool", "severity"), [("catkin", "info"), ("ament_cmake", "warning")])
def test_the_devel_space_of_catkin(tmp_path: Path, tool: str, severity: str) -> None:
    """In ROS 1 packages are found in the source tree without being installed."""
    build = f"<buildtool_depend>{tool}</buildtool_depend></package>"
    add_file(tmp_path / "package.xml", MANIFEST.replace("</package>", build).encode())
    rules = b"project(arm)\ninstall(DIRECTORY urdf DESTINATION share/${PROJECT_NAME})\n"
    add_file(tmp_path / "CMakeLists.txt", rules)
    add_file(tmp_path / "launch" / "a.launch", launch("").encode())
    found = check(tmp_path / "launch" / "a.launch", select=["PKG002"]).diagnostics
    assert [one.severity.value for one in found] == [severity]


def test_bags_are_no_views_of_rviz(tmp_path: Path) -> None:
    """gmapping plays a bag with a delay of 5 s."""
    text = '<node pkg="{}" type="play" name="n" args="-d 5 a"/>'
    found = [
        len(reported(tmp_path / name, "LAU003", "a.launch", text.format(name)))
        for name in ("rosbag", "rviz")
    ]
    assert found == [0, 1]


def test_another_robot_may_be_started_elsewhere(tmp_path: Path) -> None:
    """A view of a TurtleBot, whose launch file is included, in a workspace with another robot."""
    files = {
        "r.urdf": '<robot name="r"><link name="base_link"/></robot>',
        "launch/robot.launch.py": "from launch_ros.actions import Node\n"
        'Node(package="robot_state_publisher", executable="robot_state_publisher",\n'
        '     parameters=[{"robot_description": open("../r.urdf").read()}])\n',
        "launch/view.rviz": VIEW.format("base_footprint"),
    }
    include = '<include file="$(find-pkg-share {})/launch/spawn.launch.py"/>'
    found = [
        len(reported(tmp_path / "arm", "LAU023", "a.launch.xml", RVIZ + more, files))
        for more in ("", include.format("some_robot_gazebo"), include.format("gazebo_ros"))
    ]
    assert found == [1, 0, 1]


@pytest.mark.parametrize(("package", "count"), [("our_scans", 0), ("nav2_planner", 1)])
def test_composable_nodes_publish_topics(tmp_path: Path, package: str, count: int) -> None:
    """A container may publish the scan; Nav2's planner does not."""
    bridge = "[{ros_topic_name: front, gz_topic_name: front, ros_type_name: sensor_msgs/msg/"
    bridge += "LaserScan, gz_type_name: gz.msgs.LaserScan, direction: GZ_TO_ROS}]\n"
    text = """from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.descriptions import ComposableNode
def generate_launch_description():
    return LaunchDescription([
        Node(package="ros_gz_bridge", executable="parameter_bridge",
             parameters=[{"config_file": "BRIDGE"}]),
        Node(package="slam_toolbox", executable="async_slam_toolbox_node"),
        ComposableNodeContainer(name="c", namespace="", package="rclcpp_components",
            executable="component_container", composable_node_descriptions=[
            ComposableNode(package="PACKAGE", plugin="a::B")])])
"""
    text = text.replace("PACKAGE", package).replace("BRIDGE", f"{tmp_path}/arm/bridge.yaml")
    files = {"bridge.yaml": bridge}
    found = reported(tmp_path / "arm", "LAU032", "a.launch.py", text, files)
    assert ["'/scan', which nothing publishes" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(
    ("prefix", "include", "severity"),
    [
        ("arm_", "", "warning"),
        ("arm_", '<xacro:include filename="$(find lidar)/lidar.xacro"/>', "warning"),
        ("", "", "error"),
    ],
)
def test_names_that_a_prefix_of_the_launch_file_tells_apart(
    tmp_path: Path, prefix: str, include: str, severity: str
) -> None:
    """A Dingo with a Gen3 arm, started with prefix:=arm_; both have a base_link."""
    arm = (
        '<xacro:arg name="prefix" default=""/><link name="base"/><link name="mount"/>'
        '<joint name="m" type="fixed"><parent link="base"/><child link="mount"/></joint>'
        '<link name="$(arg prefix)base"/><joint name="a" type="fixed">'
        '<parent link="mount"/><child link="$(arg prefix)base"/></joint>'
    )
    head = '<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">'
    robot = add_file(tmp_path / "arm/arm.xacro", f"{head}{include}{arm}</robot>")
    command = f"xacro $(find arm)/arm.xacro prefix:={prefix}"
    text = f'<param name="robot_description" command="{command}"/>'
    reported(tmp_path / "arm", "LAU004", "a.launch", text)
    found = check(robot, select=["NAM001", "TRE003"]).diagnostics  # the loop follows from the name
    assert {(one.code, one.severity.value) for one in found} == {("NAM001", severity)}


@pytest.mark.parametrize(
    ("release", "count"),
    [
        ("default_nav_to_pose_bt_xml: /opt/ros/humble/share/nav2_bt_navigator/a.xml", 0),
        ("default_nav_to_pose_bt_xml: /opt/ros/jazzy/share/nav2_bt_navigator/a.xml", 1),
    ],
)
def test_navigators_in_a_file_for_humble(tmp_path: Path, release: str, count: int) -> None:
    """A tank: in Humble the two navigators are no plugins, and the list is not read."""
    yaml = f"bt_navigator:\n  ros__parameters:\n    navigators: [navigate_to_pose]\n    {release}\n"
    text = nav2_launch("nav2_bt_navigator", "bt_navigator", '"../config/nav2.yaml"')
    files = {"config/nav2.yaml": yaml}
    assert len(reported(tmp_path / "arm", "LAU039", "a.launch.py", text, files)) == count


def test_a_display_of_another_model_than_the_robot(tmp_path: Path) -> None:
    """A rover with the view of a TurtleBot 4: its dock is shown beside the robot."""
    dock = MODEL.partition("Displays:\n")[2].replace("robot_desc", "standard_dock_desc")
    files = {
        "r.urdf": '<robot name="r"><link name="base_link"/></robot>',
        "launch/view.rviz": MODEL + dock,
    }
    (found,) = reported(tmp_path / "arm", "LAU022", "a.launch.xml", PUBLISHER + RVIZ, files)
    assert found.message == naming("RobotModel", "RViz", "standard_dock_description")
    assert found.help == naming("/standard_dock_description")
