"""Launch files that are right: how they are read, and the robots that they start."""

from pathlib import Path

import pytest

from tests.launched import MANIFEST, launch, reported
from tests.naming import naming
from tests.workspaces import add_file, add_package
from urdfkit import check

_ROBOT = (
    '<robot name="r"><link name="base"/><gazebo><plugin filename="libgazebo_ros2_control.so" '
    'name="c"><ros><namespace>r1</namespace></ros></plugin></gazebo></robot>'
)


@pytest.mark.parametrize(("namespace", "count"), [("'-robot_namespace', 'r2', ", 0), ("", 1)])
def test_a_robot_that_is_spawned_in_a_namespace(tmp_path: Path, namespace: str, count: int) -> None:
    """gazebo_ros2_control's two robots of one description, whose plugin names the first."""
    program = (
        "from launch_ros.actions import Node\n"
        "nodes = [\n"
        "    Node(package='robot_state_publisher', executable='robot_state_publisher',\n"
        "         parameters=[{'robot_description': open('../robot.urdf').read()}]),\n"
        "    Node(package='gazebo_ros', executable='spawn_entity.py',\n"
        f"         arguments=[{namespace}'-topic', 'robot_description', '-entity', 'r']),\n"
        "    Node(package='controller_manager', executable='spawner',\n"
        "         arguments=['drive', '-c', '/r2/controller_manager']),\n"
        "]\n"
    )
    files = {"robot.urdf": _ROBOT}
    found = reported(tmp_path / "arm", "LAU022", "a.launch.py", program, files)
    assert len([one for one in found if "controller_manager" in one.message]) == count


def test_a_program_with_the_suffix_of_xml(tmp_path: Path) -> None:
    """TARE's `system_garage.launch` is Python, which `ros2 launch` tries for any suffix."""
    program = "import os\ndef generate_launch_description():\n    return None\n"
    (tmp_path / "package.xml").write_text("<package><name>arm</name></package>")
    path = add_file(tmp_path / "launch" / "a.launch", program.encode())
    assert check(path, select=["LAU001"]).diagnostics == ()
    path.write_text(program.replace("generate", "make"))
    assert len(check(path, select=["LAU001"]).diagnostics) == 1


def test_what_macos_puts_into_archives(tmp_path: Path) -> None:
    """`__MACOSX/launch/._robot.launch.py` holds attributes of a file, and no program."""
    add_file(tmp_path / "__MACOSX" / "launch" / "._a.launch.py", b"\x00\x05\x16\x07")
    add_file(tmp_path / "launch" / "a.launch", launch("").encode())
    found = check(tmp_path, select=["LAU001"]).diagnostics
    assert [one for one in found if one.code == "LAU001"] == []


def test_a_parameter_file_that_an_argument_chooses(tmp_path: Path) -> None:
    """IFRA-Cranfield: `$(find tools)/${EE_name}/controller.yaml`, where EE_name is `none`."""
    robot = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        '<xacro:property name="tool" value="none"/><link name="base"/><gazebo>'
        '<plugin filename="libgazebo_ros2_control.so" name="c">'
        "<parameters>$(find arm)/{}/control.yaml</parameters></plugin></gazebo></robot>"
    )
    add_package(tmp_path, "arm")
    for name, severity in (("${tool}", "info"), ("none", "error")):
        path = add_file(tmp_path / "r.xacro", robot.replace("{}", name).encode())
        (found,) = check(path, select=["RCT026"]).diagnostics
        assert found.severity.value == severity


@pytest.mark.parametrize(
    ("path", "severities"),
    [("/tmp/robot.urdf", []), ("/none/r.urdf", ["warning"]), ("{}/arm/r.urdf", ["error"])],
)
def test_a_robot_that_the_launch_file_writes(
    tmp_path: Path, path: str, severities: list[str]
) -> None:
    """jhj1111's rescue robot: the launch file expands the xacro into /tmp."""
    program = (
        "import launch, launch_ros.actions\n"
        "def generate_launch_description():\n"
        "    return launch.LaunchDescription([launch_ros.actions.Node(package='gazebo_ros', "
        "executable='spawn_entity.py', arguments=['-entity', 'r', "
        f"'-file', '{path.format(tmp_path)}'])])\n"
    )
    found = reported(tmp_path / "arm", "LAU016", "a.launch.py", program)
    assert [one.severity.value for one in found] == severities


