"""Launch files whose paths, executables and parameters launch takes otherwise than they look."""

from pathlib import Path

import pytest

from tests.checks.bringup.nav2 import JAZZY
from tests.launched import MANIFEST, reported
from tests.naming import naming
from tests.workspaces import add_file, add_package
from urdfkit import check

_IMPORTS = """\
import os
from launch import LaunchDescription
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.descriptions import ComposableNode
HERE = os.path.dirname(__file__)
"""
_PROGRAM = f"{_IMPORTS}def generate_launch_description():\n"
_SETUP = "setup(entry_points={'console_scripts': ['talk = qbo.talk:main']})"
_OF_PYTHON = MANIFEST.replace("arm", "qbo").replace(
    "</license>", "</license><export><build_type>ament_python</build_type></export>"
)


def _of(directory: Path, code: str, *actions: str, **files: str) -> list[str]:
    """The messages of a rule about a launch file with actions."""
    body = f"    return LaunchDescription([{', '.join(actions)}])\n"
    named = {f"config/{name}.yaml": text for name, text in files.items()}
    return [
        found.message
        for found in reported(directory / "arm", code, "a.launch.py", _PROGRAM + body, named)
    ]


_CAMERA = (
    "package='realsense2_camera', name='camera', "
    "parameters=[os.path.join(HERE, '../config/c.yaml')]"
)
_COMPONENT = f"ComposableNode({_CAMERA}, plugin='realsense2_camera::RealSenseNodeFactory')"
_CONTAINER = (
    "ComposableNodeContainer(name='c', namespace='', package='rclcpp_components', "
    f"executable='component_container', composable_node_descriptions=[{_COMPONENT}])"
)
_NODE = f"Node({_CAMERA}, executable='realsense2_camera_node')"


@pytest.mark.parametrize(
    ("actions", "count"), [((_CONTAINER,), 0), ((_NODE,), 1), ((_CONTAINER, _NODE), 1)]
)
def test_the_file_of_a_composable_node_needs_no_sections(
    tmp_path: Path, actions: tuple[str, ...], count: int
) -> None:
    """isaac_manipulator: launch itself reads the file, and passes all that is in it."""
    assert len(_of(tmp_path, "LAU044", *actions, c="camera_name: camera_1\n")) == count


def test_the_file_of_a_composable_node_in_xml(tmp_path: Path) -> None:
    node = (
        '<node_container pkg="rclcpp_components" exec="component_container" name="c" namespace="">'
        '<composable_node pkg="realsense2_camera" plugin="p::C" name="camera">'
        '<param from="$(dirname)/../config/c.yaml"/></composable_node></node_container>'
    )
    files = {"config/c.yaml": "camera_name: camera_1\n"}
    assert reported(tmp_path / "arm", "LAU044", "a.launch.xml", node, files) == []


@pytest.mark.parametrize(
    ("executable", "count"), [("/home/qbo/venvs/aiml/bin/python", 0), ("tlak", 1)]
)
def test_an_executable_with_an_absolute_path(tmp_path: Path, executable: str, count: int) -> None:
    """Qbo: launch looks for a name in the package, and takes a path as it is."""
    (tmp_path / ".git").mkdir()
    add_file(tmp_path / "qbo/package.xml", _OF_PYTHON)
    add_file(tmp_path / "qbo/setup.py", _SETUP)
    node = f"Node(package='qbo', executable='{executable}')"
    assert len(_of(tmp_path, "LAU003", node)) == count


@pytest.mark.parametrize(("variable", "count"), [("HOME", 0), ("MAPS", 1)])
def test_a_path_below_the_home_directory(tmp_path: Path, variable: str, count: int) -> None:
    """ARG-NCTU: a default for HOME, which is always set."""
    path = f"os.path.join(os.environ.get('{variable}', ''), 'maps/waves.yaml')"
    node = "Node(package='ros_gz_bridge', executable='parameter_bridge', "
    node += f"parameters=[{{'config_file': {path}}}])"
    assert len(_of(tmp_path, "LAU003", node)) == count


