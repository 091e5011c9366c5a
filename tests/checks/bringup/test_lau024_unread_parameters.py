"""LAU024: see the rule; planted defects are in tests/bringup/planted.txt."""

from pathlib import Path

import pytest

from tests.checks.bringup.nav2 import (
    CONTROLLER,
    COSTMAP_OF,
    EKF,
    JAZZY,
    PARAMETERS,
    WATCH,
    messages,
    rows,
)
from tests.launched import reported
from tests.naming import naming


@pytest.mark.parametrize(
    ("name", "key", "count"),
    [
        ('name="controller"', "controller", 0),
        ('name="controller"', "/**", 0),
        ('name="controller"', "/robot/controller", 0),
        ('name="controller"', "controller_server", 1),
        ("", "controller", 1),  # servers of Nav2 have the names of their executables
        ("", "other", 0),
        ('name="controller", namespace="robot"', "other", 0),
        ('name="controller", namespace="robot"', "controller", 1),
        ('name="controller", namespace="/robot"', "/robot/controller", 0),
        ('name="controller", namespace="robot"', "/**/controller", 0),
        ('name="controller", namespace=LaunchConfiguration("ns")', "controller", 0),
        ('namespace="robot"', "controller_server", 1),
    ],
)
def test_the_name_of_the_node(tmp_path: Path, name: str, key: str, count: int) -> None:
    node = f"{CONTROLLER}, {name}" if name else CONTROLLER
    listed = '"controller"' if "controller" in name else '"controller_server"'
    found = messages("LAU024", tmp_path, PARAMETERS.format(key), node, listed)
    assert len([one for one in found if "not read" in one]) == count


