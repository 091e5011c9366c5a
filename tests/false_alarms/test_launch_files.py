"""Launch files that are right: what the computer of the robot has is not in the repository."""

import subprocess
from pathlib import Path

import pytest

from tests.launched import MANIFEST, launch, reported
from tests.naming import naming
from tests.workspaces import add_file, add_package
from urdfkit import check
from urdfkit.text.diagnostic import Severity


@pytest.mark.parametrize("mark", ["", ".git/HEAD"])
def test_absolute_paths_outside_of_the_repository(tmp_path: Path, mark: str) -> None:
    """Clearpath's robots keep their description in /etc/clearpath."""
    files = {mark: ""} if mark else {}
    text = '<rosparam file="/etc/clearpath/robot.yaml"/>'
    assert reported(tmp_path / "arm", "LAU003", "a.launch", text, files) == []
    program = (
        "import launch, launch_ros.actions\n"
        "def generate_launch_description():\n"
        "    return launch.LaunchDescription([launch_ros.actions.Node(package='p', "
        "executable='e', parameters=['/etc/clearpath/platform/config/control.yaml'])])\n"
    )
    assert reported(tmp_path / "arm", "LAU003", "a.launch.py", program, files) == []
    inside = f'<rosparam file="{tmp_path}/arm/config/robot.yaml"/>'
    assert len(reported(tmp_path / "arm", "LAU003", "a.launch", inside, files)) == 1


@pytest.mark.parametrize(("name", "count"), [(".urdf.xacro", 0), ("mine.yaml", 0), ("a.yaml", 1)])
def test_files_that_the_user_names_or_makes(tmp_path: Path, name: str, count: int) -> None:
    """Interbotix: $(arg robot_model).urdf.xacro, empty by default; Stretch: a calibration."""
    subprocess.run(["git", "init", "-q", tmp_path / "arm"], check=True)
    text = f'<rosparam file="$(dirname)/config/{name}"/>'
    files = {".gitignore": "mine.yaml\n"}
    assert len(reported(tmp_path / "arm", "LAU003", "a.launch", text, files)) == count


@pytest.mark.parametrize(
    ("default", "count"),
    [("ERROR: did not specify argument --file--", 0), ("config of arm.yaml", 1), ("my arm", 1)],
)
def test_a_sentence_that_says_to_pass_a_file(tmp_path: Path, default: str, count: int) -> None:
    """mas_common_robotics: the launch file that includes this one passes the file."""
    text = f'<arg name="file" default="{default}"/><rosparam file="$(arg file)"/>'
    assert len(reported(tmp_path / "arm", "LAU003", "a.launch", text)) == count


def test_what_roslaunch_does_not_read_uses_no_argument(tmp_path: Path) -> None:
    """MoveIt configurations of Robotnik: <param> in <include>, with arguments in a comment."""
    files = {"b.launch": "<launch/>"}
    text = '<include file="$(dirname)/b.launch"><param name="p" value="$(arg p)"/></include>'
    assert reported(tmp_path / "arm", "LAU006", "a.launch", text, files) == []
    passed = text.replace("param", "arg")
    assert len(reported(tmp_path / "arm", "LAU006", "a.launch", passed, files)) == 1


@pytest.mark.parametrize(
    ("default", "severity"), [("$(arg name)_base.xacro", "info"), ("fly_base.xacro", "warning")]
)
def test_a_launch_file_for_any_robot_passes_what_some_of_them_have(
    tmp_path: Path, default: str, severity: str
) -> None:
    """RotorS: spawn_mav.launch gives every model the same arguments."""
    text = (
        f'<arg name="name" default="fly"/><arg name="model" default="$(dirname)/../{default}"/>'
        '<param name="robot_description" command="xacro $(arg model) logging:=true"/>'
    )
    files = {"fly_base.xacro": '<robot name="fly"><link name="a"/></robot>'}
    (found,) = reported(tmp_path / "arm", "LAU005", "a.launch", text, files)
    assert (found.severity.value, found.help) == (severity, "remove the argument")


def test_arguments_that_make_an_expression(tmp_path: Path) -> None:
    """Unitree: `$(arg dollar)` before `(find go1_description)`, which roslaunch resolves later."""
    text = (
        '<arg name="dollar" value="$"/><arg name="path" default="(find go1_description)"/>'
        '<rosparam file="$(arg dollar)$(arg path)/config/control.yaml"/>'
    )
    assert reported(tmp_path / "arm", "LAU003", "a.launch", text) == []


