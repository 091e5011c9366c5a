"""LAU003: see the rule."""

from pathlib import Path

import pytest

from tests.launched import reported
from tests.naming import naming
from urdfkit import Severity, check
from urdfkit.text.source import Source


def test_suggested_file(tmp_path):
    (tmp_path / "robot.yaml").write_text("a: 1")
    text = b'<launch><rosparam file="$(dirname)/robt.yaml"/></launch>'
    (finding,) = check(Source(str(tmp_path / "a.launch"), text)).diagnostics
    assert finding.code == "LAU003"
    assert "robt.yaml" in finding.message
    assert "'robot.yaml'" in finding.help


@pytest.mark.parametrize(
    ("name", "count"),
    [
        ("orchrad.yaml", 1),
        ("orchard.yaml", 0),
        ("orchard2.yaml", 0),  # which somebody will record
        ("orchrad.pgm", 0),
        ("garden.yaml", 0),
    ],
)
def test_an_argument_that_names_a_file_with_a_typo(tmp_path: Path, name: str, count: int) -> None:
    text = f'<arg name="map" default="$(find arm)/maps/{name}"/>'
    found = reported(tmp_path, "LAU003", "a.launch", text, {"maps/orchard.yaml": "a: 1"})
    assert [one.help for one in found] == ["did you mean 'orchard.yaml'?"] * count


def test_a_file_with_a_typo_is_reported_once(tmp_path: Path) -> None:
    text = '<rosparam file="$(find arm)/config/contrl.yaml"/>'
    (found,) = reported(tmp_path, "LAU003", "a.launch", text, {"config/control.yaml": "a: 1"})
    assert found.message.startswith("parameter file not found")


def test_directories_and_other_suffixes_are_not_suggested(tmp_path):
    (tmp_path / "robot").mkdir()
    (tmp_path / "robot.launch").write_text("<launch/>")
    text = b'<launch><rosparam file="$(dirname)/robot.yaml"/></launch>'
    (finding,) = check(Source(str(tmp_path / "a.launch"), text)).diagnostics
    assert finding.help.startswith("create the file")


def test_a_slash_that_is_missing_after_a_package(tmp_path: Path) -> None:
    (tmp_path / ".git").mkdir()
    text = '<rosparam file="$(find arm)config/a.yaml"/>'
    (found,) = reported(tmp_path / "arm", "LAU003", "a.launch", text, {"config/a.yaml": "a: 1"})
    assert found.help == "write a slash after arm"
    (found,) = reported(tmp_path / "arm", "LAU003", "a.launch", text.replace("/a", "/b"))
    assert found.help == "create the file, or fix its name"


def test_existing_file_is_accepted(tmp_path):
    (tmp_path / "robot.yaml").write_text("a: 1")
    text = b'<launch><rosparam file="$(dirname)/robot.yaml"/></launch>'
    assert check(Source(str(tmp_path / "a.launch"), text)).diagnostics == ()


@pytest.mark.parametrize(
    "cmake",
    [
        "add_subdirectory(doc)",
        "configure_file(a.in a)",
        "file(GENERATE OUTPUT a CONTENT b)",
        "execute_process(COMMAND gunzip -k config/made.yaml.gz)",
    ],
)
def test_generated_file_is_accepted(tmp_path: Path, cmake: str) -> None:
    files = {"CMakeLists.txt": cmake}
    text = '<rosparam file="$(find arm)/config/made.yaml"/>'
    assert reported(tmp_path, "LAU003", "a.launch", text, files) == []
    assert len(reported(tmp_path, "LAU003", "a.launch", text, {"CMakeLists.txt": ""})) == 1


def test_path_that_depends_on_an_argument_is_accepted(tmp_path: Path) -> None:
    text = '<arg name="arm" default=""/><rosparam file="$(find arm)/$(arg arm).yaml"/>'
    assert reported(tmp_path, "LAU003", "a.launch", text) == []


GZ = """from launch_ros.substitutions import FindPackageShare
IncludeLaunchDescription(
    PythonLaunchDescriptionSource([FindPackageShare("ros_gz_sim"), "/launch/gz_sim.launch.py"]),
    launch_arguments={"gz_args": ["-r ", WORLD]}.items(),
)
"""
COMMAND = 'ExecuteProcess(cmd=["gazebo", WORLD])'
CLASSIC = """<include file="$(find gazebo_ros)/launch/empty_world.launch">
<arg name="world_name" value="WORLD"/></include>"""


