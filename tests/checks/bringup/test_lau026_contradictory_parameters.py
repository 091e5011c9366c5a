"""LAU026: see the rule; planted defects are in tests/bringup/planted.txt."""

from pathlib import Path

import pytest

from tests.checks.bringup.nav2 import (
    AMCL,
    CONTROLLER,
    COSTMAP,
    COSTMAP_OF,
    DWB,
    EKF,
    JAZZY,
    PLAIN_MPPI,
    PROGRAM,
    SERVER,
    WATCH,
    messages,
    rows,
)
from tests.launched import reported


@pytest.mark.parametrize(
    ("plugins", "names"),
    [
        ("[scan, inflation]", []),
        ("[inflation, scan]", ["scan"]),
        ("[inflation, map, scan]", ["map", "scan"]),
        ("[inflation, scan, inflation]", []),
        ("[inflation, own]", []),
        ("[inflation, off]", []),
    ],
)
def test_layers_behind_the_inflation(tmp_path: Path, plugins: str, names: list[str]) -> None:
    yaml = COSTMAP.format(f"rolling_window: true\n      plugins: {plugins}") + "".join(
        f"      {name}: {{plugin: {kind}}}\n"
        for name, kind in (
            ("inflation", "nav2_costmap_2d::InflationLayer"),
            ("scan", "nav2_costmap_2d::ObstacleLayer"),
            ("map", "nav2_costmap_2d::StaticLayer"),
            ("own", "my_layers::Own"),
            ("off", "nav2_costmap_2d::VoxelLayer, enabled: False"),
        )
    )
    found = messages("LAU026", tmp_path, yaml)
    expected = [f"obstacles of '{name}'" for name in names]
    assert len(found) == len(expected)
    assert all(words in one for words, one in zip(expected, found, strict=True))


@pytest.mark.parametrize(
    ("plugin", "limits", "count"),
    [
        (f"{PLAIN_MPPI}, motion_model: Omni", "[0.5, 0.0, 1.5]", 1),
        (f"{PLAIN_MPPI}, motion_model: Omni", "[0.5, 0.3, 1.5]", 0),
        (f"{PLAIN_MPPI}, motion_model: Omni", "", 0),
        (f"{PLAIN_MPPI}, motion_model: DiffDrive", "[0.5, 0.0, 1.5]", 0),
        (f"{DWB}, max_vel_y: 0.2", "[0.5, 0.0, 1.5]", 1),
        (f"{DWB}, max_vel_y: 0.0", "[0.5, 0.0, 1.5]", 0),
    ],
)
def test_a_controller_that_moves_sideways(
    tmp_path: Path, plugin: str, limits: str, count: int
) -> None:
    yaml = SERVER.format(plugin)
    if limits:
        yaml += f"velocity_smoother: {{ros__parameters: {{max_velocity: {limits}}}}}\n"
    found = messages("LAU026", tmp_path, yaml)
    assert ["sideways" in one for one in found] == [True] * count


@pytest.mark.parametrize(
    ("plugin", "model", "count"),
    [
        (f"{PLAIN_MPPI}, motion_model: Omni", "Differential", 1),
        (f"{PLAIN_MPPI}, motion_model: Omni", "Omni", 0),
        (f"{PLAIN_MPPI}, motion_model: DiffDrive", "Differential", 0),
        (f"{DWB}, max_vel_y: 0.3", "Differential", 1),
        (f"{DWB}, max_vel_y: 0.0", "Differential", 0),
    ],
)
def test_the_drive_that_amcl_expects(tmp_path: Path, plugin: str, model: str, count: int) -> None:
    yaml = SERVER.format(plugin)
    yaml += AMCL.format(f"robot_model_type: 'nav2_amcl::{model}MotionModel'")
    assert len(messages("LAU026", tmp_path, yaml)) == count


MPPI = (
    "controller_server: {{ros__parameters: {{controller_frequency: {}, FollowPath: {{plugin: "
    "'nav2_mppi_controller::MPPIController'{}}}}}}}\n"
)


