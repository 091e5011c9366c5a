from __future__ import annotations

from pathlib import Path

import pytest

from tests.xacros import reported, told_of, write

PREFIX = '<xacro:arg name="prefix" default=""/>\n'


def test_never_used() -> None:
    (found,) = reported("XAC006", f'{PREFIX}<link name="a"/>')
    assert (found.span.line, found.span.text) == (2, PREFIX.strip())
    assert found.message == "argument 'prefix' is never used"
    assert len(reported("XAC006", f'{PREFIX}<link name="a"/>', prefix="x")) == 1, "given or not"


@pytest.mark.parametrize(
    "use",
    [
        '<link name="$(arg prefix)a"/>',
        "<link name=\"${xacro.arg('prefix')}a\"/>",
        '<link name="a"/><gazebo>$(arg prefix)</gazebo>',
        '<link name="a"/><xacro:if value="false"><link name="$(arg prefix)"/></xacro:if>',
        '<link name="$(eval prefix)a"/>',
        '<link name="a"/><xacro:arg name="b" default="$(arg prefix)"/><joint name="$(arg b)"/>',
    ],
)
def test_used(use: str) -> None:
    assert reported("XAC006", PREFIX + use) == []


def test_an_included_file_uses_it(tmp_path: Path) -> None:
    include = '<xacro:include filename="arm.xacro"/>'
    write(tmp_path, robot=f'{PREFIX}{include}<link name="a"/>', arm='<link name="$(arg prefix)l"/>')
    assert told_of("XAC006", tmp_path / "robot.xacro") == []


def test_a_file_that_includes_this_one_may_use_it(tmp_path: Path) -> None:
    write(tmp_path, robot=f'{PREFIX}<link name="a"/>')
    assert len(told_of("XAC006", tmp_path / "robot.xacro")) == 1
    write(tmp_path, big='<xacro:include filename="robot.xacro"/><link name="$(arg prefix)"/>')
    assert told_of("XAC006", tmp_path / "robot.xacro") == []


def test_of_a_library() -> None:
    assert reported("XAC006", PREFIX) == []
