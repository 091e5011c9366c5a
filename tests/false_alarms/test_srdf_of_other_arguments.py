"""SRD001: an SRDF made for one value of an argument, held against the robot with its default."""

from pathlib import Path

import pytest

from tests.launched import reported
from tests.xacros import xacro
from urdfkit import check

ROBOT = xacro(
    """<xacro:arg name="model" default="short"/><link name="base"/><link name="tool"/>
  <joint name="wrist" type="fixed"><parent link="base"/><child link="tool"/></joint>
  <xacro:if value="${'$(arg model)' == 'long'}"><link name="tip"/>
  <joint name="end" type="fixed"><parent link="tool"/><child link="tip"/></joint></xacro:if>"""
)
SRDF = """<robot name="r">
  <group name="hand"><link name="NAME"/></group>
  <disable_collisions link1="tool" link2="NAME" reason="Adjacent"/>
</robot>
"""
PARAM = '<param name="robot_description" command="xacro $(find arm)/r.urdf.xacro model:=MODEL"/>'


@pytest.mark.parametrize(
    ("model", "name", "count"),
    [("long", "tip", 0), ("long", "tipp", 2), ("short", "tip", 2)],
)
def test_a_launch_file_starts_the_robot_with_the_link(
    tmp_path: Path, model: str, name: str, count: int
) -> None:
    files = {"r.urdf.xacro": ROBOT, "r.srdf": SRDF.replace("NAME", name)}
    reported(tmp_path / "arm", "SRD001", "a.launch", PARAM.replace("MODEL", model), files)
    found = check(tmp_path / "arm" / "r.urdf.xacro", select=["SRD001"]).diagnostics
    assert len(found) == count
    for one in found:
        assert [note.message for note in one.related] == ["compared with this robot"]
        assert one.related[0].span.source.path.endswith("r.urdf.xacro")


def test_the_note_says_with_which_arguments(tmp_path: Path) -> None:
    (tmp_path / "r.urdf.xacro").write_text(ROBOT)
    (tmp_path / "r.srdf").write_text(SRDF.replace("NAME", "hand"))
    given = {"model": "long"}
    found = check(tmp_path / "r.urdf.xacro", select=["SRD001"], arguments=given).diagnostics
    assert {one.related[0].message for one in found} == {"compared with this robot, model:=long"}