@pytest.mark.parametrize(
    ("yaml", "words"),
    [
        (MPPI.format("20.0", ", model_dt: 0.02"), "period of 0.05 s"),
        (MPPI.format("20.0", ""), ""),
        (MPPI.format("30.0", ", model_dt: 0.033"), "period of 0.03333 s"),
        (MPPI.format("30.0", ""), ""),
        (MPPI.format("10.0", ""), "period of 0.1 s"),
        ("slam_toolbox: {ros__parameters: {transform_publish_period: 0.0}}\n", "no transform"),
        (AMCL.format("min_particles: 900, max_particles: 500"), "min_particles is 900, above"),
        (AMCL.format("laser_min_range: 0.1, laser_max_range: -1.0"), ""),
        (AMCL.format("initial_pose: {x: 0.0, y: 0.0}"), "initial_pose is not read"),
        (
            AMCL.format("set_initial_pose: false, initial_pose: {x: 1.0}"),
            "initial_pose is not read",
        ),
        (AMCL.format("set_initial_pose: false, initial_pose: {x: 0.0}"), ""),
        (AMCL.format("set_initial_pose: true, initial_pose: {x: 1.0}"), ""),
        (EKF.format(f"odom0: odom, odom0_config: {rows(4)}"), "row 5, acceleration"),
        (EKF.format(f"odom0: odom, odom0_config: {rows(2)}"), ""),
        (EKF.format(f"imu0: imu, imu0_config: {rows(0)}"), "row 1, position"),
        (EKF.format(f"imu0: imu, imu0_config: {rows(3)}"), ""),
        (EKF.format(f"imu0: imu, imu0_config: [{', '.join(['false'] * 15)}]"), "reads nothing"),
    ],
)
def test_contradictions(tmp_path: Path, yaml: str, words: str) -> None:
    found = messages("LAU026", tmp_path, yaml)
    assert [words in one for one in found] == [True] * bool(words)


OBSTACLES = "obstacles: {{plugin: 'nav2_costmap_2d::ObstacleLayer', {}}}"
SOURCE = "observation_sources: scan, scan: {{topic: /scan, data_type: LaserScan, {}}}"
INFLATION = "inflation: {{plugin: 'nav2_costmap_2d::InflationLayer', inflation_radius: {}}}"
SQUARE = "footprint: '[[0.3, 0.2], [0.3, -0.2], [-0.3, -0.2], [-0.3, 0.2]]'"


@pytest.mark.parametrize(
    ("values", "words"),
    [
        (
            OBSTACLES.format(SOURCE.format("clearing: false, marking: true")),
            "of obstacles are never cleared",
        ),
        (OBSTACLES.format(SOURCE.format("clearing: false") + ", enabled: false"), ""),
        (OBSTACLES.format(SOURCE.format("marking: true")), ""),  # the default, if unwanted
        (OBSTACLES.format(SOURCE.format("clearing: true, raytrace_max_range: 2.0")), ""),
        (
            OBSTACLES.format(
                SOURCE.format("clearing: true, obstacle_max_range: 3.0, raytrace_max_range: 2.0")
            ),
            "obstacles: raytrace_max_range 2 is below obstacle_max_range 3",
        ),
        (f"{SQUARE}, {INFLATION.format(0.1)}", "radius of the robot, 0.2 m"),
        (f"{SQUARE}, {INFLATION.format(0.2)}", ""),
        (f"robot_radius: 0.3, {INFLATION.format(0.2)}", "inscribed radius"),
        (INFLATION.format(0.05), ""),
        (f"{SQUARE}, robot_radius: 2.0", "robot_radius 2 is not read"),
        (f"{SQUARE}, robot_radius: 0.3", ""),
        ("footprint: '[]', robot_radius: 2.0", ""),
    ],
)
def test_contradictions_of_a_costmap(tmp_path: Path, values: str, words: str) -> None:
    found = messages("LAU026", tmp_path, COSTMAP_OF.format(values))
    assert [words in one for one in found] == [True] * bool(words)


