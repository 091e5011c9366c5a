"""What the directory of a checkout is called decides nothing, not even where it has a space."""

from pathlib import Path

import pytest

from tests.launched import reported
from urdfkit.ros.launch.command_line import command_words

FILES = {"launch/a.rviz": "", "worlds/a.sdf": "<sdf/>"}
RVIZ = '<node pkg="rviz" type="rviz" name="rviz" args="-d $(dirname)/%s.rviz"/>'
GZ_SIM = (
    "import os\n"
    "from ament_index_python.packages import get_package_share_directory\n"
    "from launch import LaunchDescription\n"
    "from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription\n"
    "from launch.launch_description_sources import PythonLaunchDescriptionSource\n"
    "from launch.substitutions import LaunchConfiguration\n"
    "def generate_launch_description():\n"
    "    world = os.path.join(get_package_share_directory('arm'), 'worlds', '%s.sdf')\n"
    "    gz_sim = PythonLaunchDescriptionSource('/opt/ros_gz_sim/launch/gz_sim.launch.py')\n"
    "    return LaunchDescription([DeclareLaunchArgument('world', default_value=world),\n"
    "        IncludeLaunchDescription(gz_sim, launch_arguments={\n"
    "            'gz_args': ['-r ', LaunchConfiguration('world')]}.items())])\n"
)


@pytest.mark.parametrize("directory", ["arm", "my arm v1", "Biped jazzy/a b"])
@pytest.mark.parametrize(("name", "text"), [("a.launch", RVIZ), ("a.launch.py", GZ_SIM)])
def test_arguments_of_a_command_line(tmp_path: Path, directory: str, name: str, text: str) -> None:
    (tmp_path / directory).mkdir(parents=True)
    assert reported(tmp_path / directory, "LAU003", name, text % "a", FILES) == []
    (found,) = reported(tmp_path / directory, "LAU003", name, text % "b", FILES)
    assert "/b." in found.message


def test_words(tmp_path: Path) -> None:
    (tmp_path / "a b c").mkdir()
    (tmp_path / "a").mkdir()
    assert command_words(f"x file:={tmp_path}/a b c/d -e") == [
        "x",
        f"file:={tmp_path}/a",
        "b",
        "c/d",
        "-e",
    ]
    (tmp_path / "a").rmdir()
    assert command_words(f"x file:={tmp_path}/a b c/d -e") == [
        "x",
        f"file:={tmp_path}/a b c/d",
        "-e",
    ]
    assert command_words(f"{tmp_path}/z b c") == [f"{tmp_path}/z", "b", "c"]
