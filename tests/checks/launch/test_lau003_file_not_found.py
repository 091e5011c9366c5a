"""LAU003: see the rule."""

from pathlib import Path

import pytest

from tests.launched import reported
from urdfkit import check
from urdfkit.text.source import Source


def test_the_nearest_file_is_named(tmp_path):
    (tmp_path / "robot.yaml").write_text("a: 1")
    text = b'<launch><rosparam file="$(dirname)/robt.yaml"/></launch>'
    (finding,) = check(Source(str(tmp_path / "a.launch"), text)).diagnostics
    assert finding.code == "LAU003"
    assert "robt.yaml" in finding.message
    assert "'robot.yaml'" in finding.help


def test_neither_directories_nor_other_kinds_of_files_are_offered(tmp_path):
    (tmp_path / "robot").mkdir()
    (tmp_path / "robot.launch").write_text("<launch/>")
    text = b'<launch><rosparam file="$(dirname)/robot.yaml"/></launch>'
    (finding,) = check(Source(str(tmp_path / "a.launch"), text)).diagnostics
    assert finding.help == "create the file, or fix its name"


def test_a_file_that_is_there_is_calm(tmp_path):
    (tmp_path / "robot.yaml").write_text("a: 1")
    text = b'<launch><rosparam file="$(dirname)/robot.yaml"/></launch>'
    assert check(Source(str(tmp_path / "a.launch"), text)).diagnostics == ()


@pytest.mark.parametrize(
    "cmake",
    ["add_subdirectory(doc)", "configure_file(a.in a)", "file(GENERATE OUTPUT a CONTENT b)"],
)
def test_what_the_build_may_make_is_calm(tmp_path: Path, cmake: str) -> None:
    files = {"CMakeLists.txt": cmake}
    text = '<rosparam file="$(find arm)/config/made.yaml"/>'
    assert reported(tmp_path, "LAU003", "a.launch", text, files) == []
    assert len(reported(tmp_path, "LAU003", "a.launch", text, {"CMakeLists.txt": ""})) == 1


def test_a_path_that_waits_for_an_argument_is_calm(tmp_path: Path) -> None:
    text = '<arg name="arm" default=""/><rosparam file="$(find arm)/$(arg arm).yaml"/>'
    assert reported(tmp_path, "LAU003", "a.launch", text) == []
