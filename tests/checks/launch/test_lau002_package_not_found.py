"""LAU002: see the rule."""

from urdfkit import check
from urdfkit.lint.grouping import grouped
from urdfkit.text.source import Source


def launch(package: str) -> bytes:
    return f'<launch><node name="a" pkg="{package}" type="a"/></launch>'.encode()


def test_an_unknown_package_is_told_with_the_folders_searched(tmp_path):
    (finding,) = check(Source(str(tmp_path / "a.launch"), launch("no_such_pkg"))).diagnostics
    assert finding.code == "LAU002"
    assert finding.span.text == "no_such_pkg"
    assert finding.message == "package 'no_such_pkg' is not found"
    assert str(tmp_path) in finding.help


def test_what_a_launch_file_lacks_is_one_finding_for_people(tmp_path):
    text = b"".join(launch(name) for name in ("no_pkg", "no_node", "no_drivers"))
    text = text.replace(b"</launch><launch>", b"")
    found = check(Source(str(tmp_path / "a.launch"), text)).diagnostics
    assert len(found) == 3
    (seen,) = grouped(found)
    assert [note.message for note in seen.related] == [
        "package 'no_node' is not found",
        "package 'no_drivers' is not found",
    ]


def test_packages_of_ros_and_declared_ones_are_calm(tmp_path):
    (tmp_path / "package.xml").write_text(
        "<package><name>a</name><exec_depend>no_such_pkg</exec_depend></package>"
    )
    for package in ("robot_state_publisher", "rviz2", "gazebo_ros", "no_such_pkg"):
        path = str(tmp_path / "a.launch")
        assert check(Source(path, launch(package))).diagnostics == ()
