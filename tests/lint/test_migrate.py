"""From one Gazebo to another: the diff applies, and what is left is said."""

import shutil
import subprocess
from pathlib import Path

import pytest

from tests.conftest import MISSION
from urdfkit.cli import main
from urdfkit.lint.migrate import migrate
from urdfkit.ros.targets import UnknownTarget
from urdfkit.text.source import Source


def test_renames_are_made_in_the_text_and_nothing_else_changes() -> None:
    migration = migrate(MISSION, "classic-ros2")
    ((source, text),) = migration.texts.items()
    before, after = source.data.decode().splitlines(), text.decode().splitlines()
    changed = [
        (old.strip(), new.strip()) for old, new in zip(before, after, strict=True) if old != new
    ]
    assert (
        "<odometryFrame>odom</odometryFrame>",
        "<odometry_frame>odom</odometry_frame>",
    ) in changed
    fixes = [found.fix for found in migration.renamed if found.fix]
    tags = [edit for fix in fixes for edit in fix.edits]
    assert 2 * len(changed) == len(tags)  # start and end
    left = {diagnostic.code for diagnostic in migration.left}
    assert "GAZ012" in left  # the lidar's plugin has a successor with other tags


def test_the_diff_of_a_file_without_a_last_line_end(tmp_path: Path) -> None:
    path = tmp_path / "r.xacro"
    head, tag, tail = MISSION.read_bytes().rpartition(b"</frameName>")
    path.write_bytes(head + tag + tail.replace(b"\n", b""))
    assert "</robot>\n\\ No newline at end of file\n" in migrate(path, "classic-ros2").diff()


def test_the_same_gazebo_needs_nothing() -> None:
    migration = migrate(MISSION, "classic-ros1")
    assert tuple(migration) == ({}, (), (), {})
    assert migration.diff() == ""


def test_migrating_twice_leaves_what_a_person_must_do() -> None:
    first = migrate(MISSION, "classic-ros2")
    (text,) = first.texts.values()
    second = migrate(Source(str(MISSION), text), "classic-ros2")
    assert second.renamed == ()
    assert len(second.left) == len(first.left)


@pytest.mark.skipif(shutil.which("patch") is None, reason="patch is not installed")
def test_patch_takes_what_the_command_prints(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    shutil.copy(MISSION, tmp_path / "robot.xacro")
    monkeypatch.chdir(tmp_path)
    assert main(["migrate", "robot.xacro", "--to", "classic-ros2"]) == 1
    printed = capsys.readouterr().out
    assert "\n# robot.xacro:" in printed
    subprocess.run(["patch", "-p0"], input=printed, text=True, check=True, capture_output=True)
    (text,) = migrate(MISSION, "classic-ros2").texts.values()
    assert (tmp_path / "robot.xacro").read_bytes() == text


def test_the_diff_of_an_included_file_applies(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """GNU patch rejects absolute paths, which $(find ...) leads to."""
    part = tmp_path / "bot" / "part.xacro"
    part.parent.mkdir()
    (tmp_path / "bot" / "package.xml").write_text("<package><name>bot</name></package>")
    shutil.copy(MISSION, part)
    (tmp_path / "bot" / "robot.xacro").write_text(
        '<robot name="bot" xmlns:xacro="http://ros.org/wiki/xacro">'
        '<xacro:include filename="$(find bot)/part.xacro"/></robot>'
    )
    monkeypatch.chdir(tmp_path)
    assert main(["migrate", "bot/robot.xacro", "--to", "classic-ros2"]) == 1
    printed = capsys.readouterr().out
    subprocess.run(["patch", "-p0"], input=printed, text=True, check=True, capture_output=True)
    assert part.read_bytes() != MISSION.read_bytes()


def test_the_command_says_when_there_is_nothing_to_do(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["migrate", str(MISSION), "--to", "classic-ros1"]) == 0
    assert capsys.readouterr().out == "nothing to do for classic-ros1\n"


def test_of_macros_that_nothing_calls_it_is_said(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "lidar.xacro"
    plugin = '<gazebo><plugin name="p" filename="libgazebo_ros_laser.so"/></gazebo>'
    file.write_text(
        '<robot name="r" xmlns:xacro="http://ros.org/wiki/xacro">'
        f'<xacro:macro name="lidar">{plugin}</xacro:macro></robot>'
    )
    assert main(["migrate", str(file), "--to", "gz-harmonic"]) == 0
    assert capsys.readouterr().err == (
        f"note: {file}: has no links; macros change with the robot that calls them\n"
    )


def test_an_unknown_target_is_refused() -> None:
    with pytest.raises(UnknownTarget):
        migrate(MISSION, "gazebo")
    assert main(["migrate", str(MISSION), "--to", "gazebo"]) == 2


def test_of_a_file_that_cannot_be_read_nothing_is_claimed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "empty.urdf"
    file.touch()
    (reason,) = migrate(file, "gz-harmonic").unread.values()
    assert "cannot be read" in reason
    assert main(["migrate", str(file), "--to", "gz-harmonic"]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.startswith(
        f"error: {file}: it cannot be read: the file is empty (XML001); see 'urdfkit"
    )


def test_a_part_in_a_package_that_is_not_found_is_noted(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "robot.xacro"
    plugin = '<gazebo><plugin name="p" filename="libgazebo_ros_laser.so"/></gazebo>'
    file.write_text(
        '<robot name="r" xmlns:xacro="http://ros.org/wiki/xacro">\n<link name="a"/>'
        f'{plugin}\n<xacro:include filename="$(find elsewhere)/lidar.xacro"/></robot>'
    )
    assert main(["migrate", str(file), "--to", "gz-harmonic"]) == 1
    captured = capsys.readouterr()
    assert "libgazebo_ros_laser.so" in captured.out
    assert captured.err.startswith(f"note: only a part of the robot is migrated: {file}:3:")
    assert "--package elsewhere=DIR" in captured.err
