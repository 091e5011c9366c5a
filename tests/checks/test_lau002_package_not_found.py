"""LAU002: see the rule."""

from urdfkit import check
from urdfkit.source import Source


def launch(package: str) -> bytes:
    return f'<launch><node name="a" pkg="{package}" type="a"/></launch>'.encode()


def test_an_unknown_package_is_told_with_the_folders_searched(tmp_path):
    (finding,) = check(Source(str(tmp_path / "a.launch"), launch("no_such_pkg"))).diagnostics
    assert finding.code == "LAU002"
    assert finding.span.text == "no_such_pkg"
    assert str(tmp_path) in finding.message


def test_packages_of_ros_and_declared_ones_are_calm(tmp_path):
    (tmp_path / "package.xml").write_text(
        "<package><name>a</name><exec_depend>no_such_pkg</exec_depend></package>"
    )
    for package in ("robot_state_publisher", "rviz2", "gazebo_ros", "no_such_pkg"):
        path = str(tmp_path / "a.launch")
        assert check(Source(path, launch(package))).diagnostics == ()