@pytest.mark.parametrize(
    ("name", "text", "world"),
    [
        ("a.launch.py", GZ, 'FindPackageShare("arm"), "/worlds/hal.sdf"'),
        ("a.launch", CLASSIC, "$(find arm)/worlds/hal.sdf"),
        ("b.launch.py", COMMAND, 'FindPackageShare("arm") / "worlds/hal.sdf"'),
    ],
)
def test_missing_world(tmp_path: Path, name: str, text: str, world: str) -> None:
    files = {"worlds/hall.sdf": "<sdf/>"}
    (found,) = reported(tmp_path, "LAU003", name, text.replace("WORLD", world), files)
    assert found.message == f"world not found: {tmp_path}/worlds/hal.sdf"
    assert "hall.sdf" in found.help
    there = text.replace("WORLD", world.replace("hal.", "hall."))
    assert reported(tmp_path, "LAU003", name, there) == []


def test_a_misspelt_world_of_gazebo(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, "LAU003", "a.launch.py", GZ.replace("WORLD", '"emtpy.sdf"'))
    assert (found.message, found.help) == (
        naming("Gazebo", "emtpy.sdf"),
        naming("empty.sdf"),
    )
    for right in ("empty.sdf", "my.sdf"):
        assert reported(tmp_path, "LAU003", "a.launch.py", GZ.replace("WORLD", f'"{right}"')) == []
    own = {"worlds/emtpy.sdf": "<sdf/>"}
    text = GZ.replace("WORLD", '"emtpy.sdf"')
    assert reported(tmp_path, "LAU003", "b.launch.py", text, own) == []


@pytest.mark.parametrize(
    ("flags", "glued"),
    [
        ("-r ", ""),
        ("-r", "-r"),
        ("-r -v4", "-v4"),
        ("-r -v 4", "4"),
        ("-r --verbose 3", "3"),
        ("-r --headless-rendering", "--headless-rendering"),
        ("-r -v 4 ", ""),
        ("-r --gui-config ", ""),
        ("-r --record-path=", ""),
    ],
)
def test_flags_without_a_space(tmp_path: Path, flags: str, glued: str) -> None:
    world = 'FindPackageShare("arm"), "/worlds/hall.sdf"'
    text = GZ.replace('"-r ", WORLD', f'"{flags}", {world}')
    files = {"worlds/hall.sdf": "<sdf version='1.9'><world name='hall'/></sdf>"}
    found = reported(tmp_path / "arm", "LAU003", "a.launch.py", text, files)
    assert [one.help for one in found] == [f"write '{glued} ' with a space"] * bool(glued)


def test_a_world_outside_of_the_workspace_is_not_read(tmp_path: Path) -> None:
    world = tmp_path / "other" / "hall.sdf"
    world.parent.mkdir()
    world.write_text("<sdf/>")
    launch = tmp_path / "robot" / "robot.launch"
    launch.parent.mkdir()
    (launch.parent / ".git").mkdir()
    launch.write_text(f'<launch><executable cmd="gz sim -r {world}"/></launch>')
    (found,) = check(launch, select=["LAU003", "WLD"]).diagnostics
    assert found.code == "LAU003"
    assert "outside the workspace" in found.message


@pytest.mark.parametrize(
    ("image", "help"),
    [("hall.pgm", None), ("hall.png", "write hall.pgm"), ("other.png", "create the file")],
)
def test_the_image_of_a_map(tmp_path: Path, image: str, help: str | None) -> None:
    program = (
        "from launch_ros.actions import Node\n"
        "Node(package='nav2_map_server', executable='map_server', "
        f"parameters=[{{'yaml_filename': '{tmp_path}/arm/maps/hall.yaml'}}])\n"
    )
    files = {"maps/hall.yaml": f"image: {image}\nresolution: 0.05\n", "maps/hall.pgm": "P2"}
    found = reported(tmp_path / "arm", "LAU003", "a.launch.py", program, files)
    assert [one.help.startswith(help or "") for one in found] == [True] * bool(help)


@pytest.mark.parametrize(("name", "count"), [("bridge", 0), ("bridges", 1)])
def test_missing_file_of_a_bridge(tmp_path: Path, name: str, count: int) -> None:
    path = tmp_path / "config" / f"{name}.yaml"
    program = (
        "from launch_ros.actions import Node\n"
        "Node(package='ros_gz_bridge', executable='parameter_bridge', "
        f"arguments=['--ros-args', '-p', 'config_file:={path}'])\n"
    )
    files = {"config/bridge.yaml": "[]\n"}
    found = reported(tmp_path, "LAU003", "a.launch.py", program, files)
    assert [one.help for one in found] == ["did you mean 'bridge.yaml'?"] * count


