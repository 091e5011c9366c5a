"""A macro that is called without its prefix makes no link: that is told once, where it stands."""

from __future__ import annotations

from pathlib import Path

from urdfkit import check

ROBOT = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:macro name="arm" params="side">
  <link name="${{side}}_arm">
    <inertial><mass value="1"/>
      <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
  </link>
  <joint name="${{side}}" type="fixed">
    <parent link="base"/><child link="${{side}}_arm"/>
  </joint>
</xacro:macro>
<link name="base"/>
<{call} side="left"/>
<link name="hand"/>
<joint name="wrist" type="fixed"><parent link="left_arm"/><child link="hand"/></joint>
<gazebo reference="left_arm"><material>Gazebo/Red</material></gazebo>
</robot>
"""


def codes(folder: Path, call: str, ignore: tuple[str, ...] = ()) -> set[str]:
    robot = folder / "r.urdf.xacro"
    robot.write_text(ROBOT.format(call=call))
    report = check(robot, targets=["gz-harmonic"], ignore=ignore)
    return {one.code for one in report.diagnostics}


def test_what_follows_from_it_is_silent(tmp_path: Path) -> None:
    assert codes(tmp_path, "arm") == {"XAC002"}
    assert codes(tmp_path, "xacro:arm") == {"GEO002"}


def test_who_does_not_want_to_know_of_it_hears_of_the_rest(tmp_path: Path) -> None:
    found = codes(tmp_path, "arm", ignore=("XAC002",))
    assert found >= {"INE004", "REF001", "GAZ001"}
