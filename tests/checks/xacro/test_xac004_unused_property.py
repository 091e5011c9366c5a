from __future__ import annotations

from pathlib import Path

import pytest

from tests.xacros import marked, reported, told_of, write

WIDTH = '<xacro:property name="width" value="0.3"/>\n'


def test_never_used() -> None:
    (found,) = reported("XAC004", f'{WIDTH}<link name="a"/>')
    assert (found.span.line, found.span.text) == (2, WIDTH.strip())
    assert found.message == "property 'width' is never used"


def test_a_block_that_is_never_inserted() -> None:
    (found,) = reported(
        "XAC004", '<xacro:property name="o"><origin/></xacro:property><link name="a"/>'
    )
    assert found.message == "property 'o' is never used"


@pytest.mark.parametrize(
    "use",
    [
        '<link name="a_${width}"/>',
        '<link name="a"/><gazebo>${width}</gazebo>',
        (
            '<link name="a"/><xacro:property name="depth" value="${2*width}"/>'
            '<material name="${depth}"/>'
        ),
        '<link name="a"/><xacro:if value="false"><link name="${width}"/></xacro:if>',
        '<link name="a"/><xacro:macro name="m" params="width:=^"><link/></xacro:macro>',
        '<link name="a"/><xacro:macro name="m" params="width:=^|1"><link/></xacro:macro>',
        '<link name="a"/><xacro:insert_block name="width"/>',
    ],
)
def test_used(use: str) -> None:
    body = (
        WIDTH
        if "insert_block" not in use
        else WIDTH.replace(' value="0.3"/>', "><origin/></xacro:property>")
    )
    assert reported("XAC004", body + use) == []


def test_a_use_in_a_comment_is_none() -> None:
    assert marked(reported("XAC004", f'{WIDTH}<link name="a"/><!-- ${{width}} -->')) == [
        (2, WIDTH.strip())
    ]


def test_an_included_file_uses_it(tmp_path: Path) -> None:
    include = '<xacro:include filename="arm.xacro"/>'
    write(tmp_path, robot=f'{WIDTH}{include}<link name="a"/>', arm='<link name="${width}"/>')
    assert told_of("XAC004", tmp_path / "robot.xacro") == []


def test_an_include_that_is_left_out_may_use_it() -> None:
    body = (
        f'{WIDTH}<link name="a"/><xacro:if value="false"><xacro:include filename="x"/></xacro:if>'
    )
    assert reported("XAC004", body) == []


def test_a_file_that_includes_this_one_may_use_it(tmp_path: Path) -> None:
    write(tmp_path, robot=f'{WIDTH}<link name="a"/>')
    assert len(told_of("XAC004", tmp_path / "robot.xacro")) == 1
    write(tmp_path, big='<xacro:include filename="robot.xacro"/><link name="${width}"/>')
    assert told_of("XAC004", tmp_path / "robot.xacro") == []


def test_of_a_library_and_of_an_included_file(tmp_path: Path) -> None:
    assert reported("XAC004", WIDTH) == []
    write(tmp_path, robot='<xacro:include filename="c.xacro"/><link name="a"/>', c=WIDTH)
    assert told_of("XAC004", tmp_path / "robot.xacro") == []
