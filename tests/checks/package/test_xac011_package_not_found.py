from pathlib import Path

import pytest

from tests.naming import naming
from tests.xacros import codes, reported, told_of, write
from urdfkit.lint import engine
from urdfkit.lint.grouping import grouped
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Source


def test_what_was_searched_and_how_to_name_it() -> None:
    (found,) = reported("XAC011", '<xacro:include filename="$(find lost_description)/arm.xacro"/>')
    assert found.span.text == "$(find lost_description)"
    start = "package 'lost_description' is not found, so the robot is not checked; searched: "
    assert found.message.startswith(start)
    assert "AMENT_PREFIX_PATH" in found.message
    assert "ROS_PACKAGE_PATH" in found.message
    assert found.help == "pass its directory: --package lost_description=DIR"


def test_what_follows_from_it_is_not_reported() -> None:
    body = '<xacro:include filename="$(find gone)/a.xacro"/><xacro:arm/><link name="${length}"/>'
    assert codes(body) == ["XAC011"]


def test_every_package_is_reported() -> None:
    body = (
        '<xacro:include filename="$(find shoulder)/a.xacro"/>\n'
        '<xacro:include filename="$(find hand)/h.xacro"/>\n<link name="$(find base)"/>'
    )
    assert [(one.span.line, one.span.text) for one in reported("XAC011", body)] == [
        (2, "$(find shoulder)"),
        (3, "$(find hand)"),
        (4, "$(find base)"),
    ]


def test_found_by_name_and_beside(tmp_path: Path) -> None:
    workspace = tmp_path / "a" / "b" / "c" / "d" / "e" / "ws"
    here, arm, there = workspace / "robot", workspace / "arm", tmp_path / "far" / "away" / "hand"
    for directory, name in ((here, "robot"), (arm, "arm"), (there, "hand")):
        directory.mkdir(parents=True)
        (directory / "package.xml").write_text(f"<package><name>{name}</name></package>")
        write(directory, part='<link name="a"/>')
    include = '<xacro:include filename="$(find {})/part.xacro"/>'
    write(here, robot=include.format("arm") + include.format("robot"))
    assert told_of("XAC011", here / "robot.xacro") == []
    write(here, robot=include.format("hand"))
    assert len(told_of("XAC011", here / "robot.xacro")) == 1
    report = engine.check(here / "robot.xacro", select=["XAC"], packages={"hand": str(there)})
    assert report.diagnostics == ()


def test_a_package_that_is_used_often_is_shown_once() -> None:
    uses = "\n".join(f'<link name="$(find shoulder)/{i}"/>' for i in range(7))
    (found,) = grouped(reported("XAC011", uses))
    assert found.message == naming("shoulder", "AMENT_PREFIX_PATH", "ROS_PACKAGE_PATH", "14", "6")
    assert len(found.related) == 6


def launch(package: str) -> bytes:
    return f'<launch><node name="a" pkg="{package}" type="a"/></launch>'.encode()


def test_an_unknown_package_of_a_launch_file_is_reported_with_the_directories_searched(
    tmp_path: Path,
) -> None:
    source = Source(str(tmp_path / "a.launch"), launch("no_such_pkg"))
    (finding,) = engine.check(source).diagnostics
    assert (finding.code, finding.severity) == ("XAC011", Severity.INFO)
    assert finding.span.text == "no_such_pkg"
    message, _, searched = finding.message.partition("; searched: ")
    assert message == naming("no_such_pkg", "found")
    assert str(tmp_path) in searched


def test_what_a_launch_file_lacks_is_one_finding_for_people(tmp_path: Path) -> None:
    text = b"".join(launch(name) for name in ("no_pkg", "no_node", "no_drivers"))
    text = text.replace(b"</launch><launch>", b"")
    found = engine.check(Source(str(tmp_path / "a.launch"), text)).diagnostics
    assert len(found) == 3
    (seen,) = grouped(found)
    assert [note.message for note in seen.related] == [
        naming("no_node", "found"),
        naming("no_drivers", "found"),
    ]


def test_packages_of_ros_and_declared_ones_are_calm(tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text(
        "<package><name>a</name><exec_depend>no_such_pkg</exec_depend></package>"
    )
    for package in ("diagnostic_aggregator", "rviz2", "no_such_pkg"):
        path = str(tmp_path / "a.launch")
        assert engine.check(Source(path, launch(package))).diagnostics == ()


def test_a_typo_in_a_launch_file_is_a_warning(tmp_path: Path) -> None:
    for name in ("arm_driver", "arm_bringup"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "package.xml").write_text(f"<package><name>{name}</name></package>")
    path = str(tmp_path / "arm_bringup" / "a.launch")
    (found,) = engine.check(Source(path, launch("arm_drvier"))).diagnostics
    assert found.severity is Severity.WARNING
    assert "'arm_driver'?; searched" in found.message
    (found,) = engine.check(Source(path, launch("vesc_driver"))).diagnostics
    assert (found.severity, found.span.text) == (Severity.INFO, "vesc_driver")
    assert "<run_depend>vesc_driver</run_depend>" in found.help


def test_a_declared_package_is_missing_on_this_machine_only(tmp_path: Path) -> None:
    """No defect of the robot; yet it is not checked, and the gate must not be green."""
    text = "<package><name>a</name>{}</package>"
    write(tmp_path, robot='<xacro:include filename="$(find arm)/a.xacro"/>')
    for tag in ("", "<depend>arm</depend>"):
        (tmp_path / "package.xml").write_text(text.format(tag))
        (found,) = engine.check(tmp_path / "robot.xacro", select=["XAC", "CFG"]).diagnostics
        assert (found.code, found.severity) == ("XAC011", Severity.WARNING)
        assert ("not declared in package.xml" in found.message) is not bool(tag)


def test_a_macro_that_calls_itself_for_want_of_the_one_that_is_included() -> None:
    """osx_robot: its `ur_robot` includes the file of ur_description that defines `ur_robot`."""
    call = '<xacro:include filename="$(find ur)/ur.xacro"/><xacro:ur/>'
    assert codes(f'<xacro:macro name="ur">{call}</xacro:macro><xacro:ur/>') == ["XAC011"]


def test_a_package_of_the_workspace_that_has_the_file(tmp_path: Path) -> None:
    for name in ("arm_description", "arm_bringup"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "package.xml").write_text(f"<package><name>{name}</name></package>")
    write(tmp_path / "arm_description", hand='<link name="a"/>')
    include = '<xacro:include filename="$(find arm)/{}.xacro"/>'
    write(tmp_path / "arm_bringup", robot=include.format("hand") + include.format("foot"))
    hand, foot = told_of("XAC011", tmp_path / "arm_bringup" / "robot.xacro")
    assert hand.help == naming("--package", "arm=DIR", "arm_description", "hand.xacro")
    assert foot.help == naming("--package", "arm=DIR")
    write(tmp_path / "arm_bringup", hand='<link name="a"/>')
    hand, _ = told_of("XAC011", tmp_path / "arm_bringup" / "robot.xacro")
    assert hand.help == naming("--package", "arm=DIR"), "two packages have it"


@pytest.mark.parametrize(("name", "count"), [("ros_gz_sims", 1), ("ros_gz_driver", 0)])
def test_a_misspelt_package_of_ros(tmp_path: Path, name: str, count: int) -> None:
    found = engine.check(Source(str(tmp_path / "a.launch"), launch(name))).diagnostics
    warnings = [one.message for one in found if one.severity is Severity.WARNING]
    assert [message.count("'ros_gz_sim'") for message in warnings] == [1] * count
