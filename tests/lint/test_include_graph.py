"""Which xacro includes which file, by the text alone."""

from pathlib import Path

import pytest

from tests.lint.directories import ROOT_ROBOT, include, names, write
from urdfkit.lint.config import Config
from urdfkit.lint.discovery import affected, discover
from urdfkit.workspace.resolve import Resolver


def test_an_expression_in_a_name_stands_for_the_files_it_may_mean(tmp_path):
    write(tmp_path, "robot.xacro", include("${kind}_wheel.xacro") + '<link name="a"/>')
    write(tmp_path, "big_wheel.xacro", '<link name="w"/>')
    write(tmp_path, "small_wheel.xacro", '<link name="w"/>')
    write(tmp_path, "other.xacro", '<link name="o"/>')
    assert names(discover(str(tmp_path), Config(), Resolver())) == ["other.xacro", "robot.xacro"]


@pytest.mark.parametrize("pattern", ["wheel_?.xacro", "wheel_[ab].xacro", "wheel*.xacro"])
def test_a_pattern_stands_for_the_files_that_it_matches(tmp_path, pattern):
    write(tmp_path, "robot.xacro", include(pattern) + '<link name="a"/>')
    write(tmp_path, "wheel_a.xacro", '<link name="w"/>')
    assert names(discover(str(tmp_path), Config(), Resolver())) == ["robot.xacro"]


def test_a_name_of_many_expressions_is_compared_in_time(tmp_path):
    write(tmp_path, "robot.xacro", include("${a}e" * 40 + ".xacro") + '<link name="a"/>')
    other = "e" * 200 + ".urdf"
    write(tmp_path, other, '<link name="w"/>')
    assert names(discover(str(tmp_path), Config(), Resolver())) == [other, "robot.xacro"]


def test_a_name_that_is_all_expression_hides_nothing(tmp_path):
    write(tmp_path, "robot.xacro", include("${file}") + '<link name="a"/>')
    write(tmp_path, "other.xacro", '<link name="o"/>')
    assert len(discover(str(tmp_path), Config(), Resolver()).robots) == 2


def test_any_robot_of_a_directory_is_checked_itself(tmp_path):
    """AUBO's wrapper: an argument names one of 150 robots."""
    write(tmp_path, "robot.xacro", include("${kind}.urdf") + '<link name="a"/>')
    write(tmp_path, "big.urdf", '<link name="o"/>')
    write(tmp_path, "small.urdf", '<link name="o"/>')
    assert len(discover(str(tmp_path), Config(), Resolver()).robots) == 3


def test_includes_in_comments_do_not_count(tmp_path):
    write(tmp_path, "robot.xacro", f"<!-- {include('other.xacro')} -->" + '<link name="a"/>')
    write(tmp_path, "other.xacro", '<link name="o"/>')
    assert len(discover(str(tmp_path), Config(), Resolver()).robots) == 2


def test_files_that_include_each_other_are_bounded(tmp_path):
    write(tmp_path, "a.xacro", include("b.xacro") + '<link name="a"/>')
    write(tmp_path, "b.xacro", include("a.xacro") + '<link name="b"/>')
    write(tmp_path, "c.xacro", include("a.xacro"))
    found = affected([str(tmp_path / "b.xacro")], Config(), Resolver())
    assert names(found) == ["c.xacro"]


def test_a_name_that_no_file_can_have_includes_nothing(tmp_path):
    (tmp_path / "r.xacro").write_bytes(b'<robot><xacro:include filename="a\0b.xacro"/></robot>')
    found = discover(str(tmp_path), Config(), Resolver())
    assert [Path(robot.file).name for robot in found.robots] == ["r.xacro"]


@pytest.mark.parametrize("name", ["arm.URDF", "arm.Urdf", "arm.XACRO", "arm.URDF.XACRO"])
def test_the_case_of_a_suffix_does_not_matter(tmp_path: Path, name: str):
    (tmp_path / name).write_text(ROOT_ROBOT)
    assert names(discover(str(tmp_path), Config(), Resolver())) == [name]
    (tmp_path / "top.xacro").write_text(
        f'<robot xmlns:xacro="x"><xacro:include filename="{name}"/><link name="a"/></robot>'
    )
    assert names(discover(str(tmp_path), Config(), Resolver())) == ["top.xacro"]
