"""LAU030: see the rule; planted defects are in tests/bringup/planted.txt."""

from pathlib import Path

import pytest

from tests.checks.bringup.nav2 import CONTROLLER, JAZZY, PARAMETERS, messages
from tests.launched import reported
from urdfkit import check


@pytest.mark.parametrize(
    ("names", "message"),
    [
        ('"controller_server"', ""),
        ('"controller_server", "planner_server"', "waits for planner_server"),
        ('"planner_server"', ""),  # whose nodes another file starts
        ("", ""),
        ('"controller_server", "robot_0/controller_server"', ""),
    ],
)
def test_lifecycle_managers(tmp_path: Path, names: str, message: str) -> None:
    found = messages("LAU030", tmp_path, PARAMETERS.format("controller_server"), CONTROLLER, names)
    assert [message in one for one in found] == [True] * bool(message)


MANAGER = (
    "from launch_ros.actions import Node\n\nnodes = [Node(package='nav2_lifecycle_manager', "
    "executable='lifecycle_manager', name='m', parameters=[{{'node_names': ['a']{}}}])]\n"
)


@pytest.mark.parametrize(
    ("more", "count"),
    [
        ("", 1),
        (", 'autostart': True", 0),
        (", 'autostart': False", 1),
        (", 'autostart': x()", 0),
        (", 'autostart': False}, {'service': '/m/manage_nodes'", 0),
    ],
)
def test_autostart(tmp_path: Path, more: str, count: int) -> None:
    found = reported(tmp_path / "arm", "LAU030", "a.launch.py", MANAGER.format(more))
    assert ["stay unconfigured" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(
    ("program", "count"),
    [("client = '/m/manage_nodes'", 0), ("Client('m', node)", 0), ("'/n/manage_nodes'", 1)],
)
def test_a_program_that_starts_the_nodes(tmp_path: Path, program: str, count: int) -> None:
    """ROS2_WS of Jane-0221: Nav2 is activated when the map is there."""
    text, files = MANAGER.format(", 'autostart': False"), {"scripts/gate.py": program}
    found = reported(tmp_path / "arm", "LAU030", "a.launch.py", text, files)
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
    found = reported(tmp_path / "arm", "LAU030", "a.launch.py", text + more, files)
    assert sum("which nothing activates" in one.message for one in found) == count


def test_a_costmap_is_no_node_of_its_own(tmp_path: Path) -> None:
    """Reported in an included launch file, too."""
    text = MANAGER.format(", 'autostart': True").replace("'a'", "'amcl', 'local_costmap'")
    text += "amcl = Node(package='nav2_amcl', executable='amcl', name='amcl')\n"
    whole = (
        "from ament_index_python.packages import get_package_share_directory\n"
        "from launch.actions import IncludeLaunchDescription\n"
        "whole = IncludeLaunchDescription("
        "get_package_share_directory('arm') + '/launch/a.launch.py')\n"
    )
    files = {"launch/b.launch.py": whole}
    found = reported(tmp_path / "arm", "LAU030", "a.launch.py", text, files)
    assert ["waits for local_costmap" in one.message for one in found] == [True]


ALONE = "from launch_ros.actions import Node\n\nnodes = [Node({})]\n"
MAP_SERVER = "package='nav2_map_server', executable='map_server'"


@pytest.mark.parametrize(
    ("node", "more", "count"),
    [
        (MAP_SERVER, "", 1),
        (MAP_SERVER + ", parameters=[{'autostart_node': True}]", "", 0),
        (MAP_SERVER, MANAGER.format(", 'autostart': True"), 0),
        (MAP_SERVER, "own = Node(package='own', executable='own')\n", 0),
        (MAP_SERVER, "ChangeState\n", 0),
        ("package='rviz2', executable='rviz2'", "", 0),
    ],
)
def test_without_a_manager(tmp_path: Path, node: str, more: str, count: int) -> None:
    text = ALONE.format(node) + more.removeprefix("from launch_ros.actions import Node\n")
    found = reported(tmp_path / "arm", "LAU030", "a.launch.py", text)
    assert sum("no launch file of the workspace" in one.message for one in found) == count


@pytest.mark.parametrize(("package", "count"), [("robot_localization", 1), ("mine", 0)])
def test_a_node_that_is_not_a_lifecycle_node(tmp_path: Path, package: str, count: int) -> None:
    text = MANAGER.format(", 'autostart': True").replace("'a'", "'ekf'")
    text += f"ekf = Node(package='{package}', executable='ekf_node', name='ekf')\n"
    found = reported(tmp_path / "arm", "LAU030", "a.launch.py", text)
    assert ["waits for 'ekf' for ever" in one.message for one in found] == [True] * count


SERVERS = """launch:
- arg: {{name: place, default: depot}}
- node: {{pkg: nav2_amcl, exec: amcl, name: amcl{}}}
- node: {{pkg: nav2_map_server, exec: map_server, name: map_server}}
- node:
    if: $(eval "'$(var place)' == 'yard'")
    pkg: robot_localization
    exec: ekf_node
- node:
    pkg: nav2_lifecycle_manager
    exec: lifecycle_manager
    param:
    - {{name: autostart, value: true}}
    - {{name: node_names, value: [{}]}}
"""


@pytest.mark.parametrize(
    ("condition", "names", "count"),
    [
        ("", "map_server, amcl", 0),
        ("", "map_server", 1),
        (", if: $(var unknown)", "map_server", 0),
    ],
)
def test_next_to_what_only_another_choice_starts(
    tmp_path: Path, condition: str, names: str, count: int
) -> None:
    text = SERVERS.format(condition, names)
    (tmp_path / "arm" / "launch").mkdir(parents=True)
    (tmp_path / "arm" / "package.xml").write_text("<package><name>arm</name></package>")
    file = tmp_path / "arm" / "launch" / "a.launch.yaml"
    file.write_text(text)
    found = check(file, select=["LAU030"]).diagnostics
    assert ["'amcl' stays unconfigured" in one.message for one in found] == [True] * count
