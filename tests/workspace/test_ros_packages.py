"""The list of packages that come with ROS."""

import re
from pathlib import Path

from urdfkit.workspace import ros_packages
from urdfkit.workspace.ros_packages import comes_with_ros


def test_the_list_is_sorted_names() -> None:
    text = Path(ros_packages.__file__).with_suffix(".txt").read_text(encoding="utf-8")
    names = [line for line in text.splitlines() if not line.startswith("#")]
    assert names == sorted(set(names))
    assert all(re.fullmatch(r"[a-z][a-z0-9_]+", name) for name in names)


def test_packages_of_ros_and_others() -> None:
    assert comes_with_ros("xacro")
    assert comes_with_ros("nav2_bringup")
    assert not comes_with_ros("my_robot_description")
    assert not comes_with_ros("")
