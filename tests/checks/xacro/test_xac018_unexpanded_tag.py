from __future__ import annotations

from pathlib import Path

import pytest

from tests.reported import reported
from tests.urdfdom import needs_check_urdf, urdfdom_reads
from tests.xacros import NAMESPACE
from urdfkit.lint import engine
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Source

CALLS = '<link name="a"/>\n<xacro:camera name="c"/>\n<xacro:lidar/>'


@pytest.mark.parametrize("namespace", ["", f" {NAMESPACE}"])
def test_calls_that_nobody_answers(namespace: str) -> None:
    (found,) = reported("XAC018", f'<robot name="r"{namespace}>{CALLS}</robot>')
    assert (found.span.line, found.span.text) == (2, "xacro:camera")
    assert found.message == (
        "<xacro:camera> is a call of a xacro macro, the first of 2, and no macro is defined here"
    )
    assert [(one.span.line, one.message) for one in found.related] == [(3, "<xacro:lidar>")]


def test_the_missing_namespace_is_no_second_finding() -> None:
    source = Source("a.urdf", f'<robot name="r">{CALLS}</robot>'.encode())
    report = engine.check(source, select=["XML", "XAC", "URD"])
    assert [one.code for one in report.diagnostics] == ["XAC018"]


def test_a_nameless_part_is_judged_where_it_is_included() -> None:
    joint = '<joint name="j" type="fixed"><parent link="mount"/><child link="camera"/></joint>'
    robot = f"<robot><xacro:camera/>{joint}</robot>"
    report = engine.check(Source("extras.urdf", robot.encode()))
    serious = [one.code for one in report.diagnostics if one.severity is not Severity.INFO]
    assert serious == ["XAC018"]


def test_a_file_that_defines_or_includes_is_a_xacro() -> None:
    robot = f'<robot name="r" {NAMESPACE}><xacro:macro name="camera"/>{CALLS}</robot>'
    assert reported("XAC018", robot) == []


@needs_check_urdf
def test_urdfdom_passes_over_it(tmp_path: Path) -> None:
    assert urdfdom_reads(f'<robot name="r">{CALLS}</robot>', tmp_path)
