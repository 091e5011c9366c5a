"""LAU024: see the rule; planted defects are in tests/bringup/planted.txt."""

from pathlib import Path

import pytest

from tests.launched import reported

PROGRAM = """\
from launch_ros.actions import Node

nodes = [
    Node({}),
    Node(package="nav2_lifecycle_manager", executable="lifecycle_manager", name="manager",
         parameters=[{{"autostart": True, "node_names": [{}]}}]),
]
"""
CONTROLLER = 'package="nav2_controller", executable="controller_server", parameters=["../a.yaml"]'
PARAMETERS = "{}:\n  ros__parameters:\n    rate: 1.0\n"


def messages(directory: Path, node: str, names: str, yaml: str) -> list[str]:
    text = PROGRAM.format(node, names)
    found = reported(directory / "arm", "LAU024", "a.launch.py", text, {"a.yaml": yaml})
    return [one.message for one in found]


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
    found = messages(tmp_path, node, listed, PARAMETERS.format(key))
    assert len([one for one in found if "not read" in one]) == count


@pytest.mark.parametrize(
    ("load", "count"),
    [
        ('<rosparam file="$(dirname)/../a.yaml" command="load"/>', 0),
        ('<param from="$(dirname)/../a.yaml"/>', 1),
    ],
)
def test_a_file_of_ros2_that_ros1_loads(tmp_path: Path, load: str, count: int) -> None:
    """stretch_ros: AMCL of ROS 1 and its file of ROS 2, of which it reads nothing."""
    node = f'<node pkg="nav2_amcl" exec="amcl" type="amcl" name="amcl">{load}</node>'
    yaml = "amcl:\n  ros__parameters: {robot_model_type: differential}\n"
    found = reported(tmp_path / "arm", "LAU024", "a.launch", node, {"a.yaml": yaml})
    assert len([one for one in found if "robot_model_type" in one.message]) == count


@pytest.mark.parametrize(
    ("key", "count"), [("controller_manager", 1), ("arm/controller_manager", 0)]
)
def test_a_controller_manager_in_a_namespace(tmp_path: Path, key: str, count: int) -> None:
    """The manager of the spawners, /arm/controller_manager, has no controllers."""
    node = (
        'package="controller_manager", executable="ros2_control_node", namespace="arm", '
        'parameters=["../a.yaml"]'
    )
    assert len(messages(tmp_path, node, "", PARAMETERS.format(key))) == count


@pytest.mark.parametrize(
    ("names", "message"),
    [
        ('"controller_server"', ""),
        ('"controller_server", "planner_server"', "waits for planner_server"),
        ('"planner_server"', ""),  # whose nodes another file starts
        ("", ""),
    ],
)
def test_lifecycle_managers(tmp_path: Path, names: str, message: str) -> None:
    found = messages(tmp_path, CONTROLLER, names, PARAMETERS.format("controller_server"))
    assert [message in one for one in found] == [True] * bool(message)


@pytest.mark.parametrize(
    ("plugins", "section", "count"),
    [
        ("[obstacle_layer]", "obstacle_layer: {plugin: a::B}", 0),
        ("[voxel_layer]", "obstacle_layer: {plugin: a::B}", 1),
        ("[static_layer, obstacle_layer, inflation_layer]", "rate: 1.0", 0),  # the defaults
    ],
)
def test_plugins_of_a_costmap(tmp_path: Path, plugins: str, section: str, count: int) -> None:
    yaml = (
        "local_costmap:\n  local_costmap:\n    ros__parameters:\n"
        f"      plugins: {plugins}\n      {section}\n"
    )
    found = messages(tmp_path, CONTROLLER, '"controller_server"', yaml)
    assert len([one for one in found if "no parameters for" in one]) == count


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
    found = messages(tmp_path, CONTROLLER, '"controller_server"', yaml)
    expected = [f"obstacles of '{name}'" for name in names]
    assert len(found) == len(expected)
    assert all(words in one for words, one in zip(expected, found, strict=True))


@pytest.mark.parametrize(
    ("values", "help", "severity"),
    [
        ("max_decel: [-1.0, 0.0, -2.0]", "", ""),
        ("max_decel: [-1.0, 0.0, 2.0]", "write -2.0", "error"),
        ("max_accel: [1.0, -0.5, 2.0]", "write 0.5", "error"),
        ("min_velocity: [0.1, 0.0, -1.0]", "write -0.1", "warning"),
        ("min_velocity: [0.0, 0.0, -1.0]", "", ""),
    ],
)
def test_signs_of_limits(tmp_path: Path, values: str, help: str, severity: str) -> None:
    yaml = f"velocity_smoother:\n  ros__parameters:\n    {values}\n"
    text = PROGRAM.format(CONTROLLER, '"controller_server"')
    found = reported(tmp_path / "arm", "LAU024", "a.launch.py", text, {"a.yaml": yaml})
    found = [one for one in found if "must not be" in one.message]
    assert [(one.help, one.severity.value) for one in found] == [(help, severity)] * bool(help)