@pytest.mark.parametrize(
    ("node", "message"),
    [
        ('pkg="amcl" type="amlc"', naming("amcl", "amlc", "amcl")),
        ('pkg="robot_localization" type="ekf_node"', naming("robot_localization", "ekf_node")),
        ('pkg="robot_localization" type="ekf_localization_node"', ""),
        ('pkg="gazebo_ros" type="$(arg type)"', ""),
        ('pkg="a_driver" type="amlc"', ""),
    ],
)
def test_executables_of_ros_1(tmp_path: Path, node: str, message: str) -> None:
    found = reported(tmp_path, "LAU003", "a.launch", f'<node name="n" {node}/>')
    assert [one.message for one in found] == [message] * bool(message)


@pytest.mark.parametrize(("type", "count"), [("state_publisher", 1), ("robot_state_publisher", 0)])
def test_former_executable_of_ros_1(tmp_path: Path, type: str, count: int) -> None:
    text = f'<node name="tf" pkg="robot_state_publisher" type="{type}"/>'
    findings = reported(tmp_path, "LAU003", "a.launch", text)
    assert [(finding.severity, finding.help) for finding in findings] == [
        (Severity.INFO, 'write type="robot_state_publisher"')
    ] * count


@pytest.mark.parametrize(
    ("name", "value", "help"),
    [
        ("yaml_filename", "hall.yaml", None),
        ("yaml_filename", "hal.yaml", naming("hall.yaml")),
        ("yaml_filename", "hall.pgm", naming("hall.yaml")),
        ("map_file_name", "graph", None),
        ("map_file_name", "graph.posegraph", naming("graph", "suffix")),
        ("map_file_name", "hall.yaml", naming("hall", "suffix")),
        ("map_file_name", "grahp", naming("graph.posegraph")),
        ("default_nav_to_pose_bt_xml", "tre.xml", naming("tree.xml")),
    ],
)
def test_files_in_parameters(tmp_path: Path, name: str, value: str, help: str | None) -> None:
    text = f'<node pkg="p" exec="e"><param name="{name}" value="$(dirname)/../{value}"/></node>'
    files = {"hall.yaml": "image: hall.pgm\n", "hall.pgm": "P2", "graph.posegraph": "x"}
    files["tree.xml"] = "<root/>"
    found = reported(tmp_path, "LAU003", "a.launch.xml", text, files)
    assert [one.help for one in found] == ([] if help is None else [help])


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("slam_toolbox: {ros__parameters: {map_file_name: /home/me/hall.posegraph}}\n", 1),
        ("slam_toolbox: {ros__parameters: {map_file_name: /home/me/hall}}\n", 0),
        ("map_server: {ros__parameters: {yaml_filename: /home/me/hall.png}}\n", 1),
        ("map_server: {ros__parameters: {yaml_filename: /home/me/hall.yaml}}\n", 0),
    ],
)
def test_maps_in_a_parameter_file(tmp_path: Path, text: str, count: int) -> None:
    program = "Node(package='p', executable='e', parameters=['../a.yaml'])\n"
    found = reported(tmp_path, "LAU003", "a.launch.py", program, {"a.yaml": text})
    assert [one.span.source.path.endswith("a.yaml") for one in found] == [True] * count


@pytest.mark.parametrize(
    ("node", "message"),
    [
        ('pkg="arm" exec="listener"', naming("CMakeLists.txt", "arm", "listener")),
        ('pkg="arm" exec="talker"', ""),
        ('pkg="tf" exec="static_transform_publisher"', naming("ROS 2", "tf")),
        ('pkg="tf2_ros" exec="static_transform_publisher"', ""),
        ('pkg="controller_manager" exec="controller_manager"', naming(*["controller_manager"] * 2)),
    ],
)
def test_executables_of_nodes(tmp_path: Path, node: str, message: str) -> None:
    files = {
        "CMakeLists.txt": "project(arm)\nfind_package(ament_cmake REQUIRED)\n"
        "add_executable(talker a.cpp)\ninstall(TARGETS talker DESTINATION lib/arm)\n",
    }
    directory = tmp_path / "arm"
    directory.mkdir()
    text = f"<node {node}/>"
    reported(directory, "LAU003", "a.launch.xml", text, files)
    manifest = directory / "package.xml"
    kind = "<export><build_type>ament_cmake</build_type></export></package>"
    manifest.write_text(manifest.read_text().replace("</package>", kind))
    found = check(directory / "launch" / "a.launch.xml", select=["LAU003"]).diagnostics
    assert [one.message for one in found] == ([message] if message else [])


