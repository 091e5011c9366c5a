"""What launch files and the YAML beside them may name, however like a mistake it looks."""

import shutil
from pathlib import Path

import pytest

from tests.launched import reported
from tests.test_planted import CARRIERS
from urdfkit import check

_NODE = """import os
import xacro
from launch import LaunchDescription
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node

def start(context):
    model = LaunchConfiguration("model")
    path = {path}
    return [Node(package="robot_state_publisher", executable="robot_state_publisher", {given})]

def generate_launch_description():
    return LaunchDescription([*start(None)])
"""


@pytest.mark.parametrize(
    "given",
    [
        'parameters=[{"robot_description": xacro.process_file(path).toxml()}]',
        'parameters=[{"robot_description": xacro.process_file(path).toprettyxml(indent="  ")}]',
        'parameters=[{"robot_description": model}], arguments=["robot.urdf.xacro"]',
        'arguments=["robot.urdf"]',
    ],
)
def test_a_text_that_python_makes_of_a_xacro(tmp_path: Path, given: str) -> None:
    text = _NODE.format(path='"/robot.xacro"', given=given)
    for code in ("LAU033", "LAU015"):
        assert reported(tmp_path / "arm", code, "a.launch.py", text) == []


@pytest.mark.parametrize(
    "path",
    [
        'os.path.join("/urdf", model.perform(context))',
        'PathJoinSubstitution(["/urdf", model])',
        'os.path.join("/urdf", LaunchConfiguration("model").perform(context))',
        '"/".join(["urdf", "robot.xacro"])',
    ],
)
def test_a_path_whose_parts_are_known_when_it_is_joined(tmp_path: Path, path: str) -> None:
    text = _NODE.format(path=path, given="arguments=[path]")
    assert reported(tmp_path / "arm", "LAU034", "a.launch.py", text) == []


def _porter(directory: Path, file: str, old: str, new: str) -> list[str]:
    """The codes of the findings on the porter with other text in one file."""
    shutil.copytree(CARRIERS / "porter", directory)
    path = directory / file
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new))
    return [found.code for found in check(directory).diagnostics]


@pytest.mark.parametrize("frame", ["odom_combined", "utm", "world", "base_link"])
def test_frames_in_which_a_costmap_may_be(tmp_path: Path, frame: str) -> None:
    """Those of a filter or driver that urdfkit does not know."""
    nav2 = "porter_bringup/config/nav2.yaml"
    found = _porter(tmp_path / "ws", nav2, "global_frame: odom", f"global_frame: {frame}")
    assert found == []


def test_a_filter_that_publishes_no_transform(tmp_path: Path) -> None:
    ekf = "porter_bringup/config/ekf.yaml"
    old = "publish_tf: true"
    found = _porter(tmp_path / "a", ekf, old, "publish_tf: false")
    assert "LAU021" not in found
    camera = "publish_tf: false\n    base_link_frame: camera_link\n    base_link_frame_unused: x"
    assert "LAU021" not in _porter(tmp_path / "b", ekf, old, camera)


@pytest.mark.parametrize(
    "line",
    [
        "install(DIRECTORY srdf DESTINATION share/${PROJECT_NAME} OPTIONAL)",
        (
            "if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/srdf)\n"
            "  install(DIRECTORY srdf DESTINATION share/${PROJECT_NAME})\nendif()"
        ),
        (
            "configure_file(a.srdf.in srdf/a.srdf)\n"
            "install(DIRECTORY srdf DESTINATION share/${PROJECT_NAME})"
        ),
        "# install(DIRECTORY srdf DESTINATION share/${PROJECT_NAME})",
    ],
)
def test_directories_that_a_build_makes_or_may_lack(tmp_path: Path, line: str) -> None:
    cmake = "porter_description/CMakeLists.txt"
    found = _porter(tmp_path / "ws", cmake, "ament_package()", f"{line}\n\nament_package()")
    assert found == []


def test_a_package_for_both_ros(tmp_path: Path) -> None:
    """catkin for ROS 1 and ament_cmake for ROS 2, by the version of ROS."""
    cmake = "porter_description/CMakeLists.txt"
    both = (
        'if("$ENV{ROS_VERSION}" STREQUAL "1")\n  find_package(catkin REQUIRED)\n'
        "  catkin_package()\nelse()\n  find_package(ament_cmake REQUIRED)\nendif()"
    )
    assert _porter(tmp_path / "ws", cmake, "find_package(ament_cmake REQUIRED)", both) == []


@pytest.mark.parametrize("planner", ["my_planner", "mine"])
def test_planners_of_a_file(tmp_path: Path, planner: str) -> None:
    ompl = tmp_path / "ws" / "porter_moveit_config" / "config" / "ompl_planning.yaml"
    shutil.copytree(CARRIERS / "porter", tmp_path / "ws")
    ompl.write_text(
        "planning_plugin: ompl_interface/OMPLPlanner\n"
        "planner_configs:\n  mine:\n    type: geometric::RRT\n"
        f"arm:\n  default_planner_config: {planner}\n  planner_configs: [{planner}, mine]\n"
    )
    assert check(tmp_path / "ws").diagnostics == ()


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ("planner_configs: [RRTConneckConfigDefault]", "'RRTConnectkConfigDefault'?"),
        ("projection_evaluator: x", "'ompl_interface/OMPLPlanner'?"),
    ],
)
def test_misspelt_planners(tmp_path: Path, given: str, message: str) -> None:
    ompl = tmp_path / "ws" / "porter_moveit_config" / "config" / "ompl_planning.yaml"
    shutil.copytree(CARRIERS / "porter", tmp_path / "ws")
    plugin = "ompl_interface" if "planner" in given else "ompl_interface_ros"
    ompl.write_text(f"planning_plugin: {plugin}/OMPLPlanner\narm:\n  {given}\n")
    (found,) = check(tmp_path / "ws").diagnostics
    assert (found.code, found.message.endswith(message)) == ("SRD026", True)


def test_a_parameter_of_hardware_that_is_not_known(tmp_path: Path) -> None:
    control = "porter_description/urdf/control.xacro"
    shutil.copytree(CARRIERS / "porter", tmp_path / "ws")
    path = tmp_path / "ws" / control
    text = path.read_text().replace("</joint>", '<param name="initial_value">0</param></joint>')
    path.write_text(
        text.replace("mock_components/GenericSystem", "my_arm/System").replace(
            "gz_ros2_control/GazeboSimSystem", "my_arm/System"
        )
    )
    assert "RCT017" not in [found.code for found in check(tmp_path / "ws").diagnostics]


@pytest.mark.parametrize("sim", ["gazebo_ros_control/DefaultRobotHWSim", "my_arm/ArmHWSim"])
def test_simulations_of_hardware(tmp_path: Path, sim: str) -> None:
    shutil.copytree(CARRIERS / "crawler", tmp_path / "ws")
    path = tmp_path / "ws" / "urdf" / "crawler.xacro"
    tag = "<robotNamespace>/</robotNamespace>"
    path.write_text(path.read_text().replace(tag, f"{tag}<robotSimType>{sim}</robotSimType>"))
    assert check(path, select=["RCT010"]).diagnostics == ()


@pytest.mark.parametrize(("count", "codes"), [(6, []), (3, ["RCT034"])])
def test_lengths_of_covariances(tmp_path: Path, count: int, codes: list[str]) -> None:
    controllers = "porter_description/config/controllers.yaml"
    line = f"enable_odom_tf: false\n    twist_covariance_diagonal: {[0.001] * count}"
    assert _porter(tmp_path / "ws", controllers, "enable_odom_tf: false", line) == codes