@pytest.mark.parametrize(("package", "count"), [("ros_gz_bridge", 1), ("geozones", 0)])
def test_a_configuration_that_is_not_of_the_bridge(
    tmp_path: Path, package: str, count: int
) -> None:
    """aerostack2: another node has a parameter ``config_file``, too."""
    node = f"Node(package='{package}', executable='bridge_node', "
    node += "parameters=[{'config_file': 'config/z.yaml'}])"
    assert len(_of(tmp_path, "LAU003", node)) == count


def test_a_relative_path_to_another_package(tmp_path: Path) -> None:
    """multi_robots: ``base/teleop/config/demux.yaml`` is found from the directory of sources."""
    (tmp_path / ".git").mkdir()
    add_package(tmp_path / "teleop", "teleop")
    add_file(tmp_path / "teleop/config/demux.yaml", "")
    path = "base/teleop/config/demux.yaml"
    text = f"Node(package='teleop', executable='e', parameters=['{path}'])"
    program = f"{_PROGRAM}    return LaunchDescription([{text}])\n"
    (found,) = reported(tmp_path / "arm", "LAU003", "a.launch.py", program)
    assert found.message == naming(path)
    assert '("teleop"), "config/demux.yaml"' in found.help


_OF_BOTH = """\
def described(plugin):
    if {test}:
        file = LaunchConfiguration('file')
    elif plugin == '':
        file = ''
    else:
        file = 'plugins/' + plugin + '.yaml'
    return LaunchDescription([Node(package='p', executable='e', arguments=[file])])
def generate_launch_description():
    return described(LaunchConfiguration('plugin'))
"""


@pytest.mark.parametrize(
    ("test", "count"), [("isinstance(plugin, LaunchConfiguration)", 0), ("os.getpid()", 2)]
)
def test_a_function_for_texts_and_substitutions(tmp_path: Path, test: str, count: int) -> None:
    """aerostack2: it asks which of both it is called with; other files pass a text."""
    text = _IMPORTS + _OF_BOTH.format(test=test)
    assert len(reported(tmp_path / "arm", "LAU034", "a.launch.py", text)) == count


@pytest.mark.parametrize(
    ("attribute", "help"),
    [("robot_description", "MoveItConfigsBuilder"), ("text", "moveit_config_file")],
)
def test_the_configuration_of_moveit_is_no_typo(tmp_path: Path, attribute: str, help: str) -> None:
    """crb15000_5_95: a node gets the configuration of a builder that is not there."""
    text = (
        f"{_PROGRAM}"
        "    moveit_config_file = LaunchConfiguration('file')\n"
        f"    node = Node(package='p', executable='e', parameters=[moveit_config.{attribute}])\n"
        "    return LaunchDescription([node, moveit_config_file])\n"
    )
    (found,) = reported(tmp_path / "arm", "LAU035", "a.launch.py", text)
    assert (found.message, help in found.help) == (naming("moveit_config"), True)


@pytest.mark.parametrize(
    ("executable", "count"), [("merge_maps_kinematic", 0), ("sync_slam_toolbox_node", 1)]
)
def test_the_program_of_slam_toolbox_that_needs_no_activation(
    tmp_path: Path, executable: str, count: int
) -> None:
    slam = f"Node(package='slam_toolbox', executable='{executable}')"
    other = "Node(package='p', executable='e', parameters=[os.path.join(HERE, '../config/c.yaml')])"
    assert len(_of(tmp_path, "LAU030", slam, other, c=JAZZY)) == count


@pytest.mark.parametrize(("before", "count"), [('"\'{show: "', 0), ("'not '", 1)])
def test_a_boolean_in_an_open_quote(tmp_path: Path, before: str, count: int) -> None:
    """hydra_ros: the expression is a text in YAML, made of several pieces."""
    text = (
        "from launch.actions import DeclareLaunchArgument\n"
        "from launch.substitutions import PythonExpression\n"
        f"{_PROGRAM}"
        f"    text = PythonExpression([{before}, LaunchConfiguration('show'), \"}}'\"])\n"
        "    show = DeclareLaunchArgument('show', default_value='true')\n"
        "    return LaunchDescription([show, Node(package='p', executable=text)])\n"
    )
    assert len(reported(tmp_path / "arm", "LAU034", "a.launch.py", text)) == count


