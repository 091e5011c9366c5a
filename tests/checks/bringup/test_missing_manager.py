"""LAU022: controllers of a robot in Gazebo that has no control plugin."""

from pathlib import Path

import pytest

from tests.checks.bringup.nodes import NODE, SPAWNER, STATE
from tests.jointed import joint, robot
from tests.launched import reported

CREATE = NODE.format("ros_gz_sim", "create", "arguments=[{}]")
ON_TOPIC = CREATE.format("'-topic', 'robot_description'")
HARDWARE = "<ros2_control name='c' type='system'><hardware><plugin>{}</plugin></hardware>"
MOCK = HARDWARE.format("mock_components/GenericSystem")
PLUGIN = "<gazebo><plugin filename='{}' name='p'/></gazebo>"
#: Programs of the workspace.
PROGRAMS = {
    "stow": "publisher = create_publisher(JointTrajectory, 'trajectory')",
    "runner": "run(['ros2', 'run', 'controller_manager', 'ros2_control_node'])",
}
OPTIONAL = "condition=IfCondition(LaunchConfiguration('x'))"
NAVIGATION = NODE.format("nav2_amcl", "amcl", OPTIONAL)


@pytest.mark.parametrize(
    ("more", "programs", "count"),
    [
        ("", ON_TOPIC, 1),
        (f"{MOCK}</ros2_control>", ON_TOPIC, 1),
        (PLUGIN.format("gz-sim-joint-state-publisher-system"), ON_TOPIC, 1),
        (PLUGIN.format("gz_ros2_control-system"), ON_TOPIC, 0),
        (PLUGIN.format("libown_plugin.so"), ON_TOPIC, 0),  # may start one
        (f"{HARDWARE.format('gz_ros2_control/GazeboSimSystem')}</ros2_control>", ON_TOPIC, 0),
        ("", "", 0),  # the real robot
        ("", CREATE.format("'-file', 'own.sdf'"), 0),
        ("", ON_TOPIC + ON_TOPIC, 0),
        ("", ON_TOPIC + NODE.format("controller_manager", "ros2_control_node", ""), 0),
        ("", ON_TOPIC + NODE.format("own_control", "own_manager", ""), 0),
        ("", ON_TOPIC + NODE.format("stow", "stow", ""), 1),
        ("", ON_TOPIC + NODE.format("stow", "stow", OPTIONAL), 1),
        ("", ON_TOPIC + NODE.format("runner", "runner", ""), 0),
        ("", ON_TOPIC + NODE.format("runner", "runner", OPTIONAL), 0),
        ("", ON_TOPIC + NODE.format("unknown", "unknown", OPTIONAL), 0),
        ("", ON_TOPIC + "IncludeLaunchDescription(x)\n", 0),
        ("", ON_TOPIC + NAVIGATION, 1),
    ],
)
def test_a_robot_without_a_control_plugin(
    tmp_path: Path, more: str, programs: str, count: int
) -> None:
    """A launch file that forgets the argument of xacro which adds the plugin, sim:=true."""
    text = (
        f"robot = open('{tmp_path}/arm/r.urdf').read()\n"
        + STATE.format(", parameters=[{'robot_description': robot}]")
        + SPAWNER.format(["arm"])
        + programs
    )
    files = {"r.urdf": f"<robot name='r'>{robot(joint('swing', 'continuous'))}{more}</robot>"}
    for name, program in PROGRAMS.items():
        files[f"../{name}/package.xml"] = f"<package format='3'><name>{name}</name></package>"
        files[f"../{name}/{name}/{name}.py"] = program
    found = reported(tmp_path / "arm", "LAU022", "a.launch.py", text, files)
    waiting = [one for one in found if "no control plugin" in one.message]
    assert [(one.span.line, one.related[0].span.line) for one in waiting] == [(1, 3)] * count


@pytest.mark.parametrize(
    ("topic", "more", "count"),
    [
        ("/bot/robot_description", NAVIGATION, 1),
        ("/robot_description", NAVIGATION, 0),
        ("/bot/robot_description", NODE.format("unknown", "unknown", OPTIONAL), 0),
        ("/bot/robot_description", NODE.format("moveit_ros_move_group", "m", OPTIONAL), 1),
        (
            "/bot/robot_description",
            NODE.format(
                "moveit_ros_move_group",
                "m",
                f"{OPTIONAL}, parameters=[{{'publish_robot_description': True}}]",
            ),
            0,
        ),
    ],
)
def test_a_model_of_rviz_next_to_optional_programs(
    tmp_path: Path, topic: str, more: str, count: int
) -> None:
    rviz = f"""Visualization Manager:
  Displays:
    - Class: rviz_default_plugins/RobotModel
      Description Topic:
        Value: {topic}
"""
    text = (
        STATE.format(", parameters=[{'robot_description': '<robot/>'}]")
        + NODE.format("rviz2", "rviz2", "arguments=['-d', '../a.rviz']")
        + more
    )
    found = reported(tmp_path, "LAU022", "a.launch.py", text, {"a.rviz": rviz})
    assert ["RobotModel" in one.message for one in found] == [True] * count
