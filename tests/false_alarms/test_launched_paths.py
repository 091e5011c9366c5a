"""Paths in launch files that are right, or that only the computer of the robot has."""

import subprocess
from pathlib import Path

import pytest

from tests.launched import reported
from tests.naming import naming


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


def test_arguments_that_make_an_expression(tmp_path: Path) -> None:
    """Unitree: `$(arg dollar)` before `(find go1_description)`, which roslaunch resolves later."""
    text = (
        '<arg name="dollar" value="$"/><arg name="path" default="(find go1_description)"/>'
        '<rosparam file="$(arg dollar)$(arg path)/config/control.yaml"/>'
    )
    assert reported(tmp_path / "arm", "LAU003", "a.launch", text) == []


def test_a_path_from_where_the_user_starts_launch(tmp_path: Path) -> None:
    """Artefacts' tests: `os.path.join("src", "sam_bot", "test", "bridge.yaml")`."""
    program = (
        "from launch_ros.actions import Node\n"
        "node = [Node(package='p', executable='e', parameters=['{}/bridge.yaml'])]\n"
    )
    arm = tmp_path / "arm"
    assert reported(arm, "LAU003", "a.launch.py", program.format("src/arm/test")) == []
    assert len(reported(arm, "LAU003", "a.launch.py", program.format(f"{arm}/test"))) == 1


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


CHOSEN = """
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import UnlessCondition
from launch.substitutions import (
    Command, LaunchConfiguration, PathJoinSubstitution, PythonExpression
)
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    arm = LaunchConfiguration("arm")
    path = PathJoinSubstitution([FindPackageShare("arm"), arm, "arm.urdf"])
    robot = {{"robot_description": Command(["xacro ", path])}}
    is_virtual = PythonExpression(["'", arm, "' == 'virtual'"])
    return LaunchDescription([
        DeclareLaunchArgument("arm", default_value="real", choices=["real", "virtual"]),
        Node(
            package="robot_state_publisher",
            executable="robot_state_publisher",
            parameters=[robot],
            {condition}
        ),
    ])
"""


@pytest.mark.parametrize(
    ("condition", "count"), [("condition=UnlessCondition(is_virtual),", 0), ("", 1)]
)
def test_a_robot_of_a_choice_that_starts_no_robot(
    tmp_path: Path, condition: str, count: int
) -> None:
    """dvrk_model: a virtual patient cart has no model, and its nodes a condition."""
    text, files = CHOSEN.format(condition=condition), {"real/arm.urdf": '<robot name="arm"/>'}
    found = reported(tmp_path, "LAU003", "a.launch.py", text, files)
    assert [one.variants for one in found] == [("arm=virtual",)] * count


@pytest.mark.parametrize(("part", "count"), [("/rviz", 1), ("/home/ubuntu/arm/rviz", 0)])
def test_an_absolute_path_that_is_meant(tmp_path: Path, part: str, count: int) -> None:
    """The arm of a laboratory: its author replaced the directory, and left the package before."""
    program = f"import os\npath = os.path.join('arm', {part!r}, 'arm.rviz')\n"
    found = reported(tmp_path / "arm", "LAU003", "a.launch.py", program)
    assert [one.message for one in found] == [naming(part)] * count


@pytest.mark.parametrize(("installed", "count"), [("urdf/*", 0), ("meshes/*", 1)])
def test_a_spawned_file_that_setup_py_installs_elsewhere(
    tmp_path: Path, installed: str, count: int
) -> None:
    """A setup.py that installs `urdf/*` into `share/arm`, without `urdf`."""
    setup = (
        "from glob import glob\nfrom setuptools import setup\n"
        f"setup(name='arm', data_files=[('share/arm', glob('{installed}'))])\n"
    )
    program = (
        "import os\n"
        "from ament_index_python.packages import get_package_share_directory\n"
        "from launch_ros.actions import Node\n"
        "FILE = os.path.join(get_package_share_directory('arm'), 'arm.urdf')\n"
        "node = Node(package='gazebo_ros', executable='spawn_entity.py',\n"
        "            arguments=['-entity', 'arm', '-file', FILE])\n"
    )
    files = {"setup.py": setup, "urdf/arm.urdf": '<robot name="arm"><link name="base"/></robot>'}
    assert len(reported(tmp_path / "arm", "LAU016", "a.launch.py", program, files)) == count
