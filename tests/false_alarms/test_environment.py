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