@pytest.mark.parametrize(("package", "count"), [("arm", 0), ("other", 1)])
def test_arguments_from_a_launch_file_of_another_package(
    tmp_path: Path, package: str, count: int
) -> None:
    """Franka: `move_group.launch.py` gets all its arguments from a file of `franka_bringup`."""
    (tmp_path / ".git").mkdir()
    include = f'<include file="$(find {package})/launch/group.launch"/>'
    bringup = add_package(tmp_path / "bringup", "bringup")
    add_file(bringup / "launch" / "all.launch", launch(include).encode())
    text = '<node pkg="p" type="t" name="n" if="$(arg fake)"/>'
    assert len(reported(tmp_path / "arm", "LAU006", "group.launch", text)) == count


def test_a_path_from_where_the_user_starts_launch(tmp_path: Path) -> None:
    """Artefacts' tests: `os.path.join("src", "sam_bot", "test", "bridge.yaml")`."""
    program = (
        "from launch_ros.actions import Node\n"
        "node = [Node(package='p', executable='e', parameters=['{}/bridge.yaml'])]\n"
    )
    arm = tmp_path / "arm"
    assert reported(arm, "LAU003", "a.launch.py", program.format("src/arm/test")) == []
    assert len(reported(arm, "LAU003", "a.launch.py", program.format(f"{arm}/test"))) == 1


def test_an_argument_of_an_include_that_is_off(tmp_path: Path) -> None:
    """PickNik's UR5: `<arg unless="$(arg fake)" name="robot_ip"/>` for one of two files."""
    text = (
        '<arg name="fake" default="true"/><include file="$(dirname)/b.launch">'
        '<arg {}="$(arg fake)" name="robot_ip" value="10.0.0.1"/></include>'
    )
    files = {"launch/b.launch": "<launch/>"}
    assert reported(tmp_path / "arm", "LAU005", "a.launch", text.format("unless"), files) == []
    assert len(reported(tmp_path / "arm", "LAU005", "a.launch", text.format("if"), files)) == 1


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


_FILTER = (
    "from launch_ros.actions import Node\n"
    "nodes = [\n"
    "    Node(package='robot_state_publisher', executable='robot_state_publisher',\n"
    "         parameters=[{'robot_description': open('../robot.urdf').read()}]),\n"
    "    Node(package='tf2_ros', executable='static_transform_publisher',\n"
    "         arguments=['--frame-id', 'pole', '--child-frame-id', 'imu']),\n"
    "    Node(package='robot_localization', executable='ekf_node', parameters=['../ekf.yaml']),\n"
    "]\n"
)


@pytest.mark.parametrize(
    ("name", "program", "child", "count"),
    [
        ("map", "", "imu", 1),
        ("pole", "", "imu", 0),
        ("map", 'frame = "pole"', "imu", 0),
        ("map", "", "base", 0),
    ],
)
def test_frames_that_others_publish(
    tmp_path: Path, name: str, program: str, child: str, count: int
) -> None:
    """A filter of its own tree (bumperbot), CMU's `sensor`, and a footprint above the robot."""
    files = {
        "robot.urdf": '<robot name="r"><link name="base"/></robot>',
        "ekf.yaml": f"ekf:\n  ros__parameters:\n    base_link_frame: {name}\n",
        "src/node.py": program,
    }
    text = _FILTER.replace("'imu'", f"'{child}'")
    assert len(reported(tmp_path / "arm", "LAU023", "a.launch.py", text, files)) == count


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


def test_an_absolute_part_of_a_path_drops_those_before_it(tmp_path: Path) -> None:
    """A UR5e's `initial_positions_file`, whose default is absolute, below `config` of a package."""
    program = (
        "import os\n"
        "from ament_index_python.packages import get_package_share_directory\n"
        "from launch import LaunchDescription\n"
        "from launch.substitutions import PathJoinSubstitution\n"
        "from launch_ros.actions import Node\n"
        "from launch_ros.substitutions import FindPackageShare\n"
        "FILE = os.path.join(get_package_share_directory('arm'), 'config', '{}')\n"
        "PATH = PathJoinSubstitution([FindPackageShare('arm'), 'launch', FILE])\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([Node(package='p', executable='e', parameters=[PATH])])\n"
    )
    files = {"config/a.yaml": ""}
    right, wrong = program.format("a.yaml"), program.format("b.yaml")
    assert reported(tmp_path / "arm", "LAU003", "a.launch.py", right, files) == []
    (found,) = reported(tmp_path / "arm", "LAU003", "a.launch.py", wrong, files)
    assert found.message.endswith("arm/config/b.yaml")