@pytest.mark.parametrize(
    ("program", "purpose", "path"),
    [
        (
            "Node(package='p', executable='e', parameters=['config/a.yaml'])",
            "parameter file",
            "config/a.yaml",
        ),
        (
            "Node(package='rviz2', executable='rviz2', arguments=['-d', 'a.rviz'])",
            "RViz configuration",
            "a.rviz",
        ),
        (
            "IncludeLaunchDescription(AnyLaunchDescriptionSource('launch/b.launch.py'))",
            "launch file",
            "launch/b.launch.py",
        ),
        ("Node(package='p', executable='e', parameters=['../a.yaml'])", "", ""),  # it is there
        ("Node(package='p', executable='e', parameters=[LaunchConfiguration('a')])", "", ""),
    ],
)
def test_paths_relative_to_the_working_directory(
    tmp_path: Path, program: str, purpose: str, path: str
) -> None:
    found = reported(tmp_path, "LAU003", "a.launch.py", f"{program}\n", {"a.yaml": "a: 1"})
    help = f'write os.path.join(get_package_share_directory("arm"), "{path}")'
    assert [one.help for one in found] == ([help] if path else [])
    assert all(one.message.startswith(f"{purpose} '{path}' ") for one in found)


@pytest.mark.parametrize(("name", "count"), [("c.yaml", 0), ("d.yaml", 1)])
def test_the_parameter_file_of_a_spawner(tmp_path: Path, name: str, count: int) -> None:
    node = f"""<node pkg="controller_manager" exec="spawner"
        args="arm --param-file $(dirname)/../{name}"/>"""
    found = reported(tmp_path, "LAU003", "a.launch.xml", node, {"c.yaml": "a: 1"})
    assert len(found) == count


@pytest.mark.parametrize(
    ("planners", "severity"),
    [
        ("planning_plugin: ompl_interface/OMPLPlanner", Severity.INFO),
        ("planning_plugins: [ompl_interface/OMPLPlanner]", Severity.WARNING),
    ],
)
def test_an_executable_of_an_earlier_release(
    tmp_path: Path, planners: str, severity: Severity
) -> None:
    text = '<node pkg="moveit_servo" exec="servo_node_main"/><let name="a" value="b"/>'
    files = {"config/ompl_planning.yaml": planners + "\n"}
    (found,) = reported(tmp_path / "arm", "LAU003", "a.launch.xml", text, files)
    assert (found.severity, "supported up to Humble" in found.message) == (severity, True)
    text = text.replace("_main", "")
    assert reported(tmp_path / "arm", "LAU003", "a.launch.xml", text) == []


@pytest.mark.parametrize(("first", "count"), [("#!/usr/bin/env python3", 0), ("import rclpy", 1)])
def test_a_script_that_the_system_cannot_start(tmp_path: Path, first: str, count: int) -> None:
    directory = tmp_path / "arm"
    install = "install(PROGRAMS scripts/talk.py DESTINATION lib/${PROJECT_NAME})\n"
    build = f"project(arm)\nfind_package(ament_cmake REQUIRED)\n{install}"
    files = {"CMakeLists.txt": build, "scripts/talk.py": f"{first}\n"}
    reported(directory, "LAU003", "a.launch.xml", '<node pkg="arm" exec="talk.py"/>', files)
    manifest = directory / "package.xml"
    kind = "<export><build_type>ament_cmake</build_type></export></package>"
    manifest.write_text(manifest.read_text().replace("</package>", kind))
    found = check(directory / "launch" / "a.launch.xml", select=["LAU003"]).diagnostics
    assert [one.help.partition(" ")[2][:2] for one in found] == ["#!"] * count


@pytest.mark.parametrize(("name", "count"), [("planning_plugins", 1), ("planning_plugin", 0)])
def test_a_package_that_jazzy_does_not_have(tmp_path: Path, name: str, count: int) -> None:
    text = '<node pkg="ros_ign_gazebo" exec="create"/><let name="a" value="b"/>'
    files = {"config/ompl_planning.yaml": f"{name}: a\n"}
    found = reported(tmp_path / "arm", "LAU003", "a.launch.xml", text, files)
    assert [one.help for one in found] == ["write ros_gz_sim"] * count