@pytest.mark.parametrize(("key", "count"), [("joy_node", 0), ("joy", 1), ("own", 0)])
def test_a_file_of_two_nodes(tmp_path: Path, key: str, count: int) -> None:
    """What is for no node counts if it is almost the name of one."""
    text = "<node pkg='joy' exec='joy_node' name='joy_node'><param from='../a.yaml'/></node>\n"
    text += "<node pkg='own' exec='own' name='robot'><param from='../a.yaml'/></node>\n"
    yaml = PARAMETERS.format("robot") + PARAMETERS.format(key)
    found = reported(tmp_path / "arm", "LAU024", "a.launch.xml", text, {"a.yaml": yaml})
    assert ["the node is 'joy_node'" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(
    ("key", "count"), [("controller_manager", 1), ("arm/controller_manager", 0)]
)
def test_a_controller_manager_in_a_namespace(tmp_path: Path, key: str, count: int) -> None:
    """The manager of the spawners, /arm/controller_manager, has no controllers."""
    node = (
        'package="controller_manager", executable="ros2_control_node", namespace="arm", '
        'parameters=["../a.yaml"]'
    )
    assert len(messages("LAU024", tmp_path, PARAMETERS.format(key), node, "")) == count


@pytest.mark.parametrize(
    ("key", "count"),
    [
        ("local_costmap", 1),
        ("robot/local_costmap", 1),
        ("local_costmap/local_costmap", 0),
        ("/**/local_costmap", 0),
    ],
)
def test_a_costmap_is_its_own_namespace(tmp_path: Path, key: str, count: int) -> None:
    yaml = f"{key}:\n  ros__parameters:\n    robot_base_frame: base_link\n"
    found = messages("LAU024", tmp_path, yaml)
    assert len([one for one in found if "local_costmap/local_costmap'" in one]) == count


@pytest.mark.parametrize(
    ("values", "suggested"),
    [
        ("controler_frequency: 20.0", "controller_frequency"),
        ("controler_frequency: 20.0, controller_frequency: 10.0", ""),
        ("frequency: 20.0", ""),
        ("a: {plugin: nav2_controller::SimpleGoalChecker, xy_goal_tolerence: 0.2}", "xy_goal_tol"),
        ("a: {plugin: own::Checker, xy_goal_tolerence: 0.2}", ""),
        ("a: {plugin: nav2_mppi_controller::MPPIController, az_min: 0.2}", ""),  # not ay_min
    ],
)
def test_misspelt_names(tmp_path: Path, values: str, suggested: str) -> None:
    yaml = f"controller_server:\n  ros__parameters: {{{values}}}\n"
    found = messages("LAU024", tmp_path, yaml)
    assert [f"did you mean '{suggested}" in one for one in found] == [True] * bool(suggested)


@pytest.mark.parametrize(
    ("launched", "in_file", "names"),
    [
        ("use_sim_time", "use_sim_time", []),
        ("use_tim_time", "use_sim_time", ["use_tim_time"]),
        ("rate", "use_simtime", ["use_simtime"]),
        ("use_sim", "use_sim_time2", []),
    ],
)
def test_a_misspelt_clock_of_any_node(
    tmp_path: Path, launched: str, in_file: str, names: list[str]
) -> None:
    """From ros/urdf_launch#3."""
    text = "Node(package='own', executable='own', name='own', "
    text += f"parameters=['{tmp_path}/a.yaml', {{'{launched}': True}}])\n"
    files = {"a.yaml": f"own: {{ros__parameters: {{{in_file}: true}}}}\n"}
    found = reported(tmp_path, "LAU024", "a.launch.py", text, files)
    assert [one.message.split("'")[3] for one in found] == names
    assert [one.help for one in found] == ["write use_sim_time"] * len(names)


@pytest.mark.parametrize(("name", "count"), [("slam_toolbox", 0), ("async_slam_toolbox_node", 1)])
def test_file_passed_to_a_launch_file_of_ros(tmp_path: Path, name: str, count: int) -> None:
    text = (
        "IncludeLaunchDescription(\n"
        "    get_package_share_directory('slam_toolbox') + '/launch/online_async_launch.py',\n"
        f"    launch_arguments={{'slam_params_file': '{tmp_path}/slam.yaml'}}.items(),\n)\n"
    )
    files = {"slam.yaml": f"{name}: {{ros__parameters: {{mode: mapping}}}}\n"}
    found = reported(tmp_path, "LAU024", "a.launch.py", text, files)
    assert len(found) == count
    assert all("node is 'slam_toolbox'" in one.message for one in found)


BOTH = (
    "controller_server: {ros__parameters: {goal_checker_plugin: g, "
    "goal_checker_plugins: [g], g: {plugin: a}}}\n"
)
LIBRARIES = "bt_navigator: {{ros__parameters: {{plugin_lib_names: [{}]}}}}\n"
MUX = "twist_mux: {{ros__parameters: {{topics: {{joy: {{{}}}}}{}}}}}\n"
JOY = "topic: joy, timeout: 0.5, priority: 1"


@pytest.mark.parametrize(
    ("yaml", "before", "since"),
    [
        ("controller_server: {ros__parameters: {goal_checker_plugin: g}}\n", 0, 1),
        (BOTH, 0, 0),
        ("bt_navigator: {ros__parameters: {default_bt_xml_filename: a.xml}}\n", 0, 1),
        ("recoveries_server: {ros__parameters: {cycle_frequency: 1.0}}\n", 0, 0),  # both are given
        (LIBRARIES.format("nav2_wait_action_bt_node"), 0, 1),
        (LIBRARIES.format("my_wait_action_bt_node"), 0, 0),
        (MUX.format(JOY, ""), 0, 1),
        (MUX.format(JOY, ", use_stamped: true"), 0, 0),
        ("teleop_twist_joy_node: {ros__parameters: {scale_linear: 0.5}}\n", 1, 1),
        ("teleop_twist_joy_node: {ros__parameters: {scale_linear: {x: 0.5}}}\n", 0, 0),
    ],
)
def test_parameters_of_other_releases(tmp_path: Path, yaml: str, before: int, since: int) -> None:
    """Only other names of Jazzy in the workspace tell that a file is for Jazzy."""
    is_jazzy = "use_stamped" in yaml
    for name, text, count in (
        ("1", yaml, since if is_jazzy else before),
        ("2", yaml + JAZZY, since),
    ):
        (tmp_path / name).mkdir()
        found = messages("LAU024", tmp_path / name, text)
        assert len(found) == count


def test_points_of_a_polygon(tmp_path: Path) -> None:
    yaml = WATCH.format("near", "polygon, points: [0.1, 0.2, -0.1, 0.2]")
    assert messages("LAU024", tmp_path, yaml) == []
    (tmp_path / "jazzy").mkdir()
    (found,) = messages("LAU024", tmp_path / "jazzy", yaml + JAZZY)
    assert "points is a list" in found


MASKS = "{}k: {{plugin: 'nav2_costmap_2d::KeepoutFilter', enabled: {}}}"


@pytest.mark.parametrize(
    ("values", "count"),
    [
        (MASKS.format("", "true"), 1),
        (MASKS.format("", "false"), 0),
        (MASKS.format("filters: [k], ", "true"), 0),
    ],
)
def test_filters_of_a_costmap(tmp_path: Path, values: str, count: int) -> None:
    found = messages("LAU024", tmp_path, COSTMAP_OF.format(values))
    assert ["does not load 'k'" in one for one in found] == [True] * count


SCANS = "b: {{plugin: 'nav2_costmap_2d::{}', {}scan: {{topic: /scan, marking: true}}}}"


@pytest.mark.parametrize(
    ("values", "count"),
    [
        (SCANS.format("ObstacleLayer", ""), 1),
        (SCANS.format("VoxelLayer", ""), 1),
        (SCANS.format("ObstacleLayer", "observation_sources: scan, "), 0),
        (SCANS.format("InflationLayer", ""), 0),
        (SCANS.format("ObstacleLayer", "").replace("topic", "a").replace("marking", "b"), 0),
    ],
)
def test_sources_of_a_layer_that_lists_none(tmp_path: Path, values: str, count: int) -> None:
    found = messages("LAU024", tmp_path, COSTMAP_OF.format(values))
    assert ["reads no 'scan'" in one for one in found] == [True] * count


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ("odom0: /odom, odom0_config: [true]", ""),
        ("odom0_config: [true]", "does not read odom0_config"),
        ("imu0: /imu, odom0_config: [true], odom0: /odom", "nothing of imu0 is read"),
    ],
)
def test_inputs_of_a_filter(tmp_path: Path, values: str, words: str) -> None:
    node = 'package="robot_localization", executable="ekf_node", name="ekf"'
    yaml = f"ekf: {{ros__parameters: {{{values}}}}}\n"
    found = messages("LAU024", tmp_path, yaml, f'{node}, parameters=["../a.yaml"]', "")
    assert [words in one for one in found] == [True] * bool(words)


