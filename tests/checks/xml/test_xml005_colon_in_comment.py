from pathlib import Path

import pytest

from tests.xacros import NAMESPACE
from urdfkit.lint import engine
from urdfkit.text.diagnostic import Confidence, Diagnostic

AMENT = "<package><name>a</name><build_type>ament_cmake</build_type></package>"


def reported(
    directory: Path, robot: str, name: str = "robot.urdf", package: str = AMENT
) -> list[Diagnostic]:
    (directory / "package.xml").write_text(package)
    (directory / name).write_text(robot)
    return list(engine.check(directory / name, select=["XML005"]).diagnostics)


@pytest.mark.parametrize("colon", [": ", ":\n", ":\t"])
def test_the_first_colon_is_the_place(tmp_path: Path, colon: str) -> None:
    robot = f'<robot name="r">\n<!-- a -->\n<!-- b{colon}c: -->\n<link name="a"/></robot>'
    (found,) = reported(tmp_path, robot)
    assert (found.span.line, found.span.column, found.span.text) == (3, 7, colon)
    assert found.confidence is Confidence.INFERRED


@pytest.mark.parametrize(
    "robot",
    [
        '<robot name="r"><!-- a:b ::c --><link name="a"/></robot>',
        '<robot name="r"><link name="a: b"/></robot>',
        '<robot name="r"><!-- a -->b: c<!-- d --></robot>',
    ],
)
def test_no_colon_with_white_space_in_a_comment(tmp_path: Path, robot: str) -> None:
    assert reported(tmp_path, robot) == []


def test_a_catkin_package_has_no_such_launch_files(tmp_path: Path) -> None:
    robot = '<robot name="r"><!-- a: b --></robot>'
    assert reported(tmp_path, robot, package="<package><name>a</name></package>") == []


def test_a_file_outside_of_packages_is_not_judged(tmp_path: Path) -> None:
    file = tmp_path / "robot.urdf"
    file.write_text('<robot name="r"><!-- a: b --></robot>')
    assert engine.check(file, select=["XML005"]).diagnostics == ()


def test_a_comment_that_xacro_drops(tmp_path: Path) -> None:
    robot = f'<robot name="r" {NAMESPACE}>\n<!-- a: b -->\n<xacro:arg name="x" default="1"/>\n'
    assert reported(tmp_path, f'{robot}<link name="l$(arg x)"/></robot>', "robot.xacro") == []


def test_a_comment_that_xacro_passes_on(tmp_path: Path) -> None:
    (tmp_path / "arm.xacro").write_text(
        f'<robot {NAMESPACE}><xacro:macro name="arm">\n<!-- a: b -->\n<link name="a"/>'
        "</xacro:macro></robot>"
    )
    robot = f'<robot name="r" {NAMESPACE}><xacro:include filename="arm.xacro"/><xacro:arm/></robot>'
    (found,) = reported(tmp_path, robot, "robot.xacro")
    assert (Path(found.span.source.path).name, found.span.line) == ("arm.xacro", 2)


def test_a_library_is_judged_where_it_is_used(tmp_path: Path) -> None:
    robot = (
        f'<robot {NAMESPACE}><!-- a: b -->\n\n<xacro:macro name="m"><link/></xacro:macro></robot>'
    )
    assert reported(tmp_path, robot, "robot.xacro") == []


def test_a_package_of_rosbuild_is_of_ros_1(tmp_path: Path) -> None:
    (tmp_path / "manifest.xml").write_text("<package/>")
    robot = tmp_path / "robot.urdf"
    robot.write_text('<robot name="r"><!-- mass: 5 kg --><link name="base"/></robot>')
    report = engine.check(robot, select=["XML005"])
    assert (report.diagnostics, report.crashed) == ((), ())