COSTMAP = "local_costmap:\n  local_costmap:\n    ros__parameters:\n      {}\n"
LAYER = "layer: {{plugin: {}, observation_sources: scan, scan: {{data_type: {}}}}}"


@pytest.mark.parametrize(
    ("plugin", "data", "message"),
    [
        ("nav2_costmap_2d::ObstacleLayer", "LaserScan", ""),
        ("nav2_costmap_2d::VoxelLayer", "PointCloud2", ""),
        (
            "nav2_costmap_2d::VoxelLayers",
            "PointCloud2",
            "did you mean 'nav2_costmap_2d::Vox",
        ),
        ("nav2_costmap_2d/VoxelLayer", "PointCloud2", "did you mean 'nav2_costmap_2d::Vox"),
        ("costmap_2d::VoxelLayer", "PointCloud2", "did you mean 'nav2_costmap_2d::Vox"),
        ("nav2_costmap_2d::SemanticLayer", "PointCloud2", ""),  # of a newer Nav2, perhaps
        ("my_layers::ObstacleLayer", "Image", ""),
        ("nav2_costmap_2d::ObstacleLayer", "laserscan", "data_type 'laserscan', which stops"),
    ],
)
def test_layers(tmp_path: Path, plugin: str, data: str, message: str) -> None:
    yaml = COSTMAP.format(LAYER.format(f'"{plugin}"', data))
    found = messages(tmp_path, CONTROLLER, '"controller_server"', yaml)
    assert [message in one for one in found] == [True] * bool(message)


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
    found = messages(tmp_path, CONTROLLER, '"controller_server"', yaml)
    assert len([one for one in found if "local_costmap/local_costmap'" in one]) == count


@pytest.mark.parametrize(
    ("value", "message"),
    [
        ("controller_frequency: 20", "controller_frequency is an integer"),
        ("controller_frequency: -20", "controller_frequency is an integer"),
        ("controller_frequency: 20.0", ""),
        ("controller_frequency: '20'", "controller_frequency is a string"),
        ("controller_frequency: $(var rate)", ""),
        ("publish_zero_velocity: 1", "publish_zero_velocity is an integer"),
        ("a: {plugin: own::Controller, yaw_goal_tolerance: 1}", ""),
        ("a: {plugin: nav2_controller::SimpleGoalChecker, yaw_goal_tolerance: 1}", "an integer"),
        ("min_particles: 20", ""),
        ("frequency: 20", ""),  # of a filter alone
        ("frequency: 20\n    odom0_config: []", "frequency is an"),
        ("a: [[1, 2], [3, 4]]", "list of lists"),
        ("a: [[1, 2]]", ""),  # read as a flat list
    ],
)
def test_types(tmp_path: Path, value: str, message: str) -> None:
    yaml = f"controller_server:\n  ros__parameters:\n    {value}\n"
    found = messages(tmp_path, CONTROLLER, '"controller_server"', yaml)
    found = [one for one in found if "values, not 15" not in one]
    assert [message in one for one in found] == [True] * bool(message)


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
    found = messages(tmp_path, CONTROLLER, '"controller_server"', yaml)
    assert [f"did you mean '{suggested}" in one for one in found] == [True] * bool(suggested)


@pytest.mark.parametrize(
    ("default", "loaded", "count"),
    [
        ('"ompl"', '["ompl"]', 0),
        ('"pilz"', '["ompl"]', 1),
        ('"pilz"', '["ompl", pipeline]', 0),
        ('"pilz"', "pipelines", 0),
    ],
)
def test_the_default_pipeline(tmp_path: Path, default: str, loaded: str, count: int) -> None:
    node = (
        'package="moveit_ros_move_group", executable="move_group", parameters=['
        f'{{"planning_pipelines": {loaded}, "default_planning_pipeline": {default}, "ompl": x}}]'
    )
    found = messages(tmp_path, node, "", "")
    assert ["is not in planning_pipelines" in one for one in found] == [True] * count


@pytest.mark.parametrize(("value", "count"), [("30.0", 0), ("30", 1), ("rate", 0)])
def test_how_often_the_state_is_published(tmp_path: Path, value: str, count: int) -> None:
    node = (
        'package="robot_state_publisher", executable="robot_state_publisher", '
        f'parameters=[{{"publish_frequency": {value}}}]'
    )
    found = messages(tmp_path, node, "", "")
    assert ["30 is an integer" in one for one in found] == [True] * count
    yaml = f"robot_state_publisher:\n  ros__parameters: {{publish_frequency: {value}}}\n"
    node = node.partition("parameters")[0] + 'parameters=["../a.yaml"]'
    found = messages(tmp_path, node, "", yaml)
    assert ["be a number" in one for one in found] == [True] * (value != "30.0")


