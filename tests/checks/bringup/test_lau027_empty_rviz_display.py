"""LAU027: see the rule; planted defects are in tests/bringup/planted.txt."""

from pathlib import Path

import pytest

from tests.launched import reported


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
    found = reported(directory, "LAU027", "a.launch.py", text, files)
    assert ["found by RViz" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(
    ("server", "durability", "more", "count"),
    [
        ("map_server", "Volatile", "", 1),
        ("map_server", "Volatile", ", namespace='hall'", 0),  # RViz shows another map
        ("map_server", "Volatile", ", remappings=[('map', 'hall')]", 0),
        ("map_server", "Transient Local", "", 0),
        ("other", "Volatile", "", 0),
    ],
)
def test_a_map_in_rviz(tmp_path: Path, server: str, durability: str, more: str, count: int) -> None:
    rviz = (
        "Visualization Manager:\n  Displays:\n  - Class: rviz_default_plugins/Map\n"
        f"    Topic: {{Durability Policy: {durability}, Value: /map}}\n"
    )
    text = (
        "from launch_ros.actions import Node\n"
        f"nodes = [Node(package='nav2_map_server', executable='{server}'{more}), "
        "Node(package='rviz2', "
        "executable='rviz2', arguments=['-d', get_package_share_directory('arm') + '/a.rviz'])]\n"
    )
    found = reported(tmp_path / "arm", "LAU027", "a.launch.py", text, {"a.rviz": rviz})
    assert sum("RViz misses" in one.message for one in found) == count


@pytest.mark.parametrize(
    ("name", "count"),
    [("localization_launch.py", 1), ("bringup_launch.py", 1), ("navigation_launch.py", 0)],
)
def test_the_map_server_of_nav2(tmp_path: Path, name: str, count: int) -> None:
    rviz = (
        "Visualization Manager:\n  Displays:\n  - Class: rviz_default_plugins/Map\n"
        "    Topic: {Durability Policy: Volatile, Value: /map}\n"
    )
    text = (
        "from launch_ros.actions import Node\n"
        "included = IncludeLaunchDescription(PythonLaunchDescriptionSource("
        f"[FindPackageShare('nav2_bringup'), '/launch/{name}']))\n"
        "node = Node(package='rviz2', executable='rviz2', arguments=['-d', '../a.rviz'])\n"
    )
    found = reported(tmp_path / "arm", "LAU027", "a.launch.py", text, {"a.rviz": rviz})
    assert [one.help for one in found] == ["write Transient Local"] * count


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
    found = reported(tmp_path / "arm", "LAU027", "a.launch.py", text, {"a.rviz": rviz})
    assert ["Nav2 does not" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        ("Visualization Manager:\n  Displays: []\n", []),
        ("Visualization Manager:\n  Tools:\n    - Class: a\n   - Class: b\n", [4]),
        ("Tree: " + "{a: " * 60 + "b" + "}" * 60 + "\n", []),  # of the frames of a humanoid
        ("<!-- a: b -->\nVisualization Manager:\n  Displays: c: d\n", [3]),
        ("", []),
    ],
)
def test_a_configuration_that_is_not_yaml(tmp_path: Path, text: str, lines: list[int]) -> None:
    """1999AZZAR/Autonomous_Mobile_Manipulator: another indentation in a list of tools."""
    launch = '<node pkg="rviz2" exec="rviz2" args="-d $(dirname)/../a.rviz"/>'
    found = reported(tmp_path / "arm", "LAU027", "a.launch.xml", launch, {"a.rviz": text})
    assert [one.span.line for one in found] == lines
