"""LAU005: see the rule."""

from pathlib import Path

import pytest

from urdfkit import Diagnostic, check

ROBOT = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:arg name="camera" default="true"/>
<xacro:include filename="more.xacro"/>
<link name="base_$(arg camera)_$(arg arm)"/>
</robot>"""
MORE = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:arg name="arm" default="left"/>
</robot>"""
XML = """<launch>
<param name="robot_description" command="xacro $(dirname)/r.xacro {}:=x"/>
</launch>"""


def reported(folder: Path, name: str, launch: str) -> list[Diagnostic]:
    (folder / "r.xacro").write_text(ROBOT)
    (folder / "more.xacro").write_text(MORE)
    (folder / name).write_text(launch)
    report = check(folder / name, select=["LAU005"])
    assert report.crashed == ()
    return list(report.diagnostics)


@pytest.mark.parametrize(("name", "text", "line"), [("a.launch", XML, 2)])
def test_an_argument_that_the_xacro_lacks(tmp_path: Path, name: str, text: str, line: int) -> None:
    (found,) = reported(tmp_path, name, text.format("camra"))
    assert found.message.endswith("has no argument 'camra'; did you mean 'camera'?")
    assert found.help == "pass one of: arm, camera"
    assert found.span.line == line


@pytest.mark.parametrize("argument", ["camera", "arm"])
def test_its_own_and_those_of_included_files_are_calm(tmp_path: Path, argument: str) -> None:
    assert reported(tmp_path, "a.launch", XML.format(argument)) == []