@pytest.mark.parametrize(
    ("arguments", "content", "count"),
    [
        ("'-topic', 'robot_description', '-z6.35'", "", 0),
        ("'-topic', 'robot_description', '-zoom'", "", 1),
        ("'-file', FILE", '<robot name="cube"><link name="cube"/></robot>', 0),
        ("'-file', FILE", '<robot name="cube"><link name="${name}"/></robot>', 1),
    ],
)
def test_what_the_script_of_gazebo_takes(
    tmp_path: Path, arguments: str, content: str, count: int
) -> None:
    """A receptionist's '-z' '6.35', which Python joins; a cube whose xacro is plain URDF."""
    program = (
        "import os\n"
        "from ament_index_python.packages import get_package_share_directory\n"
        "from launch_ros.actions import Node\n"
        "FILE = os.path.join(get_package_share_directory('arm'), 'cube.urdf.xacro')\n"
        "spawn = Node(package='gazebo_ros', executable='spawn_entity.py',\n"
        f"             arguments=['-entity', 'cube', {arguments}])\n"
    )
    files = {"cube.urdf.xacro": content}
    assert len(reported(tmp_path / "arm", "LAU016", "a.launch.py", program, files)) == count


@pytest.mark.parametrize(
    ("build", "messages"),
    [
        ("ament_cmake", [naming("ROS 2", "$(arg ...)"), naming("ROS 2", "<rosparam>")]),
        ("catkin", [naming("unknown", "exec", "<node>", "ROS 1")]),
    ],
)
def test_a_file_that_is_half_ported(tmp_path: Path, build: str, messages: list[str]) -> None:
    """Plankton: `exec` in a file that is still mostly of ROS 1, in a package of ROS 2."""
    text = (
        '<arg name="n"/>\n<node pkg="p" type="t" exec="t" name="$(arg n)">\n'
        '<rosparam command="load" file="a.yaml"/></node>'
    )
    depend = f"<buildtool_depend>{build}</buildtool_depend></package>"
    reported(tmp_path / "arm", "LAU010", "a.launch", text)
    (tmp_path / "arm/package.xml").write_text(MANIFEST.replace("</package>", depend))
    found = check(tmp_path / "arm/launch/a.launch", select=["LAU010"]).diagnostics
    assert [one.message for one in found if "type" not in one.message] == messages


@pytest.mark.parametrize(("word", "count"), [("[GENERATED_NAME]", 0), ("r", 1)])
def test_templates_of_the_setup_assistant(tmp_path: Path, word: str, count: int) -> None:
    """MoveIt's setup assistant writes launch files and xacros from those in its sources."""
    templates = tmp_path / "setup" / "templates"
    add_file(templates / "launch" / "a.launch", f"<launch {word}/>".encode())
    including = b'<launch><include file="$(dirname)/generated.launch"/></launch>'
    add_file(templates / "launch" / "b.launch", including)
    robot = f'<robot name="{word}"><link name="a"/>text</robot>'
    add_file(templates / "config" / "a.urdf", robot.encode())
    add_file(tmp_path / "b.urdf", b'<robot name="b"><link name="a"/></robot>')
    report = check(tmp_path, select=["LAU001", "LAU003", "URD017"])
    assert [one.code for one in report.diagnostics] == ["URD017", "LAU001", "LAU003"][: 3 * count]


@pytest.mark.parametrize(
    ("height", "count"), [("0.13 / 2", 0), ("-(0.1 + 0.2) * 2", 0), ("folder / 'a'", 1)]
)
def test_numbers_that_a_launch_file_computes(tmp_path: Path, height: str, count: int) -> None:
    """tianracer: half of the diameter of a wheel is no path."""
    program = (
        "from launch_ros.actions import Node\n"
        f"folder = 'b'\nheight = {height}\n"
        "node = Node(package='tf2_ros', executable='static_transform_publisher',\n"
        "            arguments=['0', '0', str(height), '0', '0', '0', 'base', 'laser'])\n"
    )
    assert len(reported(tmp_path / "arm", "LAU036", "a.launch.py", program)) == count