BUILDER = """from moveit_configs_utils import MoveItConfigsBuilder

config = MoveItConfigsBuilder("arm", package_name="arm").to_moveit_configs()
"""


@pytest.mark.parametrize(
    ("yaml", "help"),
    [
        ("planning_plugins: [ompl_interface/OMPLPlanner]\n", ""),
        ("planning_plugin: ompl_interface/OMPLPlanner\n", ""),
        ("planner_configs: {}\n", "add planning_plugins"),
        ("ompl: {planning_plugin: ompl_interface/OMPLPlanner}\n", "remove 'ompl:'"),
        ("", ""),
    ],
)
def test_the_plugin_of_a_pipeline(tmp_path: Path, yaml: str, help: str) -> None:
    files = {"config/ompl_planning.yaml": yaml}
    found = reported(tmp_path / "arm", "LAU024", "a.launch.py", BUILDER, files)
    assert [one.help.startswith(help) for one in found] == [True] * bool(help)


@pytest.mark.parametrize(
    ("file", "text", "words"),
    [
        (
            "kinematics.yaml",
            "/**: {ros__parameters: {robot_description_kinematics: {arm: {kinematics_solver: a}}}}",
            "remove '/**:', 'ros__parameters:', 'robot_de",
        ),
        ("kinematics.yaml", "robot_description_kinematics: {arm: {a: b}}", "remove 'robot_descrip"),
        ("kinematics.yaml", "arm: {kinematics_solver: a}", ""),
        ("joint_limits.yaml", "robot_description_planning: {joint_limits: {}}", "remove 'robot_de"),
        ("joint_limits.yaml", "joint_limits: {a: {max_velocity: 1.0}}", ""),
        ("moveit_controllers.yaml", "a: {ros__parameters: {b: c}}", "remove 'a:', 'ros__param"),
    ],
)
def test_files_of_the_builder(tmp_path: Path, file: str, text: str, words: str) -> None:
    files = {f"config/{file}": text}
    found = reported(tmp_path / "arm", "LAU024", "a.launch.py", BUILDER, files)
    assert [one.help.startswith(words) for one in found] == [True] * bool(words)


@pytest.mark.parametrize(
    ("calls", "missing"),
    [
        ("", "kinematics.yaml, joint_limits.yaml, pilz_cartesian_limits.yaml, arm.srdf"),
        (
            '.planning_pipelines(pipelines=["ompl"]).joint_limits(file_path=x)',
            "kinematics.yaml, arm.srdf",
        ),
        (
            ".planning_pipelines(load_all=False).joint_limits(x).robot_description_semantic(z)",
            "kinematics.yaml",
        ),
    ],
)
def test_files_that_the_builder_needs(tmp_path: Path, calls: str, missing: str) -> None:
    text = BUILDER.replace(".to_moveit", f"{calls}.to_moveit")
    (found,) = reported(tmp_path / "arm", "LAU003", "a.launch.py", text)
    assert found.message.rpartition(": ")[2] == missing


@pytest.mark.parametrize(("file", "count"), [("b.srdf", 0), ("arm.srdf", 1)])
def test_the_srdf_that_the_setup_assistant_names(tmp_path: Path, file: str, count: int) -> None:
    setup = "moveit_setup_assistant_config:\n  srdf:\n    relative_path: config/b.srdf\n"
    calls = ".planning_pipelines(load_all=False).joint_limits(x).robot_description_kinematics(y)"
    text = BUILDER.replace(".to_moveit", f"{calls}.to_moveit")
    files = {".setup_assistant": setup, f"config/{file}": "<robot name='r'/>"}
    found = reported(tmp_path / "arm", "LAU003", "a.launch.py", text, files)
    assert [one.message.rpartition(": ")[2] for one in found] == ["b.srdf"] * count