@pytest.mark.parametrize(
    ("values", "suggested"), [("odom0_confg: 1", ""), ("two_d_mod: true", "two_d_mode")]
)
def test_misspelt_names_of_a_filter(tmp_path: Path, values: str, suggested: str) -> None:
    yaml = EKF.format(f"{values}, odom0: odom, odom0_config: {rows(2)}")
    found = messages("LAU024", tmp_path, yaml)
    assert [f"'{suggested}'" in one for one in found] == [True] * bool(suggested)


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ("FollowPath: {plugin: %s, controller_frequency: 30.0}", "of itself, not of its plugin"),
        ("FollowPath: {plugin: %s, vx_max: 1.0}", ""),
        ("vx_max: 1.0, FollowPath: {plugin: %s}", "of its plugin 'FollowPath', not of itself"),
        ("vx_max: 1.0, FollowPath: {plugin: %s, vx_max: 1.0}", ""),
        ("vx_max: 1.0, FollowPath: {plugin: 'a::B'}", ""),
        ("FollowPath: {plugin: %s, use_sim_time: true}", ""),
    ],
)
def test_a_parameter_at_another_level(tmp_path: Path, values: str, words: str) -> None:
    values = values.replace("%s", "'nav2_mppi_controller::MPPIController'")
    found = messages("LAU024", tmp_path, f"controller_server: {{ros__parameters: {{{values}}}}}\n")
    assert [words in one for one in found] == [True] * bool(words)


@pytest.mark.parametrize(
    ("name", "section", "count"),
    [
        ("teleop_twist_joy_node", "teleop_twist_joy_node", 0),
        ("teleop", "teleop_twist_joy_node", 1),
        ("teleop", "teleop_twist_joy", 1),
        ("teleop", "other_node", 0),  # of a node that another launch file starts
    ],
)
def test_a_section_with_the_name_of_the_package(
    tmp_path: Path, name: str, section: str, count: int
) -> None:
    """Next to that of another node, which reads its own."""
    sections = ("joy_node", section)
    yaml = "".join(f"{node}: {{ros__parameters: {{rate: 5.0}}}}\n" for node in sections)
    load = '<param from="../a.yaml"/></node>'
    text = f'<node pkg="joy" exec="joy_node" name="joy_node">{load}\n'
    text += f'<node pkg="teleop_twist_joy" exec="teleop_node" name="{name}">{load}\n'
    found = reported(tmp_path / "arm", "LAU024", "a.launch.xml", text, {"a.yaml": yaml})
    assert [one.message for one in found] == [naming(section, name)] * count


@pytest.mark.parametrize(("section", "count"), [("map_saver", 0), ("map_serve", 1)])
def test_sections_of_the_map_server(tmp_path: Path, section: str, count: int) -> None:
    """The parameters of Nav2 have a section for map_saver, but often none for map_server."""
    text = (
        "from launch.actions import IncludeLaunchDescription\n"
        "included = IncludeLaunchDescription(PythonLaunchDescriptionSource("
        "[FindPackageShare('nav2_bringup'), '/launch/localization_launch.py']), "
        f"launch_arguments={{'params_file': '{tmp_path}/arm/a.yaml'}}.items())\n"
    )
    names = ("amcl", section)
    yaml = "".join(f"{name}: {{ros__parameters: {{use_sim_time: true}}}}\n" for name in names)
    found = reported(tmp_path / "arm", "LAU024", "a.launch.py", text, {"a.yaml": yaml})
    assert [one.message for one in found] == [naming(section, "map_server")] * count