@pytest.mark.parametrize(("default", "count"), [("!!NO_ROBOT_SET!!", 0), ("fly", 1)])
def test_an_environment_variable_that_is_to_be_set(
    tmp_path: Path, default: str, count: int
) -> None:
    """Care-O-bot: `$(optenv ROBOT !!NO_ROBOT_SET!!)`."""
    text = (
        f'<arg name="robot" default="$(optenv ROBOT {default})"/>'
        '<rosparam file="$(dirname)/../robots/$(arg robot)/light.yaml"/>'
    )
    files = {"robots/cob4/light.yaml": ""}
    assert len(reported(tmp_path / "arm", "LAU003", "a.launch", text, files)) == count


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


def test_the_launch_file_of_ros_1_is_not_suggested_in_ros_2(tmp_path: Path) -> None:
    """A car's `empty_world.launch.py` of gazebo_ros, which has that of ROS 1 by a similar name."""
    program = (
        "import os\n"
        "from ament_index_python.packages import get_package_share_directory\n"
        "from launch import LaunchDescription\n"
        "from launch.actions import IncludeLaunchDescription\n"
        "FILE = os.path.join(get_package_share_directory('gazebo_ros'), 'launch', '{}')\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([IncludeLaunchDescription(FILE)])\n"
    )
    name = "empty_world.launch.py"
    (found,) = reported(tmp_path / "arm", "LAU003", "a.launch.py", program.format(name))
    assert "did you mean" not in found.message
    assert "gazebo.launch.py" in found.help
    (found,) = reported(
        tmp_path / "arm", "LAU003", "a.launch.py", program.format("gazeb.launch.py")
    )
    assert found.help == "write gazebo.launch.py"


@pytest.mark.parametrize("quote", ["'", ""])
@pytest.mark.parametrize(("path", "count"), [("$(find elsewhere)", 0), ("$(dirname)", 1)])
def test_quotes_around_the_configuration_of_rviz(
    tmp_path: Path, quote: str, path: str, count: int
) -> None:
    """roslaunch splits arguments as a shell does; of a missing package nothing is known."""
    words = f"-f map -d {quote}{path}/a.rviz{quote}"
    text = f'<node name="rviz" pkg="rviz" type="rviz" args="{words}"/>'
    assert len(reported(tmp_path / "arm", "LAU003", "a.launch", text)) == count


@pytest.mark.parametrize(
    ("package", "suffix", "count"),
    [("astra_camera", "_link", 0), ("astra_camera", "_frame", 1), ("tf2_ros", "_link", 1)],
)
def test_a_driver_in_the_workspace_that_composes_its_frames(
    tmp_path: Path, package: str, suffix: str, count: int
) -> None:
    """astra_camera, next to the robot: camera_name + "_link" is a frame of the camera."""
    files = {
        "robot.urdf": '<robot name="r"><link name="base"/></robot>',
        "launch/robot.launch.xml": (
            '<launch><node pkg="robot_state_publisher" exec="robot_state_publisher">'
            '<param name="robot_description" value="$(command \'cat $(dirname)/../robot.urdf\')"/>'
            "</node></launch>"
        ),
    }
    driver = add_package(tmp_path / "astra_camera", "astra_camera")
    add_file(driver / "src/camera.cpp", f'frame_ = camera_name_ + "{suffix}";'.encode())
    text = (
        f'<node pkg="{package}" exec="camera"/><node pkg="tf2_ros" '
        'exec="static_transform_publisher" args="0 0 0 0 0 0 camera1_link camera2_link"/>'
    )
    found = reported(tmp_path / "arm", "LAU023", "a.launch.xml", text, files)
    parent = naming("camera1_link", "static")
    assert [one.message for one in found] == [parent] * count  # its child is no suggestion