@pytest.mark.parametrize(
    ("stamps", "names"),
    [
        (("true", "true"), []),
        (("true", "false"), ["collision_monitor"]),
        (("true", ""), ["collision_monitor"]),
        (("", "true"), ["velocity_smoother"]),
        (("false", ""), []),
        (("", ""), []),
    ],
)
def test_stamps_of_nav2(tmp_path: Path, stamps: tuple[str, str], names: list[str]) -> None:
    nodes = ("velocity_smoother", "collision_monitor")
    more = ", polygons: [p], p: {type: circle}, observation_sources: [scan], scan: {topic: scan}"
    yaml = "".join(
        f"{node}: {{ros__parameters: {{use_sim_time: true"
        + (f", enable_stamped_cmd_vel: {stamp}" if stamp else "")
        + (more if node == "collision_monitor" else "")
        + "}}\n"
        for node, stamp in zip(nodes, stamps, strict=True)
    )
    found = messages("LAU026", tmp_path, yaml)
    assert [one.split("'")[1] for one in found if "stamped" in one] == names


LIDAR = """<robot name="r"><link name="base"/><link name="mast"/>
<joint name="j" type="fixed"><parent link="base"/><child link="mast"/>
<origin xyz="0 0 0.4"/></joint>
<gazebo reference="mast"><sensor name="scanner" type="gpu_lidar"><lidar><scan><horizontal>
<samples>90</samples><min_angle>-1</min_angle><max_angle>1</max_angle></horizontal></scan>
<range><min>0.1</min><max>9</max></range></lidar></sensor></gazebo></robot>"""


@pytest.mark.parametrize(
    ("bound", "count"),
    [
        ("max_obstacle_height: 2.0", 0),
        ("max_obstacle_height: 0.5", 0),
        ("max_obstacle_height: 0.3", 1),
        ("min_obstacle_height: 0.3", 0),
        ("min_obstacle_height: 0.5", 1),
    ],
)
def test_heights_of_obstacles(tmp_path: Path, bound: str, count: int) -> None:
    text = (
        "from launch_ros.actions import Node\n\n"
        "state = Node(package='robot_state_publisher', executable='robot_state_publisher', "
        f"parameters=[{{'robot_description': open('{tmp_path}/r.urdf').read()}}])\n"
        "server = Node(package='nav2_controller', executable='controller_server', "
        f"parameters=['{tmp_path}/a.yaml'])\n"
    )
    files = {"r.urdf": LIDAR, "a.yaml": COSTMAP_OF.format(OBSTACLES.format(SOURCE.format(bound)))}
    found = reported(tmp_path, "LAU026", "a.launch.py", text, files)
    assert ["height of 0.4 m" in one.message for one in found] == [True] * count


LAYERS = "plugins: [a, i], a: {{plugin: 'nav2_costmap_2d::{}'}}, i: {{plugin: n::InflationLayer}}"
GLOBAL = "global_costmap: {{global_costmap: {{ros__parameters: {{{}}}}}}}\n"
STATIC = LAYERS.format("StaticLayer")
LOCALIZED = "amcl: {{ros__parameters: {{global_frame_id: {}}}}}\n"
PURSUIT = (
    "'nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController', "
    "allow_reversing: true"
)
ROUND = COSTMAP_OF.format("rolling_window: true, robot_radius: 0.2")
MPPI_OF = f"{PLAIN_MPPI}, model_dt: 0.1, critics: [CostCritic], CostCritic: "
CONSIDERED = SERVER.format(MPPI_OF + "{consider_footprint: true}")
VERTICAL = (
    "ekf: {{ros__parameters: {{imu0: imu, imu0_config: ["
    + "false, " * 12
    + "true, true, {}]{}}}}}\n"
)


