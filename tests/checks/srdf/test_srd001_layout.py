"""SRD001: settings of MoveIt's YAML files that are missing, misplaced, or of the wrong kind."""

from pathlib import Path

import pytest

from tests.naming import naming, values
from tests.srdfs import findings
from urdfkit import Severity

GROUP = '<group name="g"><chain base_link="base" tip_link="hand"/></group>'
MANAGER = "moveit_simple_controller_manager:\n  controller_names: [c]\n  c:\n    type: a\n"
PLUGIN = (
    "moveit_controller_manager: moveit_simple_controller_manager/MoveItSimpleControllerManager\n"
)
DISPLAY = (
    "Visualization Manager:\n  Displays:\n    - Class: moveit_rviz_plugin/MotionPlanning\n"
    "      Planning Request:\n        Planning Group: {}\n"
)
CLOUD = (
    "s:\n  sensor_plugin: occupancy_map_monitor/PointCloudOctomapUpdater\n  point_cloud_topic: /p\n"
    "  max_range: 5.0\n  padding_offset: 0.1\n  padding_scale: 1.0\n  point_subsample: 1\n"
    "  max_update_rate: 1.0\n  filtered_cloud_topic: f\n"
)
IMAGE = CLOUD.replace("PointCloud", "DepthImage")
LIMITS = "cartesian_limits:\n  max_trans_vel: 1.0\n  max_trans_acc: 1.0\n  max_trans_dec: -1.0\n"
SERVO = "move_group_name: g\ncommand_out_topic: /c/joint_trajectory\ncommand_out_type: {}\n"
ADAPTER = "default_planning_request_adapters/CheckStartStateBounds"
OLD = "planning_plugin: ompl_interface/OMPLPlanner\n"
NEW = "planning_plugins: [ompl_interface/OMPLPlanner]\n"


def reported(directory: Path, file: str, text: str) -> list[tuple[int, str, str, str]]:
    """Line, severity, message and help of each finding in a file next to the SRDF."""
    (directory / file).write_text(text)
    return [
        (found.span.line, found.severity.name, found.message, found.help)
        for found in findings(directory, GROUP, "SRD001")
        if found.span.source.path == str(directory / file)
    ]


@pytest.mark.parametrize(
    ("file", "text", "line", "message", "help"),
    [
        (
            "moveit_controllers.yaml",
            "trajectory_execution:\n  a: 1\nallowed_start_tolerance: 0.1\n",
            3,
            naming("allowed_start_tolerance", "trajectory_execution"),
            "indent it below trajectory_execution:",
        ),
        (
            "moveit_controllers.yaml",
            "trajectory_execution:\n  allowed_start_tolerence: 0.1\n",
            2,
            "trajectory_execution has no 'allowed_start_tolerence'",
            "write allowed_start_tolerance",
        ),
        (
            "moveit_controllers.yaml",
            MANAGER + "    joint: [shoulder]\n",
            5,
            naming("c", "joint"),
            "write joints",
        ),
        (
            "moveit_controllers.yaml",
            MANAGER + "    joints: [shoulder]\n  d: {type: a, joints: [shoulder]}\n",
            6,
            naming("d", "controller_names", "MoveIt"),
            "add d to controller_names",
        ),
        (
            "sensors_3d.yaml",
            "sensors: [s]\n" + IMAGE,
            3,
            (
                naming(
                    "DepthImageOctomapUpdater",
                    "image_topic",
                    "point_cloud_topic",
                    "max_range",
                    "point_subsample",
                )
            ),
            naming("image_topic", "point_cloud_topic"),
        ),
        (
            "sensors_3d.yaml",
            "sensors: [s]\n" + CLOUD.replace("  max_range: 5.0\n", ""),
            3,
            "PointCloudOctomapUpdater has no max_range",
            "add max_range",
        ),
        (
            "pilz_cartesian_limits.yaml",
            LIMITS,
            1,
            naming("cartesian_limits", "max_rot_vel"),
            "add max_rot_vel",
        ),
        (
            "ompl_planning.yaml",
            NEW + f"request_adapters: >-\n  {ADAPTER}\n",
            2,
            naming("request_adapters", "planning_plugins", "Jazzy", "list"),
            naming(ADAPTER),
        ),
        (
            "ompl_planning.yaml",
            OLD + f"request_adapters:\n  - {ADAPTER}\n",
            1,
            naming("planning_plugin", "Humble", "Jazzy"),
            "write planning_plugins: [ompl_interface/OMPLPlanner]",
        ),
        (
            "servo.yaml",
            SERVO.format("std_msgs/Float64MultiArray"),
            3,
            (
                naming(
                    "servo.yaml",
                    "command_out_type",
                    "std_msgs/Float64MultiArray",
                    "/c/joint_trajectory",
                    "trajectory_msgs/JointTrajectory",
                )
            ),
            "write trajectory_msgs/JointTrajectory",
        ),
    ],
)
def test_settings_without_effect(
    tmp_path: Path, file: str, text: str, line: int, message: str, help: str
) -> None:
    assert (line, Severity.WARNING.name, message, help) in reported(tmp_path, file, text)