@pytest.mark.parametrize(("package", "count"), [("realsense2_camera", 0), ("arm", 1)])
def test_a_camera_that_names_its_frames_itself(tmp_path: Path, package: str, count: int) -> None:
    """realsense-ros in the workspace of a Go2: its driver makes camera1_link from camera_name."""
    files = {
        "robot.urdf": '<robot name="r"><link name="base"/></robot>',
        "launch/robot.launch.py": (
            "nodes = [Node(package='robot_state_publisher', executable='robot_state_publisher',\n"
            "    parameters=[{'robot_description': open('../robot.urdf').read()}])]\n"
        ),
        "launch/camera.launch.py": f"nodes = [Node(package='{package}', executable='camera')]\n",
    }
    text = (
        "nodes = [IncludeLaunchDescription(PythonLaunchDescriptionSource("
        "[ThisLaunchFileDir(), '/camera.launch.py'])),\n"
        "    Node(package='tf2_ros', executable='static_transform_publisher',\n"
        "         arguments=['0', '0', '0', '0', '0', '0', 'camera1_link', 'camera2_link'])]\n"
    )
    add_package(tmp_path / "realsense2_camera", "realsense2_camera")
    assert len(reported(tmp_path / "arm", "LAU023", "a.launch.py", text, files)) == count


@pytest.mark.parametrize(
    ("path", "count"),
    [
        ("os.pathsep.join(['models', '/opt/models'])", 0),
        ("':'.join(['models', '/opt/models'])", 0),
        ("os.path.join('models', '/opt/models')", 1),
        ("PathJoinSubstitution(['models', '/opt/models'])", 1),
    ],
)
def test_directories_of_a_search_path_are_not_parts_of_one_path(
    tmp_path: Path, path: str, count: int
) -> None:
    text = f"os.environ['GZ_SIM_RESOURCE_PATH'] = {path}\n"
    assert len(reported(tmp_path / "arm", "LAU003", "a.launch.py", text)) == count


@pytest.mark.parametrize(
    "path",
    [
        "Path(get_package_share_directory('arm')).joinpath('a.urdf')",
        "Path(get_package_share_directory('arm'), 'a.urdf')",
    ],
)
@pytest.mark.parametrize("count", [0, 1])
def test_a_path_of_pathlib(tmp_path: Path, path: str, count: int) -> None:
    files = {} if count else {"a.urdf": '<robot name="r"><link name="base"/></robot>'}
    text = f"text = open({path}).read()\n"
    assert len(reported(tmp_path / "arm", "LAU003", "a.launch.py", text, files)) == count


@pytest.mark.parametrize(("namespace", "count"), [("/stick", 0), ("/", 1)])
def test_joint_states_of_two_namespaces(tmp_path: Path, namespace: str, count: int) -> None:
    """sensor_stick: its controllers, and so their topics, are in /sensor_stick."""
    text = (
        '<node name="j" pkg="joint_state_publisher" type="joint_state_publisher"/>'
        f'<node name="s" pkg="controller_manager" type="spawner" ns="{namespace}" '
        'args="joint_state_controller"/>'
    )
    assert len(reported(tmp_path / "arm", "LAU021", "a.launch", text)) == count


@pytest.mark.parametrize(
    ("use", "severity"), [("", Severity.ERROR), ("controller_name", Severity.WARNING)]
)
def test_an_argument_that_resembles_one_that_is_used(
    tmp_path: Path, use: str, severity: Severity
) -> None:
    """Franka's example.launch.py requires `controller_names`; an included file has others."""
    text = (
        "from launch.actions import DeclareLaunchArgument\n"
        "from launch.substitutions import LaunchConfiguration\n"
        "DeclareLaunchArgument('controller_name', default_value='1')\n"
        "LaunchConfiguration('controller_nodes')\n"
    )
    text += f"LaunchConfiguration('{use}')\n" if use else ""
    (found,) = reported(tmp_path / "arm", "LAU006", "a.launch.py", text)
    assert found.severity is severity
    assert ("did you mean" in found.message) is (severity is Severity.ERROR)


