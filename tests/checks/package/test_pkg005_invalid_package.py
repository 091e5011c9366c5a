"""PKG005: see the rule."""

from pathlib import Path

import pytest

from tests.launched import MANIFEST
from tests.naming import naming
from urdfkit import Diagnostic, check

ROBOT = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="a"/>{}</robot>'
MESH = '<link name="b"><visual><geometry><mesh filename="package://arm/b.stl"/></geometry></visual></link>'
USES = '<xacro:include filename="$(find arm)/b.xacro"/>'


def reported(directory: Path, manifest: str, more: str = USES) -> list[Diagnostic]:
    (directory / "package.xml").write_text(manifest)
    (directory / "b.xacro").write_text(ROBOT.format(""))
    (directory / "urdf").mkdir()
    (directory / "urdf" / "r.xacro").write_text(ROBOT.format(more))
    report = check(directory / "urdf" / "r.xacro", select=["PKG005"])
    assert report.crashed == ()
    return list(report.diagnostics)


@pytest.mark.parametrize(
    ("old", "new", "message", "line"),
    [
        ("  <license>Apache-2.0</license>\n", "", "the package has no <license>", 2),
        ("<version>1.0.0</version>", "", "the package has no <version>", 2),
        (">arm<", ">arm!<", "'arm!' is not a valid package name", 3),
        (">1.0.0<", ">1.0<", "version '1.0' does not", 4),
        (">1.0.0<", "><", "version '' does not", 4),
        (' email="arm@example.org"', "", "the maintainer has", 6),
        (">Apache-2.0<", "><", "the license is", 7),
        ("</package>", "<run_depend>a</run_depend></package>", "<run_depend> is not a tag of ", 8),
        (
            "</package>",
            "<exec_dep>a</exec_dep></package>",
            "<exec_dep> is not a tag of format 3",
            8,
        ),
        ("</package>", "<depend>arm</depend></package>", "the package depends on", 8),
        ("</license>", "</licence>", "package.xml is not valid", 7),
        ("<license>", "<licence>", "package.xml is not valid", 7),
        ("</package>", "<export/><export/></package>", "duplicate <export>", 8),
    ],
)
def test_an_invalid_manifest(tmp_path: Path, old: str, new: str, message: str, line: int) -> None:
    assert old in MANIFEST
    (found,) = reported(tmp_path, MANIFEST.replace(old, new))
    assert found.message.startswith(message)
    assert (Path(found.span.source.path).name, found.span.line) == ("package.xml", line)


@pytest.mark.parametrize(("wrong", "help"), [("run_depend", "exec_depend"), ("depnd", "depend")])
def test_the_tag_that_was_meant(tmp_path: Path, wrong: str, help: str) -> None:
    text = MANIFEST.replace("</package>", f"<{wrong}>xacro</{wrong}></package>")
    assert reported(tmp_path, text)[0].help == f"write <{help}>"


def test_a_package_without_a_name(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, MANIFEST.replace("<name>arm</name>", ""), MESH)
    assert found.message == naming("package", "<name>")


@pytest.mark.parametrize(
    "manifest",
    [
        MANIFEST,
        MANIFEST.replace('"3"', '"1"') + "<!-- <run_depend>a</run_depend> -->",
        MANIFEST.replace("</package>", '<depend condition="$X">a</depend><export/></package>'),
        MANIFEST.replace("An arm.", "An <b>arm</b>."),
        MANIFEST.replace('"3"', '"4"').replace("</package>", "<new/></package>"),
        "<package><name>arm</name><version>1</version></package>",
    ],
)
def test_what_the_build_takes_is_calm(tmp_path: Path, manifest: str) -> None:
    assert reported(tmp_path, manifest) == []


def test_a_robot_that_uses_no_package_does_not_mind(tmp_path: Path) -> None:
    assert reported(tmp_path, MANIFEST.replace("1.0.0", "1"), "") == []


def test_a_launch_file_does(tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text(MANIFEST.replace("1.0.0", "1"))
    (tmp_path / "a.launch").write_text("<launch/>")
    assert len(check(tmp_path / "a.launch", select=["PKG005"]).diagnostics) == 1


BUILD_TYPE = "<export><build_type>{}</build_type></export></package>"


@pytest.mark.parametrize(
    ("kind", "needed"),
    [
        (BUILD_TYPE.format("ament_python"), [naming("ament_python", "setup.py", "CMakeLists.txt")]),
        (BUILD_TYPE.format("ament_cmake"), []),
        ("<!-- <build_type>ament_python</build_type> --></package>", []),
    ],
)
def test_the_build_file_of_the_build_type(tmp_path: Path, kind: str, needed: list[str]) -> None:
    (tmp_path / "CMakeLists.txt").write_text("project(arm)\n")
    found = reported(tmp_path, MANIFEST.replace("</package>", kind))
    assert [one.message for one in found] == needed


@pytest.mark.parametrize(
    ("tag", "message", "help"),
    [
        ("<depend>rospy</depend>", "<depend> rospy: ROS 2", "write rclpy"),
        (
            "<exec_depend>ros-gz-sim</exec_depend>",
            "<exec_depend> ros-gz-sim: the name",
            "write ros_gz_sim",
        ),
        ('<depend condition="$ROS_VERSION == 1">rospy</depend>', "", ""),
        ("<exec_depend>python3-numpy</exec_depend>", "", ""),
    ],
)
def test_dependencies_that_ros_2_does_not_have(
    tmp_path: Path, tag: str, message: str, help: str
) -> None:
    text = MANIFEST.replace("</package>", tag + BUILD_TYPE.format("ament_cmake"))
    found = reported(tmp_path, text)
    assert len(found) == bool(message)
    assert all(one.message.startswith(message) and one.help == help for one in found)


def test_a_tag_of_a_later_format(tmp_path: Path) -> None:
    text = MANIFEST.replace('"3"', '"2"').replace(
        "</package>", "<member_of_group>a</member_of_group></package>"
    )
    assert [one.help for one in reported(tmp_path, text)] == ['write format="3"']
