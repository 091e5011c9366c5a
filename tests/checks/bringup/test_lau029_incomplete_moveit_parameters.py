"""LAU029: see the rule; planted defects are in tests/bringup/planted.txt."""

from pathlib import Path

import pytest

from tests.checks.bringup.nav2 import messages
from tests.launched import reported


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
    found = messages("LAU029", tmp_path, "", node, "")
    assert ["is not in planning_pipelines" in one for one in found] == [True] * count


MOVE_GROUP = 'Node(package="moveit_ros_move_group", executable="move_group", parameters=[x])\n'
SERVO = 'Node(package="moveit_servo", executable="servo_node", parameters=[{}])\n'
LOADED = '{"moveit_servo": ParameterBuilder("arm").yaml("config/servo.yaml").to_dict()}'


@pytest.mark.parametrize(
    ("nodes", "primary", "count"),
    [
        (MOVE_GROUP + SERVO.format('"../config/servo.yaml"'), "true", 1),
        (MOVE_GROUP + SERVO.format(LOADED), "true", 1),
        (MOVE_GROUP + SERVO.format(LOADED), "false", 0),
        (SERVO.format(LOADED), "true", 0),
    ],
)
def test_the_planning_scene_of_servo(tmp_path: Path, nodes: str, primary: str, count: int) -> None:
    """From husarion/rosbot_ros#193."""
    files = {
        "config/servo.yaml": "servo: {ros__parameters: {move_group_name: arm, "
        f"is_primary_planning_scene_monitor: {primary}}}}}\n",
    }
    found = reported(tmp_path / "arm", "LAU029", "a.launch.py", nodes, files)
    assert [one.span.text for one in found] == ["true"] * count


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
    found = reported(tmp_path / "arm", "LAU029", "a.launch.py", BUILDER, files)
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
    found = reported(tmp_path / "arm", "LAU029", "a.launch.py", BUILDER, files)
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


@pytest.mark.parametrize("end", ["\n", "\r\n"])
@pytest.mark.parametrize(("file", "count"), [("b.srdf", 0), ("arm.srdf", 1)])
def test_the_srdf_that_the_setup_assistant_names(
    tmp_path: Path, file: str, count: int, end: str
) -> None:
    setup = "moveit_setup_assistant_config:\n  srdf:\n    relative_path: config/b.srdf\n"
    setup = setup.replace("\n", end)
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
    found = reported(tmp_path / "arm", "LAU029", "a.launch.py", text, files)
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
    found = reported(tmp_path / "arm", "LAU029", "a.launch.py", text, files)
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
        ("{}", '{"use_sim_time": True}', "no robot_description_semantic"),
        ("{}", "{}", "no robot_description_semantic"),
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
    found = reported(tmp_path / "arm", "LAU029", "a.launch.py", text, files)
    assert [words in finding.message for finding in found] == [True] * bool(words)
    # MoveIt of Humble reads solvers at the top level, too: so does franka_ros2 pass them.
    severity = "info" if "kinematics" in words else "warning"
    assert {finding.severity.value for finding in found} <= {severity}


@pytest.mark.parametrize(
    ("more", "missing"),
    [
        ("", ["robot_description_kinematics", "robot_description_planning"]),
        (', "robot_description_kinematics": z', ["robot_description_planning"]),
        (', "robot_description_kinematics": z, "robot_description_planning": z', []),
        (', "a": {"kinematics_solver": z}', ["robot_description_planning"]),
        (", x: y", []),
    ],
)
def test_files_that_move_group_does_not_get(tmp_path: Path, more: str, missing: list[str]) -> None:
    semantic = '{"robot_description": x, "robot_description_semantic": y'
    text = HANDED.replace("[{}", f"[{semantic}{more}}}")
    text += 'Node(package="rviz2", executable="rviz2", parameters=["kinematics.yaml"])\n'
    text += "# joint_limits.yaml\n"
    found = reported(tmp_path / "arm", "LAU029", "a.launch.py", text)
    words = [one.message.split()[3].rstrip(":") for one in found if "gets no" in one.message]
    assert words == missing


@pytest.mark.parametrize(
    ("parameters", "count"),
    [
        ('{"arm_servo": {"move_group_name": "arm"}}', 1),
        ('{"move_group_name": "arm"}', 1),
        ('{"moveit_servo": {"move_group_name": "arm"}}', 0),
        ('{"moveit_servo": x}, y', 0),
        ('{"robot_description": x}', 0),
        ('{"arm_servo": x}', 1),
        ('{"arm_servo": x}, config.robot_description', 1),
        ('{"arm_servo": x}, config.own()', 0),
        ('{"arm": x}', 0),
    ],
)
def test_the_namespace_of_servo(tmp_path: Path, parameters: str, count: int) -> None:
    text = 'from launch_ros.actions import Node\nNode(package="moveit_servo", '
    text += f'executable="servo_node", parameters=[{parameters}])\n'
    found = reported(tmp_path / "arm", "LAU029", "a.launch.py", text)
    assert ["Servo reads its" in one.message for one in found] == [True] * count