_GATHERED = """\
def files(target, source):
    for path in glob(f'{source}/*'):
        if os.path.isdir(path):
            files(f'{target}/{path}', path)
setup(name='arm', data_files=[*files('share/arm/launch/ros2', 'launch/ros2')])
"""


@pytest.mark.parametrize(
    ("setup", "count"), [(_GATHERED, 0), ("setup(name='arm', data_files=['launch/ros2'])\n", 1)]
)
def test_a_function_that_gathers_the_data_files(tmp_path: Path, setup: str, count: int) -> None:
    """hexfellow: it goes through the directories itself."""
    manifest = MANIFEST.replace(
        "</license>", "</license><export><build_type>ament_python</build_type></export>"
    )
    add_file(tmp_path / "package.xml", manifest)
    add_file(tmp_path / "setup.py", setup)
    file = add_file(tmp_path / "launch/ros2/a.launch.py", f"{_PROGRAM}    return None\n")
    assert len(check(file, select=["PKG002"]).diagnostics) == count


def test_the_info_of_the_camera_with_the_image(tmp_path: Path) -> None:
    """avone: of two cameras, that whose depth image is meant; the other one is named first."""
    topics = ("front/camera_info", "left/depth_image", "left/camera_info")
    kinds = {"camera_info": "CameraInfo", "depth_image": "Image"}
    bridged = ", ".join(
        f"'/{topic}@sensor_msgs/msg/{kind}[gz.msgs.{kind}'"
        for topic in topics
        for kind in (kinds[topic.rpartition("/")[2]],)
    )
    bridge = f"Node(package='ros_gz_bridge', executable='parameter_bridge', arguments=[{bridged}])"
    scan = "Node(package='depthimage_to_laserscan', executable='depthimage_to_laserscan_node')"
    found = _of(tmp_path, "LAU032", bridge, scan)
    assert found == [
        naming("depthimage_to_laserscan_node", "/depth", "/left/depth_image"),
        naming(
            "depthimage_to_laserscan_node", "/depth_camera_info", "CameraInfo", "/left/camera_info"
        ),
    ]


@pytest.mark.parametrize(("end", "count"), [("'--', ", 0), ("", 1)])
def test_options_behind_the_arguments_of_ros(tmp_path: Path, end: str, count: int) -> None:
    """multi_robot_slam: ``--`` ends the arguments of ROS."""
    words = f"'ros2', 'run', 'ros_gz_sim', 'create', '--ros-args', '-r', '__ns:=/', {end}"
    text = (
        "from launch.actions import ExecuteProcess\n"
        f"{_PROGRAM}    spawn = ExecuteProcess(cmd=[{words}'-topic', 'robot_description'])\n"
        "    return LaunchDescription([spawn])\n"
    )
    assert len(reported(tmp_path / "arm", "LAU016", "a.launch.py", text)) == count


@pytest.mark.parametrize(
    ("condition", "count"),
    [
        ("LaunchConfiguration('sim')", 0),
        ("IfCondition(LaunchConfiguration('sim'))", 1),
    ],
)
def test_the_condition_of_a_substitution(tmp_path: Path, condition: str, count: int) -> None:
    """acl-robotgroup/mobile_manipulator: IfElseSubstitution decides by the text of another one."""
    imports = (
        "from launch.conditions import IfCondition\n"
        "from launch.substitutions import IfElseSubstitution, LaunchConfiguration\n"
    )
    value = f"IfElseSubstitution(condition={condition}, if_value='a', else_value='b')"
    node = f"Node(package='p', executable='e', arguments=[{value}])"
    text = f"{imports}{_PROGRAM}    return LaunchDescription([{node}])\n"
    found = reported(tmp_path / "arm", "LAU033", "a.launch.py", text)
    assert len(found) == count