@pytest.mark.parametrize(
    ("yaml", "words"),
    [
        (COSTMAP_OF.format(LAYERS.format("VoxelLayer")), "not move with"),
        (COSTMAP_OF.format(f"rolling_window: true, {LAYERS.format('VoxelLayer')}"), ""),
        (COSTMAP_OF.format(f"rolling_window: $(roll), {LAYERS.format('VoxelLayer')}"), ""),
        (COSTMAP_OF.format(STATIC), ""),
        (COSTMAP_OF.format(LAYERS.format("OwnLayer")), ""),
        (GLOBAL.format(LAYERS.format("ObstacleLayer")), "not move with"),
        (GLOBAL.format(f"width: 100, height: 100, {LAYERS.format('ObstacleLayer')}"), ""),
        (
            GLOBAL.format(f"global_frame: odom, {STATIC}") + LOCALIZED.format("map"),
            "map in 'odom'",
        ),
        (GLOBAL.format(f"global_frame: odom, {STATIC}") + LOCALIZED.format("hall"), ""),
        (GLOBAL.format(f"global_frame: odom, {STATIC}"), ""),
        (
            GLOBAL.format(f"rolling_window: true, global_frame: odom, {STATIC}")
            + LOCALIZED.format("map"),
            "",
        ),
        (COSTMAP_OF.format("rolling_window: true, footprint: '[[9, 9], [-9, 0], [9, -9]]'"), "12."),
        (COSTMAP_OF.format("rolling_window: true, footprint: '[[1, 1], [-1, 0], [1, -1]]'"), ""),
        (COSTMAP_OF.format("footprint: '[[9, 9], [-9, 0], [9, -9]]'"), ""),
        (SERVER.format(f"{PURSUIT}, use_rotate_to_heading: true"), "does not reverse"),
        (SERVER.format(f"{PURSUIT}, use_rotate_to_heading: false"), ""),
        (ROUND + CONSIDERED, "CostCritic has consider_footprint, but"),
        (ROUND + CONSIDERED.replace("true", "false"), ""),
        (ROUND.replace("robot_radius: 0.2", SQUARE) + CONSIDERED, ""),
        (VERTICAL.format("true", ""), "gravity"),
        (VERTICAL.format("false", ""), ""),
        (VERTICAL.format("true", ", two_d_mode: true"), ""),
        (VERTICAL.format("true", ", imu0_remove_gravitational_acceleration: true"), ""),
        (WATCH.format("near", "circle, footprint_topic: /local_costmap/footprint"), "published_"),
        (WATCH.format("near", "circle, footprint_topic: /own/footprint"), ""),
        (
            "behavior_server: {ros__parameters: {local_costmap_topic: local_costmap/costmap}}\n",
            "is not 'costmap_raw'",
        ),
    ],
)
def test_geometry_and_topics_of_a_costmap(tmp_path: Path, yaml: str, words: str) -> None:
    found = messages("LAU026", tmp_path, yaml)
    assert [words in one for one in found] == [True] * bool(words)


RELATIVE = COSTMAP_OF.format(OBSTACLES.format(SOURCE.format("topic: scan")))


@pytest.mark.parametrize(
    ("yaml", "severity"),
    [
        (RELATIVE, ""),
        (RELATIVE + JAZZY, "info"),
        (RELATIVE + JAZZY.replace("::", "/"), "warning"),
        (RELATIVE + JAZZY.replace("spin:", "introspection_mode: disabled, spin:"), ""),
        (RELATIVE.replace("topic: scan", "topic: /scan") + JAZZY, ""),
    ],
)
def test_relative_topics_of_a_costmap(tmp_path: Path, yaml: str, severity: str) -> None:
    text = PROGRAM.format(CONTROLLER, '"controller_server"')
    found = reported(tmp_path / "arm", "LAU026", "a.launch.py", text, {"a.yaml": yaml})
    assert ["in its namespace" in one.message for one in found] == [True] * bool(severity)
    assert [one.severity.value for one in found] == [severity] * bool(severity)


NAV2_OF_A_ROBOT = """\
from ament_index_python.packages import get_package_share_directory
from launch.actions import IncludeLaunchDescription

nav2 = IncludeLaunchDescription(
    get_package_share_directory("nav2_bringup") + "/launch/bringup_launch.py",
    launch_arguments={{
        "namespace": "{}",
        "use_namespace": "true",
        "params_file": get_package_share_directory("arm") + "/a.yaml",
    }}.items(),
)
"""


@pytest.mark.parametrize(("namespace", "topic"), [("a200", "/a200/scan"), ("", "/scan")])
def test_a_relative_topic_in_the_namespace_of_nav2(
    tmp_path: Path, namespace: str, topic: str
) -> None:
    """multi_robot_ros2: /scan is that of no robot."""
    text = NAV2_OF_A_ROBOT.format(namespace)
    files = {"a.yaml": RELATIVE + JAZZY}
    (found,) = reported(tmp_path / "arm", "LAU026", "a.launch.py", text, files)
    assert found.help == f"write {topic}"