@pytest.mark.parametrize(
    ("names", "calls", "count"),
    [
        (["a_controllers.yaml", "b_controllers.yaml"], "", 1),
        (["a_controllers.yaml", "moveit_controllers.yaml"], "", 0),
        (["a_controllers.yaml"], "", 0),
        (["a_controllers.yaml", "b_controllers.yaml"], ".trajectory_execution(x)", 0),
    ],
)
def test_files_of_controllers(tmp_path: Path, names: list[str], calls: str, count: int) -> None:
    files = {f"config/{name}": "a: 1\n" for name in names}
    text = BUILDER.replace(".to_moveit", f"{calls}.to_moveit")
    found = reported(tmp_path / "arm", "LAU024", "a.launch.py", text, files)
    assert ["cannot choose" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(
    ("use", "needs_planner"),
    [
        ("generate_setup_assistant_launch(config)", False),
        ("generate_rsp_launch(config)", False),
        ("generate_move_group_launch(config)", True),
        ("generate_rsp_launch(config); Node(parameters=[config.to_dict()])", True),
        ("generate_moveit_rviz_launch(config); print(config.planning_pipelines)", True),
    ],
)
def test_launches_that_need_no_planner(tmp_path: Path, use: str, needs_planner: bool) -> None:
    """TurtleBot3's manipulation: only its Setup Assistant is launched with the builder."""
    files = {"config/ompl_planning.yaml": "planner_configs: {}\n"}
    text = f"{BUILDER}\n{use}\n"
    found = reported(tmp_path / "arm", "LAU024", "a.launch.py", text, files)
    assert ["planning plugin" in one.message for one in found] == [True] * needs_planner


HANDED = """import yaml
from launch_ros.actions import Node

def load_yaml(package, path):
    return yaml.safe_load(open(path))

settings = {}
Node(package="moveit_ros_move_group", executable="move_group", parameters=[{}, settings])
"""
PIPELINES = '{{"planning_pipelines": ["ompl"], "ompl": {}}}'


@pytest.mark.parametrize(
    ("settings", "extra", "words"),
    [
        ("{}", PIPELINES.format('load_yaml("arm", "ompl.yaml")'), ""),
        ("{}", PIPELINES.format('load_yaml("arm", "empty.yaml")'), "no planning plugin"),
        ("{}", PIPELINES.format('load_yaml("arm", "missing.yaml")'), ""),
        ("{}", PIPELINES.format('{"planning_plugin": "ompl_interface/OMPLPlanner"}'), ""),
        ("{}", '{"planning_pipelines": ["ompl"]}', "no planning plugin"),
        ("other()", '{"planning_pipelines": ["ompl"]}', ""),
        ("{}\nsettings.update(x=1)", '{"planning_pipelines": ["ompl"]}', ""),
        ("{}", 'load_yaml("arm", "solvers.yaml")', "are not in robot_description_kinematics"),
        ("{}", '{"robot_description_kinematics": load_yaml("arm", "solvers.yaml")}', ""),
        ("{}", '"a.yaml"', ""),
        ("{}", '{"robot_description": x}', "no robot_description_semantic"),
        ("{}", '{"robot_description": x, "robot_description_semantic": y}', ""),
    ],
)
def test_parameters_of_move_group(tmp_path: Path, settings: str, extra: str, words: str) -> None:
    text = HANDED.replace("settings = {}", f"settings = {settings}").replace("[{}", f"[{extra}")
    files = {
        "ompl.yaml": "planning_plugins: [ompl_interface/OMPLPlanner]\n",
        "empty.yaml": "planner_configs: {}\n",
        "solvers.yaml": "arm: {kinematics_solver: kdl_kinematics_plugin/KDLKinematicsPlugin}\n",
    }
    found = reported(tmp_path / "arm", "LAU024", "a.launch.py", text, files)
    assert [words in finding.message for finding in found] == [True] * bool(words)
    # MoveIt of Humble reads solvers at the top level, too: so does franka_ros2 pass them.
    severity = "info" if "kinematics" in words else "warning"
    assert {finding.severity.value for finding in found} <= {severity}


@pytest.mark.parametrize(
    ("server", "plugin", "help"),
    [
        ("planner_server", "nav2_navfn_planner/NavfnPlanner", ""),
        ("planner_server", "nav2_navfn_planner::NavfnPlanner", ""),
        (
            "planner_server",
            "nav2_navfn_planner/NavfnPlaner",
            "write nav2_navfn_planner/NavfnPlanner",
        ),
        ("controller_server", "dwb_core::DWBLocalPlaner", "write dwb_core::DWBLocalPlanner"),
        ("controller_server", "my_planner::Own", ""),
    ],
)
def test_plugins_of_servers(tmp_path: Path, server: str, plugin: str, help: str) -> None:
    yaml = f"{server}:\n  ros__parameters:\n    mine:\n      plugin: {plugin}\n"
    node = CONTROLLER.replace("controller_server", server)
    text = PROGRAM.format(node, f'"{server}"')
    found = reported(tmp_path / "arm", "LAU024", "a.launch.py", text, {"a.yaml": yaml})
    assert [one.help for one in found] == [help] * bool(help)


@pytest.mark.parametrize(("width", "count"), [("3", 0), ("3.0", 1), ("$(var width)", 0)])
def test_the_size_of_a_costmap(tmp_path: Path, width: str, count: int) -> None:
    yaml = f"local_costmap:\n  local_costmap:\n    ros__parameters:\n      width: {width}\n"
    found = messages(tmp_path, CONTROLLER, '"controller_server"', yaml)
    assert ["as an integer" in one for one in found] == [True] * count


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


@pytest.mark.parametrize(
    ("package", "executable", "old", "count"),
    [
        ("controller_manager", "spawner", "/drive/cmd_vel", 1),
        ("controller_manager", "spawner", "~/cmd_vel", 1),
        ("controller_manager", "spawner", "/controller_manager/list_controllers", 0),
        ("controller_manager", "ros2_control_node", "/drive/cmd_vel", 0),
        ("robot_state_publisher", "robot_state_publisher", "/drive/cmd_vel", 1),
        ("robot_state_publisher", "robot_state_publisher", "/joint_states", 0),
    ],
)
def test_remappings_of_a_controller(
    tmp_path: Path, package: str, executable: str, old: str, count: int
) -> None:
    node = 'Node(package="{}", executable="{}", arguments=["drive"], remappings=[("{}", "/x")])'
    other = 'Node(package="controller_manager", executable="spawner", arguments=["drive"])'
    nodes = f"{node.format(package, executable, old)}, {other}"
    text = f"from launch_ros.actions import Node\n\nnodes = [{nodes}]\n"
    found = reported(tmp_path / "arm", "LAU024", "a.launch.py", text)
    words = f"remapping of '{old}'"
    assert [one.message.partition(" has")[0] for one in found] == [words] * count


@pytest.mark.parametrize(
    ("path", "count"),
    [
        ("package://arm/mesh.stl", 0),
        ("file://{}/mesh.stl", 0),
        ("{}/mesh.stl", 1),
        ("mesh.stl", 1),
        ("model://arm/mesh.stl", 1),
        ("{}/other.stl", 0),  # it does not exist
    ],
)
def test_meshes_in_rviz(tmp_path: Path, path: str, count: int) -> None:
    directory = tmp_path / "arm"
    directory.mkdir()
    (directory / "mesh.stl").write_bytes(bytes(84))
    mesh = f'<geometry><mesh filename="{path.format(directory)}"/></geometry>'
    files = {
        "r.urdf": f'<robot name="r"><link name="a"><visual>{mesh}</visual></link></robot>',
    }
    text = (
        "from launch_ros.actions import Node\n\nnodes = [\n"
        '    Node(package="robot_state_publisher", executable="robot_state_publisher",\n'
        '         parameters=[{"robot_description": open("../r.urdf").read()}]),\n'
        '    Node(package="rviz2", executable="rviz2"),\n]\n'
    )
    found = reported(directory, "LAU024", "a.launch.py", text, files)
    assert ["found by RViz" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(
    ("server", "durability", "count"),
    [("map_server", "Volatile", 1), ("map_server", "Transient Local", 0), ("other", "Volatile", 0)],
)
def test_a_map_in_rviz(tmp_path: Path, server: str, durability: str, count: int) -> None:
    rviz = (
        "Visualization Manager:\n  Displays:\n  - Class: rviz_default_plugins/Map\n"
        f"    Topic: {{Durability Policy: {durability}, Value: /map}}\n"
    )
    text = (
        "from launch_ros.actions import Node\n"
        f"nodes = [Node(package='nav2_map_server', executable='{server}'), Node(package='rviz2', "
        "executable='rviz2', arguments=['-d', get_package_share_directory('arm') + '/a.rviz'])]\n"
    )
    found = reported(tmp_path / "arm", "LAU024", "a.launch.py", text, {"a.rviz": rviz})
    assert sum("RViz misses" in one.message for one in found) == count


OBSTACLES = "obstacles: {{plugin: 'nav2_costmap_2d::ObstacleLayer', {}}}"
SOURCE = "observation_sources: scan, scan: {{topic: /scan, data_type: LaserScan, {}}}"
INFLATION = "inflation: {{plugin: 'nav2_costmap_2d::InflationLayer', inflation_radius: {}}}"
COSTMAP_OF = "local_costmap: {{local_costmap: {{ros__parameters: {{{}}}}}}}\n"
SQUARE = "footprint: '[[0.3, 0.2], [0.3, -0.2], [-0.3, -0.2], [-0.3, 0.2]]'"
MPPI = (
    "controller_server: {{ros__parameters: {{controller_frequency: {}, FollowPath: {{plugin: "
    "'nav2_mppi_controller::MPPIController'{}}}}}}}\n"
)
AMCL = "amcl: {{ros__parameters: {{{}}}}}\n"
EKF = "ekf: {{ros__parameters: {{{}}}}}\n"
FALSE = "[false, false, false]"


def rows(row: int) -> str:
    """A configuration of robot_localization that reads one row."""
    values = ["false"] * 3 * row + ["true"] * 3 + ["false"] * (12 - 3 * row)
    return f"[{', '.join(values[:15])}]"


@pytest.mark.parametrize(
    ("yaml", "words"),
    [
        (MPPI.format("20.0", ", model_dt: 0.02"), "period of 0.05 s"),
        (MPPI.format("20.0", ""), ""),
        (MPPI.format("30.0", ", model_dt: 0.033"), "period of 0.03333 s"),
        (MPPI.format("30.0", ""), ""),
        (MPPI.format("10.0", ""), "period of 0.1 s"),
        ("slam_toolbox: {ros__parameters: {transform_publish_period: 0.0}}\n", "no transform"),
        ("slam_toolbox: {ros__parameters: {mode: localization}}\n", "without a map"),
        ("slam_toolbox: {ros__parameters: {mode: localization, map_file_name: /a}}\n", ""),
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
        (EKF.format(f"frequency: 30, odom0: odom, odom0_config: {rows(2)}"), "frequency is an"),
        (EKF.format(f"odom0: odom, odom0_confg: 1, odom0_config: {rows(2)}"), ""),
        (EKF.format(f"two_d_mod: true, odom0: odom, odom0_config: {rows(2)}"), "'two_d_mode'"),
    ],
)
def test_contradictions(tmp_path: Path, yaml: str, words: str) -> None:
    found = messages(tmp_path, CONTROLLER, '"controller_server"', yaml)
    assert [words in one for one in found] == [True] * bool(words)


@pytest.mark.parametrize(
    ("values", "words"),
    [
        (OBSTACLES.format(SOURCE.format("clearing: false, marking: true")), "are never cleared"),
        (OBSTACLES.format(SOURCE.format("marking: true")), ""),  # the default, if unwanted
        (OBSTACLES.format(SOURCE.format("clearing: true, raytrace_max_range: 2.0")), ""),
        (
            OBSTACLES.format(
                SOURCE.format("clearing: true, obstacle_max_range: 3.0, raytrace_max_range: 2.0")
            ),
            "raytrace_max_range 2 is below obstacle_max_range 3",
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
    found = messages(tmp_path, CONTROLLER, '"controller_server"', COSTMAP_OF.format(values))
    assert [words in one for one in found] == [True] * bool(words)


BOTH = (
    "controller_server: {ros__parameters: {goal_checker_plugin: g, "
    "goal_checker_plugins: [g], g: {plugin: a}}}\n"
)
JAZZY = "behavior_server: {ros__parameters: {spin: {plugin: 'nav2_behaviors::Spin'}}}\n"
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
        (MUX.format("topic: joy, timeout: 1, priority: 1", ", use_stamped: true"), 1, 1),
        (MUX.format("topic: joy, timeout: 1.0", ", use_stamped: true"), 1, 1),
        ("teleop_twist_joy_node: {ros__parameters: {scale_linear: 0.5}}\n", 1, 1),
        ("teleop_twist_joy_node: {ros__parameters: {scale_linear: {x: 0.5}}}\n", 0, 0),
        ("teleop_twist_joy_node: {ros__parameters: {scale_linear: {x: 1}}}\n", 1, 1),
        ("slam_toolbox: {ros__parameters: {max_laser_range: 20}}\n", 1, 1),
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
        found = messages(tmp_path / name, CONTROLLER, '"controller_server"', text)
        assert len(found) == count


VALID = {
    "image": "hall.pgm",
    "resolution": "0.05",
    "origin": "[0.0, 0.0, 0.0]",
    "negate": "0",
    "occupied_thresh": "0.65",
    "free_thresh": "0.25",
}


@pytest.mark.parametrize(
    ("key", "value", "words"),
    [
        ("resolution", "0.05", ""),
        ("resolution", "0.05m", "resolution '0.05m'"),
        ("resolution", "-0.05", "is negative"),
        ("resolution", None, "no resolution"),
        ("origin", "[0.0, 0.0]", "origin has 2 values"),
        ("mode", "trinary", ""),
        ("mode", "trinery", "mean 'trinary'?"),
        ("occupied_thresh", "65", "occupied_thresh is 65, above 1"),
        ("free_thresh", "0.7", "free_thresh 0.7 is above occupied_thresh 0.65"),
        ("negate", None, "no negate"),
    ],
)
def test_maps(tmp_path: Path, key: str, value: str | None, words: str) -> None:
    values = {**VALID, key: value}
    yaml = "".join(f"{name}: {text}\n" for name, text in values.items() if text is not None)
    text = (
        '<node pkg="nav2_map_server" exec="map_server">\n'
        '<param name="yaml_filename" value="$(dirname)/../hall.yaml"/>\n</node>'
    )
    found = reported(tmp_path / "arm", "LAU024", "a.launch.xml", text, {"hall.yaml": yaml})
    assert [words in one.message for one in found] == [True] * bool(words)


MANAGER = (
    "from launch_ros.actions import Node\n\nnodes = [Node(package='nav2_lifecycle_manager', "
    "executable='lifecycle_manager', name='m', parameters=[{{'node_names': ['a']{}}}])]\n"
)


@pytest.mark.parametrize(
    ("more", "count"),
    [("", 1), (", 'autostart': True", 0), (", 'autostart': False", 1), (", 'autostart': x()", 0)],
)
def test_autostart(tmp_path: Path, more: str, count: int) -> None:
    found = reported(tmp_path / "arm", "LAU024", "a.launch.py", MANAGER.format(more))
    assert ["stay unconfigured" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(
    ("yaml", "more", "count"),
    [
        (JAZZY, "", 1),
        ("", "", 0),
        (JAZZY, MANAGER.format(", 'autostart': True").replace("'a'", "'slam_toolbox'"), 0),
        (JAZZY, "\nChangeState\n", 0),
    ],
)
def test_slam_is_activated(tmp_path: Path, yaml: str, more: str, count: int) -> None:
    text = (
        "from launch_ros.actions import Node\n\n"
        "slam = Node(package='slam_toolbox', executable='async_slam_toolbox_node', "
        "name='slam_toolbox')\n"
        "other = Node(package='nav2_behaviors', executable='behavior_server', "
        "parameters=['../a.yaml'])\n"
    )
    files = {"a.yaml": yaml or "a: 1\n"}
    found = reported(tmp_path / "arm", "LAU024", "a.launch.py", text + more, files)
    assert sum("which nothing activates" in one.message for one in found) == count


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
    found = messages(tmp_path, CONTROLLER, '"controller_server"', yaml)
    assert [one.split("'")[1] for one in found if "stamped" in one] == names


@pytest.mark.parametrize(("to", "count"), [("odom", 1), ("/odom", 1), ("odom/filtered", 0)])
def test_a_filter_that_reads_its_output(tmp_path: Path, to: str, count: int) -> None:
    text = (
        '<node pkg="robot_localization" exec="ekf_node" name="ekf">\n'
        '<param from="$(dirname)/../ekf.yaml"/>\n'
        f'<remap from="odometry/filtered" to="{to}"/>\n</node>'
    )
    files = {"ekf.yaml": EKF.format(f"odom0: odom, odom0_config: {rows(2)}")}
    found = reported(tmp_path / "arm", "LAU024", "a.launch.xml", text, files)
    assert ["own output" in one.message for one in found] == [True] * count


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
    found = reported(tmp_path, "LAU024", "a.launch.py", text, files)
    assert ["height of 0.4 m" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(
    ("package", "topic", "count"),
    [
        ("nav2_controller", "/move_base_simple/goal", 1),
        ("nav2_controller", "/goal_pose", 0),
        ("nav2_controller", "/goal", 0),  # of an own program
        ("nav2_controller", "/initialpose", 0),
        ("nav2_controller", "/initial_pose", 1),
        ("other", "/move_base_simple/goal", 0),
    ],
)
def test_goals_of_rviz(tmp_path: Path, package: str, topic: str, count: int) -> None:
    kind = "SetInitialPose" if "initial" in topic else "SetGoal"
    rviz = (
        f"Visualization Manager:\n  Tools:\n  - Class: rviz_default_plugins/{kind}\n"
        f"    Topic: {{Value: {topic}}}\n"
    )
    text = (
        "from launch_ros.actions import Node\n"
        f"nodes = [Node(package='{package}', executable='n'), Node(package='rviz2', "
        "executable='rviz2', arguments=['-d', get_package_share_directory('arm') + '/a.rviz'])]\n"
    )
    found = reported(tmp_path / "arm", "LAU024", "a.launch.py", text, {"a.rviz": rviz})
    assert ["Nav2 does not" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(
    ("given", "count"),
    [
        ("", 1),
        ('<param name="yaml_filename" value="$(var map)"/>', 0),
        ('<param from="$(dirname)/../server.yaml"/>', 0),
        ('<param from="$(dirname)/../other.yaml"/>', 1),
    ],
)
def test_a_server_without_a_map(tmp_path: Path, given: str, count: int) -> None:
    text = f'<node pkg="nav2_map_server" exec="map_server">{given}</node>'
    files = {
        "server.yaml": "map_server: {ros__parameters: {yaml_filename: ''}}\n",
        "other.yaml": "map_server: {ros__parameters: {topic_name: map}}\n",
    }
    found = reported(tmp_path / "arm", "LAU024", "a.launch.xml", text, files)
    assert ["'yaml_filename' is not" in one.message for one in found] == [True] * count


SERVER = "controller_server: {{ros__parameters: {{FollowPath: {{plugin: {}}}}}}}\n"
DWB, PLAIN_MPPI = "'dwb_core::DWBLocalPlanner'", "'nav2_mppi_controller::MPPIController'"
SHIM = "'nav2_rotation_shim_controller::RotationShimController'"
TRIES = "waypoint_follower: {{ros__parameters: {{waypoint_task_executor_plugin: {}}}}}\n"
NAVIGATOR = "bt_navigator: {{ros__parameters: {{default_nav_to_pose_bt_xml: {}}}}}\n"
WATCH = (
    "collision_monitor: {{ros__parameters: {{polygons: [{}], near: {{type: {}}}, "
    "observation_sources: [scan], scan: {{type: scan}}}}}}\n"
)


@pytest.mark.parametrize(
    ("yaml", "words"),
    [
        (SERVER.format(DWB), "DWBLocalPlanner requires critics"),
        (SERVER.format(f"{DWB}, critics: [GoalDist, BaseObstacleCritic]"), ""),
        (SERVER.format(f"{DWB}, critics: [GoalDists]"), "mean 'GoalDist'?"),
        (SERVER.format(f"{DWB}, critics: [Goals], Goals: {{class: a::B}}"), ""),
        (SERVER.format(f"{PLAIN_MPPI}, critics: [ObstacleCritic]"), "mean 'ObstaclesCritic'?"),
        (SERVER.format(f"{PLAIN_MPPI}, critics: [OwnCritic]"), ""),
        (SERVER.format(f"{PLAIN_MPPI}, motion_model: Diff"), "unknown motion_model 'Diff'"),
        (SERVER.format(SHIM), "requires primary_controller"),
        (SERVER.format(f"{SHIM}, primary_controller: a::B"), ""),
        (SERVER.format(f"{SHIM}, primary_controller: {{plugin: a::B}}"), ""),
        (TRIES.format("wait_at_waypoint"), ""),
        (TRIES.format("take_photo"), "parameters for 'take_photo'"),
        (TRIES.format("take_photo, take_photo: {plugin: a::B}"), ""),
        (WATCH.format("near", "circle"), ""),
        (WATCH.format("far", "circle"), "'far' of polygons"),
        (WATCH.format("near", "cirle"), "unknown type 'cirle'"),
        (NAVIGATOR.format("tree.xml"), "find 'tree.xml'"),
        (NAVIGATOR.format("/opt/tree.xml"), ""),
        (NAVIGATOR.format("$(find-pkg-share a)/tree.xml"), ""),
        (NAVIGATOR.format("REPLACED"), ""),
        (AMCL.format("global_frame_id: odom"), "global_frame_id is 'odom'"),
        (AMCL.format("global_frame_id: map, odom_frame_id: odom"), ""),
    ],
)
def test_plugins_of_nav2(tmp_path: Path, yaml: str, words: str) -> None:
    found = messages(tmp_path, CONTROLLER, '"controller_server"', yaml)
    found = [one for one in found if "model_dt" not in one]
    assert [words in one for one in found] == [True] * bool(words)


def test_points_of_a_polygon(tmp_path: Path) -> None:
    yaml = WATCH.format("near", "polygon, points: [0.1, 0.2, -0.1, 0.2]")
    assert messages(tmp_path, CONTROLLER, '"controller_server"', yaml) == []
    (tmp_path / "jazzy").mkdir()
    (found,) = messages(tmp_path / "jazzy", CONTROLLER, '"controller_server"', yaml + JAZZY)
    assert "points is a list" in found


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
MASKS = "{}k: {{plugin: 'nav2_costmap_2d::KeepoutFilter', enabled: {}}}"


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
        (GLOBAL.format(MASKS.format("", "true")), "load 'k'"),
        (GLOBAL.format(MASKS.format("", "false")), ""),
        (GLOBAL.format(MASKS.format("filters: [k], ", "true")), ""),
        (WATCH.format("near", "circle, footprint_topic: /local_costmap/footprint"), "published_"),
        (WATCH.format("near", "circle, footprint_topic: /own/footprint"), ""),
        (
            "behavior_server: {ros__parameters: {local_costmap_topic: local_costmap/costmap}}\n",
            "is not 'costmap_raw'",
        ),
    ],
)
def test_geometry_and_topics_of_a_costmap(tmp_path: Path, yaml: str, words: str) -> None:
    found = messages(tmp_path, CONTROLLER, '"controller_server"', yaml)
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
    found = reported(tmp_path / "arm", "LAU024", "a.launch.py", text, {"a.yaml": yaml})
    assert ["in its namespace" in one.message for one in found] == [True] * bool(severity)
    assert [one.severity.value for one in found] == [severity] * bool(severity)


def test_a_relative_topic_that_another_launch_file_remaps(tmp_path: Path) -> None:
    text = PROGRAM.format(CONTROLLER, '"controller_server"')
    files = {
        "a.yaml": RELATIVE + JAZZY,
        "launch/nav2.launch.py": "SetRemap('/local_costmap/scan', '/scan')\n",
    }
    assert reported(tmp_path / "arm", "LAU024", "a.launch.py", text, files) == []