@pytest.mark.parametrize(
    ("file", "text", "line", "message", "help"),
    [
        ("sensors_3d.yaml", "sensors: s\n" + CLOUD, 1, naming("s", "list"), "write [s]"),
        ("sensors_3d.yaml", "sensors: [t]\n", 1, naming("t", "no settings"), "fix the name"),
        (
            "ompl_planning.yaml",
            "planner_configs:\n  RRT:\n    type: geometric::RRT\ng:\n  planner_configs: RRT\n",
            5,
            naming("planner_configs", "g", "list"),
            "write [RRT]",
        ),
    ],
)
def test_settings_at_which_move_group_stops(
    tmp_path: Path, file: str, text: str, line: int, message: str, help: str
) -> None:
    assert reported(tmp_path, file, text) == [(line, Severity.ERROR.name, message, help)]


@pytest.mark.parametrize(
    ("file", "text"),
    [
        ("moveit_controllers.yaml", "trajectory_execution:\n  allowed_start_tolerance: 0.1\n"),
        ("moveit_controllers.yaml", "moveit_manage_controllers: true\nmine: 1\n"),
        (
            "moveit_controllers.yaml",
            PLUGIN + MANAGER + "    joints: [shoulder]\n    action_ns: b\n",
        ),
        ("v.rviz", DISPLAY.format("g")),
        ("v.rviz", DISPLAY.format("''")),
        ("sensors_3d.yaml", "sensors: [s]\n" + CLOUD + "  ns: n\n  mine: 1\n"),
        ("sensors_3d.yaml", "sensors: [s]\n" + IMAGE + "  image_topic: /d\n"),
        ("sensors_3d.yaml", "sensors: []\n"),
        ("sensors_3d.yaml", "sensors:\n  - {}\n"),
        ("sensors_3d.yaml", "sensors: [s]\ns:\n  sensor_plugin: mine/Updater\n"),
        ("pilz_cartesian_limits.yaml", LIMITS + "  max_rot_vel: 1.0\n"),
        ("ompl_planning.yaml", OLD + f"request_adapters: >-\n  {ADAPTER}\n".replace("ning", "ner")),
        ("ompl_planning.yaml", NEW + f"request_adapters:\n  - {ADAPTER}\n"),
        ("servo.yaml", SERVO.format("trajectory_msgs/JointTrajectory")),
        ("servo.yaml", SERVO.format("std_msgs/Float64MultiArray").replace("joint_traj", "my_")),
    ],
)
def test_settings_that_are_read(tmp_path: Path, file: str, text: str) -> None:
    assert reported(tmp_path, file, text) == []


def test_a_planning_group_of_another_robot_in_rviz(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, "v.rviz", DISPLAY.format("panda_arm"))
    message = naming("RViz", "unknown", "panda_arm")
    assert found == (5, Severity.INFO.name, message, "write one of g")


@pytest.mark.parametrize("package", [True, False])
def test_settings_of_a_controller_manager_that_move_group_does_not_load(
    tmp_path: Path, package: bool
) -> None:
    if package:
        (tmp_path / "package.xml").write_text('<package format="3"><name>p</name></package>')
    found = reported(tmp_path, "moveit_controllers.yaml", MANAGER)
    names = ["moveit_controller_manager", "move_group", "moveit_simple_controller_manager"]
    assert (names in [values(text) for _, _, text, _ in found]) == package


CONTROLLERS = """\
controller_manager:
  ros__parameters:
    c: {type: joint_trajectory_controller/JointTrajectoryController}
    f: {type: forward_command_controller/ForwardCommandController}
"""


@pytest.mark.parametrize(
    ("topic", "read"),
    [
        ("/c/command", "/c/joint_trajectory"),
        ("/robot/c/commands", "/robot/c/joint_trajectory"),
        ("f/joint_trajectory", "f/commands"),
        ("/f/commands", ""),
        ("/other/command", ""),
        ("joint_trajectory", ""),
    ],
)
def test_a_topic_of_servo_that_its_controller_does_not_read(
    tmp_path: Path, topic: str, read: str
) -> None:
    (tmp_path / "package.xml").write_text("<package><name>p</name></package>")
    (tmp_path / "ros2_controllers.yaml").write_text(CONTROLLERS)
    text = f"move_group_name: g\ncommand_out_topic: {topic}\n"
    found = [(message, help) for _, _, message, help in reported(tmp_path, "servo.yaml", text)]
    message = naming("servo.yaml", topic, read)
    assert found == ([(message, f"write {read}")] if read else [])


@pytest.mark.parametrize(
    ("kind", "launch", "count"),
    [
        ("ament_cmake", 'MoveItConfigsBuilder("r", package_name="a").to_moveit_configs()', 1),
        ("ament_cmake", 'load_yaml("a", "config/sensors_3d.yaml")', 1),
        ("ament_cmake", 'load_yaml("a", "config/kinematics.yaml")', 0),
        ("catkin", 'load_yaml("a", "config/sensors_3d.yaml")', 0),
    ],
)
def test_settings_in_the_list_of_sensors(
    tmp_path: Path, kind: str, launch: str, count: int
) -> None:
    (tmp_path / "demo.launch.py").write_text(launch)
    manifest = f"<package><name>a</name><buildtool_depend>{kind}</buildtool_depend></package>"
    (tmp_path / "package.xml").write_text(manifest)
    text = CLOUD.replace("s:\n  sensor", "sensors:\n  - sensor").replace("\n  ", "\n    ")
    text = text.replace("    - ", "  - ")
    found = reported(tmp_path, "sensors_3d.yaml", text)
    assert [("sensors contains settings" in message) for _, _, message, _ in found] == [
        True
    ] * count
