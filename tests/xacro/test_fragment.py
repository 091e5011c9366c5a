"""Parts of a robot that are checked alone."""

from pathlib import Path

import pytest

from tests.xacros import told_of, write
from urdfkit.lint import engine
from urdfkit.text.diagnostic import Severity

PART = '<xacro:wheel name="${side}_wheel"/><link name="$(arg prefix)axle"/>'


def test_names_that_the_including_file_defines(tmp_path: Path) -> None:
    write(tmp_path, robot='<xacro:include filename="part.xacro"/>', part=PART)
    (found,) = engine.check(tmp_path / "part.xacro").diagnostics
    assert found.code == "XAC001"
    assert found.message == "a part of robot.xacro, which must define 'wheel', 'prefix'"
    assert found.help.startswith("check the robot instead: urdfkit check ")
    assert found.help.endswith("robot.xacro")
    assert engine.check(tmp_path / "part.xacro").exit_code() == 0


def test_a_property_without_prefix_is_an_error_of_the_part(tmp_path: Path) -> None:
    """reem_full is a robot that a variant with a calibration board includes."""
    part = '<property name="side" value="left"/><link name="${side}_wheel"/>'
    write(tmp_path, robot='<xacro:include filename="part.xacro"/>', part=part)
    (found,) = engine.check(tmp_path / "part.xacro", select=["XAC001"]).diagnostics
    assert (found.severity, found.span.line) == (Severity.ERROR, 2)
    assert "without the prefix" in found.message


def test_without_an_including_file_they_are_errors(tmp_path: Path) -> None:
    write(tmp_path, part=PART)
    report = engine.check(tmp_path / "part.xacro", select=["XAC"])
    assert {one.code for one in report.diagnostics} == {"XAC001", "XAC010"}


def test_what_hangs_on_another_file_is_a_part_though_none_includes_it(tmp_path: Path) -> None:
    hand = '<joint name="j" type="fixed"><parent link="arm"/><child link="hand"/>{}</joint>'
    write(tmp_path, part='<link name="hand"/>' + hand.format('<origin xyz="${length} 0 0"/>'))
    (found,) = engine.check(tmp_path / "part.xacro").diagnostics
    assert found.code == "XAC001"
    assert found.message == "a part of another file, which must define 'length'"
    write(tmp_path, part='<link name="arm"/>' + hand.format('<origin xyz="${length} 0 0"/>'))
    (error,) = engine.check(tmp_path / "part.xacro", select=["XAC"]).diagnostics
    assert error.code == "XAC001"


@pytest.mark.parametrize(
    ("more", "severity"),
    [("", Severity.WARNING), ('<xacro:include filename="macros.xacro"/>', Severity.ERROR)],
)
def test_a_named_file_whose_links_hang_on_another_is_less_surely_a_part(
    tmp_path: Path, more: str, severity: Severity
) -> None:
    """utiasDSL/mobile_manipulation: the robot is in another repository, with its macros."""
    joint = '<joint name="j" type="fixed"><xacro:frame/><parent link="arm"/><child link="eye"/>'
    write(tmp_path, robot=f'{more}<link name="eye"/>{joint}</joint>')
    (found,) = engine.check(tmp_path / "robot.xacro", select=["XAC001"]).diagnostics
    assert found.severity is severity


@pytest.mark.parametrize(
    ("defined", "severity"), [("wheel", Severity.INFO), ("wheels", Severity.ERROR)]
)
def test_a_file_without_a_name_whose_macros_are_next_to_it(
    tmp_path: Path, defined: str, severity: Severity
) -> None:
    """majdros/desktop_ros2_ws: the robot includes the macros, and another of two bases."""
    macros = f'<xacro:macro name="{defined}"><link name="wheel"/></xacro:macro>'
    write(tmp_path, part='<link name="base"/><xacro:wheel/>', macros=macros)
    (found,) = engine.check(tmp_path / "part.xacro", select=["XAC001"]).diagnostics
    assert found.severity is severity


def test_other_errors_of_a_part_stay(tmp_path: Path) -> None:
    write(
        tmp_path, robot='<xacro:include filename="part.xacro"/>', part=f"{PART}\n<x a='${{1/0}}'/>"
    )
    report = engine.check(tmp_path / "part.xacro", select=["XAC"])
    assert [(one.code, one.span.line) for one in report.diagnostics] == [
        ("XAC001", 1),
        ("XAC001", 3),
    ]


def test_the_file_at_the_top_is_named(tmp_path: Path) -> None:
    write(
        tmp_path,
        robot='<xacro:include filename="arm.xacro"/>',
        arm='<xacro:include filename="part.xacro"/>',
        part='<link name="${a}"/>',
    )
    (found,) = told_of("XAC001", tmp_path / "part.xacro")
    assert found.message == "a part of robot.xacro, which must define 'a'"


def test_of_two_including_files_the_nearest(tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text("<package><name>p</name></package>")
    for version in ("v1", "v2"):
        (tmp_path / version).mkdir()
        write(
            tmp_path / version,
            robot='<xacro:include filename="part.xacro"/>',
            part='<link name="${a}"/>',
        )
    (found,) = told_of("XAC001", tmp_path / "v2" / "part.xacro")
    assert found.message.startswith("a part of robot.xacro,")


def test_includes_in_a_circle(tmp_path: Path) -> None:
    write(
        tmp_path,
        a='<xacro:include filename="b.xacro"/>',
        b='<xacro:include filename="a.xacro"/><link name="${x}"/>',
    )
    assert {one.code for one in engine.check(tmp_path / "b.xacro").diagnostics} <= {
        "XAC013",
        "XAC001",
    }


def test_a_part_that_expands_is_silent(tmp_path: Path) -> None:
    joint = '<joint name="j" type="fixed"><parent link="base"/><child link="camera"/></joint>'
    write(tmp_path, part=f'<link name="camera"/>{joint}')
    assert serious(tmp_path / "part.xacro") == {"REF001", "URD003"}
    write(tmp_path, robot='<link name="base"/><xacro:include filename="part.xacro"/>')
    assert serious(tmp_path / "part.xacro") == set()


def serious(file: Path) -> set[str]:
    report = engine.check(file)
    return {one.code for one in report.diagnostics if one.severity is not Severity.INFO}


def test_a_file_to_extend_a_robot_by_an_argument(tmp_path: Path) -> None:
    (tmp_path / "empty.urdf").write_text("<robot/>")
    assert serious(tmp_path / "empty.urdf") == {"TRE001", "URD003"}
    write(
        tmp_path,
        robot='<link name="base"/><xacro:arg name="extras" default="$(optenv EXTRAS empty.urdf)"/>'
        '<xacro:include filename="$(arg extras)"/>',
    )
    assert serious(tmp_path / "empty.urdf") == set()
    assert serious(tmp_path / "robot.xacro") == set()
