from __future__ import annotations

import pytest

from tests.reported import reported
from urdfkit.lint import engine
from urdfkit.text.source import Source


def test_in_an_attribute_and_in_a_text() -> None:
    robot = (
        '<link name="${side}_arm"/>\n<gazebo>\n'
        "<plugin><parameters>$(find a)/b.yaml</parameters></plugin></gazebo>"
    )
    found = reported("XAC003", robot)
    assert [(one.span.line, one.span.text, one.message) for one in found] == [
        (2, "${side}_arm", 'name="${side}_arm" is not expanded'),
        (4, "<parameters>", "<parameters>$(find a)/b.yaml is not expanded"),
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