LOADING = """
import yaml
def load_yaml(package, path):
    with open(os.path.join(get_package_share_directory(package), path)) as file:
        return yaml.safe_load(file)
"""


@pytest.mark.parametrize(
    ("call", "message"),
    [
        ("load_yaml('arm', 'config/b.yaml')", "config/b.yaml"),
        ("load_yaml('arm', 'config/a.yaml')", ""),
        ("load_yaml('arm', name)", ""),
        ("load_yaml('arm', path='config/b.yaml')", ""),
        ("load_other('arm', 'config/b.yaml')", ""),
        ("ParameterBuilder('arm').parameter('a', 1).yaml('config/b.yaml')", "config/b.yaml"),
        ("ParameterBuilder('arm').yaml(file_path='config/a.yaml').to_dict()", ""),
        ("other('arm').yaml('config/b.yaml')", ""),
    ],
)
def test_a_file_that_a_function_reads(tmp_path: Path, call: str, message: str) -> None:
    text = f"{LOADING}def load_other(a, b): ...\nprint({call})\n"
    found = reported(tmp_path / "arm", "LAU003", "a.launch.py", text, {"config/a.yaml": "a: 1\n"})
    assert [one.message.endswith(f"/{message}") for one in found] == [True] * bool(message)


@pytest.mark.parametrize(
    ("files", "place"),
    [
        ({"param/slam.yaml": "a: 1"}, "param/slam.yaml"),
        ({"param/slam.yaml": "a: 1", "old/slam.yaml": "a: 1"}, ""),
        ({"param/other.yaml": "a: 1"}, ""),
    ],
)
def test_a_file_in_another_directory(tmp_path: Path, files: dict[str, str], place: str) -> None:
    text = '<rosparam file="$(find arm)/config/slam.yaml"/>'
    (found,) = reported(tmp_path / "arm", "LAU003", "a.launch", text, files)
    assert place in found.help
    assert ("the package has it" in found.help) is bool(place)


@pytest.mark.parametrize(
    ("test", "count"),
    [
        ("os.path.exists(VIEW)", 0),
        ("os.path.isfile(VIEW)", 0),
        ("Path(VIEW).exists()", 0),
        ("x", 1),
    ],
)
def test_a_file_that_the_program_looks_for(tmp_path: Path, test: str, count: int) -> None:
    """CharlesH777/NEXUS_GAZEBO_SIM: the configuration of RViz is in a submodule."""
    text = f"""VIEW = FindPackageShare('arm').find('arm') + '/rviz/more.rviz'
if {test}:
    Node(package='rviz2', executable='rviz2', arguments=['-d', VIEW])
"""
    assert len(reported(tmp_path / "arm", "LAU003", "a.launch.py", text)) == count


@pytest.mark.parametrize(
    ("name", "text", "help"),
    [
        (
            "a.launch",
            '<arg name="map" default="/home/me/ws/src/arm/maps/a.yaml"/>',
            "write $(find arm)/maps/a.yaml",
        ),
        (
            "a.launch.py",
            "x = {'file': '/home/me/ws/src/arm/maps/a.yaml'}",
            "write os.path.join(get_package_share_directory('arm'), 'maps/a.yaml')",
        ),
        (
            "a.launch.py",
            "x = ['python3', '/home/me/ws/src/arm/arm/a.py']",
            "install it as an executable of 'arm', and start it as a node",
        ),
        ("a.launch", '<arg name="map" default="/home/me/ws/src/arm/maps/b.yaml"/>', None),
        ("a.launch", '<arg name="map" default="/home/me/ws/src/leg/maps/a.yaml"/>', None),
        ("a.launch", '<arg name="map" default="/opt/ws/src/arm/maps/a.yaml"/>', None),
        ("a.launch", "<!-- /home/me/ws/src/arm/maps/a.yaml -->", None),
        ("a.launch.py", "# x = '/home/me/ws/src/arm/maps/a.yaml'", None),
        ("a.launch.py", "'For example, /home/me/ws/src/arm/maps/a.yaml'", None),
    ],
)
def test_a_path_on_another_computer(tmp_path: Path, name: str, text: str, help: str | None) -> None:
    files = {"maps/a.yaml": "a: 1", "arm/a.py": ""}
    found = reported(tmp_path / "arm", "LAU003", name, text, files)
    assert [one.help for one in found] == ([help] if help else [])