@pytest.mark.parametrize(("more", "hint"), [("", True), ("fake_execution", False)])
def test_an_argument_that_is_passed_is_not_suggested(tmp_path: Path, more: str, hint: bool) -> None:
    """Robotnik's MoveIt packages: `execution_type` is not a misspelt `fake_execution`."""
    files = {"launch/b.launch": launch('<arg name="fake_execution" default="a"/>')}
    names = filter(None, ("execution", more))
    passed = "".join(f'<arg name="{name}" value="a"/>' for name in names)
    text = f'<include file="$(find arm)/launch/b.launch">{passed}</include>'
    (found,) = reported(tmp_path / "arm", "LAU005", "a.launch", text, files)
    assert ("mean 'fake_execution'?" in found.message) is hint


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


@pytest.mark.parametrize(("default", "count"), [(", default='laser'", 0), (", default='rotor'", 1)])
def test_an_argument_whose_default_is_its_own_configuration(
    tmp_path: Path, default: str, count: int
) -> None:
    """rplidar_ros: the node stamps its scans with the frame, which no transform has."""
    robot = '<robot name="r"><link name="base_link"/></robot>'
    display = "Visualization Manager:\n  Global Options:\n    Fixed Frame: laser\n"
    files = {"r.urdf": robot, "r.rviz": display}
    add_package(tmp_path / "rplidar_ros", "rplidar_ros")
    text = (
        "from launch import LaunchDescription\n"
        "from launch.actions import DeclareLaunchArgument\n"
        "from launch.substitutions import LaunchConfiguration\n"
        "from launch_ros.actions import Node\n"
        "def generate_launch_description():\n"
        f"    frame_id = LaunchConfiguration('frame_id'{default})\n"
        "    return LaunchDescription([\n"
        "        DeclareLaunchArgument('frame_id', default_value=frame_id),\n"
        "        Node(package='robot_state_publisher', executable='robot_state_publisher',\n"
        "             parameters=[{'robot_description': open('../r.urdf').read()}]),\n"
        "        Node(package='rplidar_ros', executable='rplidar_node',\n"
        "             parameters=[{'frame_id': frame_id}]),\n"
        "        Node(package='rviz2', executable='rviz2', arguments=['-d', '../r.rviz'])])\n"
    )
    found = reported(tmp_path / "arm", "LAU023", "a.launch.py", text, files)
    assert len([one for one in found if one.span.source.path.endswith(".rviz")]) == count


@pytest.mark.parametrize(("child", "count"), [("names['camera'] + '_link'", 0), ("'tip'", 1)])
def test_a_static_transform_to_a_frame_known_at_run_time(
    tmp_path: Path, child: str, count: int
) -> None:
    """realsense-ros: the frames of two cameras are named after arguments of another file."""
    robot = '<robot name="r"><link name="base_link"/></robot>'
    display = "Visualization Manager:\n  Global Options:\n    Fixed Frame: camera1_link\n"
    text = (
        "from launch import LaunchDescription\n"
        "from launch_ros.actions import Node\n"
        "from names import names\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([\n"
        "        Node(package='robot_state_publisher', executable='robot_state_publisher',\n"
        "             parameters=[{'robot_description': open('../r.urdf').read()}]),\n"
        "        Node(package='tf2_ros', executable='static_transform_publisher',\n"
        f"             arguments=['0', '0', '0', '0', '0', '0', 'base_link', {child}]),\n"
        "        Node(package='rviz2', executable='rviz2', arguments=['-d', '../r.rviz'])])\n"
    )
    files = {"r.urdf": robot, "r.rviz": display}
    assert len(reported(tmp_path / "arm", "LAU023", "a.launch.py", text, files)) == count


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


@pytest.mark.parametrize(("found", "count"), [("arm", 0), (" arm", 1)])
def test_the_package_that_find_is_asked_for(tmp_path: Path, found: str, count: int) -> None:
    """osr-rover-code: FindPackageShare does not look up its own package where find is called."""
    program = (
        "import os\n"
        "from launch import LaunchDescription\n"
        "from launch_ros.actions import Node\n"
        "from launch_ros.substitutions import FindPackageShare\n"
        f"SHARE = FindPackageShare(package=' arm').find('{found}')\n"
        "def generate_launch_description():\n"
        "    path = os.path.join(SHARE, 'config', 'a.yaml')\n"
        "    return LaunchDescription([Node(package='p', executable='e', parameters=[path])])\n"
    )
    files = {"config/a.yaml": ""}
    problems = reported(tmp_path / "arm", "XAC011", "a.launch.py", program, files)
    assert len([one for one in problems if "' arm'" in one.message]) == count
