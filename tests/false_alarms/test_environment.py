"""What every shell of ROS sets need not be set where urdfkit runs."""

from pathlib import Path

import pytest

from urdfkit import check, load

ROBOT = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <link name="ros$(env ROS_VERSION)"/>
</robot>
"""
BUILDS = {"": "2", "catkin": "1", "ament_cmake": "2"}


@pytest.mark.parametrize("build", BUILDS)
def test_the_version_of_ros_is_that_of_the_package(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, build: str
) -> None:
    """Unitree's B1, as LeoBotics describes it."""
    monkeypatch.delenv("ROS_VERSION", raising=False)
    depend = f"<buildtool_depend>{build}</buildtool_depend>" if build else ""
    (tmp_path / "package.xml").write_text(f"<package><name>b1</name>{depend}</package>")
    (tmp_path / "r.xacro").write_text(ROBOT)
    report = check(tmp_path / "r.xacro", select=["XAC", "GEO002"])
    assert {found.code for found in report.diagnostics} <= {"GEO002"}
    assert report.skipped == ()
    (link,) = load(tmp_path / "r.xacro").links
    assert link.name == f"ros{BUILDS[build]}"


@pytest.mark.parametrize(("name", "is_trusted"), [("LDS_MODEL", True), ("ROBOT_NAME", False)])
def test_a_variable_that_is_set_where_the_robot_is_used(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, is_trusted: bool
) -> None:
    """TurtleBot3: its shells set the model of the lidar."""
    monkeypatch.delenv(name, raising=False)
    (tmp_path / "r.xacro").write_text(ROBOT.replace("ROS_VERSION", name))
    (found,) = check(tmp_path / "r.xacro", select=["XAC001"]).diagnostics
    assert (found.severity.value, "--trust" in found.help) == ("warning", is_trusted)
