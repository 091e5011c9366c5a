"""PKG009: see the rule."""

from pathlib import Path

import pytest

from tests.launched import MANIFEST, reported
from tests.workspaces import add_files

INTERFACES = """cmake_minimum_required(VERSION 3.8)
project(arm_msgs)
find_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)
find_package(std_msgs REQUIRED)
rosidl_generate_interfaces(${PROJECT_NAME}
  "msg/Load.msg"
  DEPENDENCIES std_msgs)
ament_package()
"""
GROUP = "<member_of_group>rosidl_interface_packages</member_of_group>"


@pytest.mark.parametrize(
    ("old", "new", "group", "message"),
    [
        ("", "", GROUP, ""),
        ("", "", "", "package.xml has no <member_of_group>"),
        ("std_msgs)", "std_msgs SKIP_INSTALL)", "", ""),
        ("Load", "Laod", GROUP, "interface 'msg/Laod.msg' does not exist"),
        ("msg/", "interfaces/", GROUP, "interface 'interfaces/Load.msg' does not exist"),
        ("find_package(std_msgs REQUIRED)", "", GROUP, "CMakeLists.txt does not find std_msgs"),
        ("find_package(std_msgs", "find_package(nav_msgs", GROUP, ""),  # which finds std_msgs
        ("find_package(std_msgs", "foreach(name a b)\n#", GROUP, ""),
        ("msg/Load.msg", "${files}", GROUP, ""),
    ],
)
def test_interfaces(tmp_path: Path, old: str, new: str, group: str, message: str) -> None:
    """They are those of a package on which the package of the robot depends."""
    manifest = MANIFEST.replace("<name>arm<", "<name>arm_msgs<")
    messages = {
        ".git/HEAD": "",
        "arm_msgs/package.xml": manifest.replace("</package>", f"{group}</package>"),
        "arm_msgs/CMakeLists.txt": INTERFACES.replace(old, new, 1),
        "arm_msgs/msg/Load.msg": "float64 mass\n",
    }
    add_files(tmp_path, messages)
    dependency = "<depend>arm_msgs</depend><export><build_type>ament_cmake</build_type></export>"
    files = {"package.xml": MANIFEST.replace("</package>", f"{dependency}</package>")}
    found = reported(tmp_path / "arm", "PKG009", "a.launch", "", files)
    assert [one.message.startswith(message) for one in found] == [True] * bool(message)
