from pathlib import Path

import pytest

from tests.naming import naming
from tests.reported import reported
from tests.urdfdom import needs_check_urdf, urdfdom_reads
from tests.xacros import NAMESPACE
from urdfkit.lint import engine
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Source

CALLS = '<link name="a"/>\n<xacro:camera name="c"/>\n<xacro:lidar/>'


def test_in_an_attribute_and_in_a_text() -> None:
    robot = (
        '<link name="${side}_arm"/>\n<gazebo>\n'
        "<plugin><parameters>$(find a)/b.yaml</parameters></plugin></gazebo>"
    )
    found = reported("XAC003", robot)
    assert [(one.span.line, one.span.text, one.message, one.severity) for one in found] == [
        (2, "${side}_arm", naming('name="${side}_arm"', "expanded"), Severity.ERROR),
        (4, "<parameters>", "<parameters>$(find a)/b.yaml is not expanded", Severity.WARNING),
    ]


def test_numbers_are_no_second_finding() -> None:
    robot = (
        '<link name="a"><visual><origin xyz="${x} 0 0" rpy="0 ${pi}"/>'
        '<geometry><sphere radius="${r}"/></geometry></visual></link>'
    )
    source = Source("a.urdf", f'<robot name="r">{robot}</robot>'.encode())
    report = engine.check(source, select=["XML", "XAC", "URD", "REF", "NAM"])
    assert {one.code for one in report.diagnostics} == {"XAC003"}
    assert len(report.diagnostics) == 3


@pytest.mark.parametrize(
    "robot",
    [
        '<link name="a"/><!-- ${x} $(arg y) -->',
        '<link name="a"/><material name="$x {y} $ (z)"/>',
    ],
)
def test_nothing_to_expand(robot: str) -> None:
    assert reported("XAC003", robot) == []


def test_a_blank_that_a_launch_file_fills_in_is_calm() -> None:
    """As in a package whose launch file replaces the word before Gazebo gets the robot."""
    plugin = "<gazebo><plugin><parameters>{}</parameters></plugin></gazebo>"
    assert reported("XAC003", plugin.format("$(controllers_yaml_path)")) == []
    assert len(reported("XAC003", plugin.format("$(find arm)/controllers.yaml"))) == 1
    assert len(reported("XAC003", plugin.format("$(cwd)/controllers.yaml"))) == 1
    assert len(reported("XAC003", '<link name="$(side)_arm"/>')) == 1, "of which URDF makes a name"


def test_what_a_xacro_escapes_is_meant() -> None:
    robot = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="$${a}"/></robot>'
    )
    assert reported("XAC003", robot, "robot.xacro") == []


@pytest.mark.parametrize("name", ["test_cart.xacro.urdf", "cart.urdf.xacro", "cart.xacro"])
def test_a_file_that_is_called_xacro_is_one(name: str) -> None:
    assert reported("XAC003", '<link name="$(cwd)"/>', name) == []


@pytest.mark.parametrize("namespace", ["", f" {NAMESPACE}"])
def test_calls_that_nobody_answers(namespace: str) -> None:
    (found,) = reported("XAC003", f'<robot name="r"{namespace}>{CALLS}</robot>')
    assert (found.span.line, found.span.text) == (2, "xacro:camera")
    assert found.severity is Severity.WARNING
    assert found.message == (
        "<xacro:camera> calls a xacro macro, the first of 2, but no macro is defined here"
    )
    assert [(one.span.line, one.message) for one in found.related] == [(3, "<xacro:lidar>")]


def test_the_missing_namespace_is_no_second_finding() -> None:
    source = Source("a.urdf", f'<robot name="r">{CALLS}</robot>'.encode())
    report = engine.check(source, select=["XML", "XAC", "URD"])
    assert [one.code for one in report.diagnostics] == ["XAC003"]


def test_a_nameless_part_is_judged_where_it_is_included() -> None:
    joint = '<joint name="j" type="fixed"><parent link="mount"/><child link="camera"/></joint>'
    robot = f"<robot><xacro:camera/>{joint}</robot>"
    report = engine.check(Source("extras.urdf", robot.encode()))
    serious = [one.code for one in report.diagnostics if one.severity is not Severity.INFO]
    assert serious == []


def test_a_file_that_defines_or_includes_is_a_xacro() -> None:
    robot = f'<robot name="r" {NAMESPACE}><xacro:macro name="camera"/>{CALLS}</robot>'
    assert reported("XAC003", robot) == []


@needs_check_urdf
def test_urdfdom_passes_over_it(tmp_path: Path) -> None:
    assert urdfdom_reads(f'<robot name="r">{CALLS}</robot>', tmp_path)