def test_a_relative_topic_in_the_namespace_of_the_section(tmp_path: Path) -> None:
    """yahboomcar_multi: `robot1/local_costmap` is the section of one of two robots."""
    yaml = (RELATIVE + JAZZY).replace("local_costmap:", "robot1/local_costmap:", 1)
    text = PROGRAM.format(CONTROLLER, '"controller_server"')
    (found,) = reported(tmp_path / "arm", "LAU026", "a.launch.py", text, {"a.yaml": yaml})
    assert found.help == "write /robot1/scan"


def test_a_relative_topic_that_another_launch_file_remaps(tmp_path: Path) -> None:
    text = PROGRAM.format(CONTROLLER, '"controller_server"')
    files = {
        "a.yaml": RELATIVE + JAZZY,
        "launch/nav2.launch.py": "SetRemap('/local_costmap/scan', '/scan')\n",
    }
    assert reported(tmp_path / "arm", "LAU026", "a.launch.py", text, files) == []


SOLID = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'
SOLID += '</inertial><collision><geometry><sphere radius="0.1"/></geometry></collision>'
WHEELS = '<robot name="r"><link name="base_link"/>' + "".join(
    f'''<link name="{name}">{SOLID}</link><joint name="{name}_joint" type="{{}}">
<parent link="base_link"/><child link="{name}"/><origin xyz="{x} {y} 0"/><axis xyz="0 1 0"/>
</joint>'''
    for name, x, y in (("a", 0.3, 0.3), ("b", 0.3, -0.3), ("c", -0.3, 0.3), ("d", -0.3, -0.3))
)
WHEELS += "</robot>"
SMALL = "footprint: '[[0.2, 0.2], [0.2, -0.2], [-0.2, -0.2], [-0.2, 0.2]]'"


@pytest.mark.parametrize(
    ("values", "kind", "count"),
    [
        (SMALL, "continuous", 1),
        (SMALL.replace("0.2", "0.28"), "continuous", 0),
        (SMALL.replace("0.2", "0.4"), "continuous", 0),
        (SMALL, "fixed", 0),  # legs, perhaps
        (SMALL + ", robot_base_frame: nowhere", "continuous", 0),
        (SMALL + ", robot_base_frame: base_link", "continuous", 1),
        ("robot_radius: 0.2", "continuous", 1),
        ("robot_radius: 0.4", "continuous", 0),
        ("robot_radius: 0.2, footprint: '[]'", "continuous", 1),
    ],
)
def test_wheels_outside_of_the_footprint(
    tmp_path: Path, values: str, kind: str, count: int
) -> None:
    text = (
        "from launch_ros.actions import Node\n\n"
        "state = Node(package='robot_state_publisher', executable='robot_state_publisher', "
        f"parameters=[{{'robot_description': open('{tmp_path}/r.urdf').read()}}])\n"
        "server = Node(package='nav2_controller', executable='controller_server', "
        "parameters=['../a.yaml'])\n"
    )
    yaml = COSTMAP_OF.format(values)
    files = {"a.yaml": yaml, "r.urdf": WHEELS.format(*[kind] * 4)}
    found = reported(tmp_path, "LAU026", "a.launch.py", text, files)
    words = [one.message for one in found if "leaves out" in one.message]
    assert len(words) == count
    assert all("0.424 m" in one for one in words)


FAST = (
    "controller_server: {{ros__parameters: {{FollowPath: {{plugin: {}, {}}}}}}}\n"
    "velocity_smoother: {{ros__parameters: {{max_velocity: [0.5, 0.0, 1.0], x: 1}}}}\n"
)
PURSUIT = "'nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController'"


@pytest.mark.parametrize(
    ("plugin", "speed", "count"),
    [
        (PLAIN_MPPI, "vx_max: 0.5", 0),
        (PLAIN_MPPI, "vx_max: 0.9", 0),
        (PLAIN_MPPI, "vx_max: 1.0", 1),
        (PLAIN_MPPI, "max_vel_x: 1.0", 0),
        (DWB, "max_vel_x: 1.0", 1),
        (PURSUIT, "desired_linear_vel: 1.0", 1),
    ],
)
def test_a_controller_beyond_the_smoother(
    tmp_path: Path, plugin: str, speed: str, count: int
) -> None:
    found = messages("LAU026", tmp_path, FAST.format(plugin, speed))
    assert sum("velocity_smoother limits" in one for one in found) == count
