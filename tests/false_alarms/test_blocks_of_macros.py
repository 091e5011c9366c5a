"""A block of a macro is inserted as it is called: its name is wrong, not that it is there."""

from pathlib import Path

from tests.naming import naming
from urdfkit import check, fix

ROBOT = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="camera" params="parent *optical_origin">
    <link name="optical"/>
    <joint name="optical_joint" type="fixed">
      <xacro:insert_block name="optical_origin"/>
      <parent link="${parent}"/>
      <child link="optical"/>
    </joint>
  </xacro:macro>
  <link name="base"/>
  <xacro:camera parent="base">
    <optical_origin xyz="0 0 1" rpy="0 0 0"/>
  </xacro:camera>
</robot>
"""


def test_it_is_renamed_in_the_call(tmp_path: Path) -> None:
    robot = tmp_path / "r.urdf.xacro"
    robot.write_text(ROBOT)
    (found,) = check(robot, select=["URD001"]).diagnostics
    assert found.message == naming(
        "optical_joint", "unknown", "<optical_origin>", "<joint>", "ignored", "<origin>"
    )
    assert found.help == naming("<origin>", "camera")
    assert found.span.line == 12
    assert found.fix is not None
    assert not found.fix.safe
    fix(robot, select=["URD001"], unsafe=True).write()
    assert robot.read_text() == ROBOT.replace("<optical_origin ", "<origin ")


def test_elsewhere_such_a_name_says_nothing(tmp_path: Path) -> None:
    robot = tmp_path / "r.urdf.xacro"
    robot.write_text(
        '<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="fixed">'
        '<parent link="a"/><child link="b"/><optical_origin/></joint></robot>'
    )
    (found,) = check(robot, select=["URD001"]).diagnostics
    assert found.message == naming("j", "unknown", "<optical_origin>", "<joint>", "ignored")


def test_the_frame_has_the_rotation_that_is_not_read(tmp_path: Path) -> None:
    robot = tmp_path / "r.urdf.xacro"
    names = {'"optical"': '"camera_optical_frame"', '"base"': '"camera_link"'}
    text = ROBOT.replace('rpy="0 0 0"', 'rpy="-1.5708 0 -1.5708"')
    for old, new in names.items():
        text = text.replace(old, new)
    robot.write_text(text)
    found = check(robot, select=["URD001", "JNT030"]).diagnostics
    assert [one.code for one in found] == ["URD001"]
