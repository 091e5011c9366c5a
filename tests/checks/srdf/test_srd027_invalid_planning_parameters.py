"""SRD027: see the rule."""

from pathlib import Path

import pytest

from tests.naming import naming
from tests.srdfs import findings_in
from urdfkit import Severity

CLOUD = (
    "s:\n  sensor_plugin: occupancy_map_monitor/PointCloudOctomapUpdater\n  point_cloud_topic: /p\n"
    "  max_range: 5.0\n  padding_offset: 0.1\n  padding_scale: 1.0\n  point_subsample: 1\n"
    "  max_update_rate: 1.0\n  filtered_cloud_topic: f\n"
)
IMAGE = CLOUD.replace("PointCloud", "DepthImage")
LIMITS = "cartesian_limits:\n  max_trans_vel: 1.0\n  max_trans_acc: 1.0\n  max_trans_dec: -1.0\n"
FIXED, TIMES = (
    f"default_planner_request_adapters/{name}"
    for name in ("FixWorkspaceBounds", "AddTimeOptimalParameterization")
)
VALIDATION = "default_planning_response_adapters/ValidateSolution"
TIMED = "default_planning_response_adapters/AddTimeOptimalParameterization"
ADAPTER = "default_planning_request_adapters/CheckStartStateBounds"
OLD = "planning_plugin: ompl_interface/OMPLPlanner\n"
NEW = "planning_plugins: [ompl_interface/OMPLPlanner]\n"


@pytest.mark.parametrize(
    ("file", "text", "line", "message", "help"),
    [
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
            OLD + f"request_adapters:\n  - {ADAPTER}\nresponse_adapters:\n  - {TIMED}\n",
            1,
            naming("planning_plugin", "Humble", "Jazzy"),
            "write planning_plugins: [ompl_interface/OMPLPlanner]",
        ),
        (
            "moveit_planning.yaml",  # of a launch file without MoveItConfigsBuilder
            NEW + f"response_adapters:\n  - {VALIDATION}\n",
            2,
            naming("OMPL", "time 0"),
            "add default_planning_response_adapters/AddTimeOptimalParameterization",
        ),
        (
            "ompl_planning.yaml",
            OLD + f"request_adapters: {FIXED}\n",
            2,
            naming("OMPL", "time 0"),
            "add default_planner_request_adapters/AddTimeOptimalParameterization",
        ),
    ],
)
def test_settings_without_effect(
    tmp_path: Path, file: str, text: str, line: int, message: str, help: str
) -> None:
    assert (line, Severity.WARNING.name, message, help) in findings_in(
        tmp_path, file, text, "SRD027"
    )


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
        (
            "ompl_planning.yaml",
            "planning_plugins:\nrequest_adapters: []\n",
            1,
            naming("planning_plugins"),
            "write [ompl_interface/OMPLPlanner], or that of the pipeline",
        ),
    ],
)
def test_settings_at_which_move_group_stops(
    tmp_path: Path, file: str, text: str, line: int, message: str, help: str
) -> None:
    assert findings_in(tmp_path, file, text, "SRD027") == [
        (line, Severity.ERROR.name, message, help)
    ]


@pytest.mark.parametrize(
    ("file", "text"),
    [
        ("kinematics.yaml", "g\n  kinematics_solver: k\n"),
        ("joint_limits.yaml", "joint_limits: [\n"),
        ("ompl_planning.yaml", "  - a/B\nadapters:\n"),
    ],
)
def test_a_file_that_is_not_yaml(tmp_path: Path, file: str, text: str) -> None:
    ((line, severity, message, _),) = findings_in(tmp_path, file, text, "SRD027")
    assert (line, severity, message.partition(":")[0]) == (2, "ERROR", "invalid YAML")


@pytest.mark.parametrize(
    ("file", "text"),
    [
        ("sensors_3d.yaml", "sensors: [s]\n" + CLOUD + "  ns: n\n  mine: 1\n"),
        ("sensors_3d.yaml", "sensors: [s]\n" + IMAGE + "  image_topic: /d\n"),
        ("sensors_3d.yaml", "sensors: []\n"),
        ("sensors_3d.yaml", "sensors:\n  - {}\n"),
        ("sensors_3d.yaml", "sensors: [s]\ns:\n  sensor_plugin: mine/Updater\n"),
        ("pilz_cartesian_limits.yaml", LIMITS + "  max_rot_vel: 1.0\n"),
        ("ompl_planning.yaml", OLD + f"request_adapters: >-\n  {FIXED} {TIMES}\n"),
        ("ompl_planning.yaml", OLD + f"request_adapters: {FIXED} own/Times\n"),
        ("stomp_planning.yaml", f"planning_plugins: [s/S]\nresponse_adapters: [{VALIDATION}]\n"),
        ("ompl_planning.yaml", NEW + f"request_adapters:\n  - {ADAPTER}\n"),
    ],
)
def test_settings_that_are_read(tmp_path: Path, file: str, text: str) -> None:
    assert findings_in(tmp_path, file, text, "SRD027") == []


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
    found = findings_in(tmp_path, "sensors_3d.yaml", text, "SRD027")
    assert [("sensors contains settings" in message) for _, _, message, _ in found] == [
        True
    ] * count


@pytest.mark.parametrize(("mentioned", "count"), [("arm", 1), ("hand", 0)])
def test_a_launch_file_of_another_package_loads_other_sensors(
    tmp_path: Path, mentioned: str, count: int
) -> None:
    """A workspace with several robots: that of Techman loads no sensors."""
    manifest = "<package><name>{}</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
    for name in ("arm", "hand"):
        (tmp_path / "src" / name).mkdir(parents=True)
        (tmp_path / "src" / name / "package.xml").write_text(manifest.format(name))
    launch = f'load_yaml("{mentioned}", "config/sensors_3d.yaml")'
    (tmp_path / "src" / "hand" / "demo.launch.py").write_text(launch)
    text = "sensors:\n  - sensor_plugin: occupancy_map_monitor/PointCloudOctomapUpdater\n"
    found = findings_in(tmp_path / "src" / "arm", "sensors_3d.yaml", text, "SRD027")
    assert len(found) == count


KDL = "g: {{kinematics_solver: kdl_kinematics_plugin/KDLKinematicsPlugin{}}}\n"


@pytest.mark.parametrize(
    ("text", "count"),
    [
        (KDL.format(""), 1),
        (KDL.format(", position_only_ik: true"), 0),
        (KDL.format("").replace("kdl_", "pick_ik/"), 0),
        (KDL.format("").replace("g:", "other:"), 0),
    ],
)
def test_a_chain_of_few_joints(tmp_path: Path, text: str, count: int) -> None:
    found = findings_in(tmp_path, "kinematics.yaml", text, "SRD027")
    assert [(severity, message) for _, severity, message, _ in found] == [
        (Severity.INFO.name, naming("g", "1"))
    ] * count
    assert all("position_only_ik" in help for *_, help in found)
