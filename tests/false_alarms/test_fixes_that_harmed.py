"""Fixes that were offered for robots that are right, or edited more than was wrong."""

from pathlib import Path

import pytest

from urdfkit.lint.engine import check
from urdfkit.lint.fix import fix

#: RotorS' hummingbird: a published tensor; cylinder and box only stand for the body between arms.
DRONE = """\
<robot name="drone">
  <link name="base_link">
    <inertial>
      <mass value="0.68"/>
      <inertia ixx="0.007" ixy="0.0" ixz="0.0" iyy="0.007" iyz="0.0" izz="0.012"/>
    </inertial>
    <visual><geometry><cylinder radius="0.1" length="0.12"/></geometry></visual>
    <collision><geometry>{collision}</geometry></collision>
  </link>
</robot>
"""

#: As Kinova's wrist, with a turned box for its mesh: iyz has the wrong sign, the rest is measured.
WRIST = """\
<robot name="arm">
  <link name="wrist">
    <inertial>
      <mass value="12"/>
      <inertia ixx="0.1003" ixy="0" ixz="0" iyy="0.0618" iyz="0.02790" izz="0.1177"/>
    </inertial>
    <collision>
      <origin rpy="0.4 0 0"/><geometry><box size="0.2 0.3 0.1"/></geometry>
    </collision>
  </link>
</robot>
"""


@pytest.mark.parametrize(
    "collision", ['<box size="0.1 0.1 0.12"/>', '<cylinder radius="0.1" length="0.12"/>']
)
def test_a_published_tensor_beside_a_placeholder_shape_stays(
    tmp_path: Path, collision: str
) -> None:
    robot = tmp_path / "drone.urdf"
    robot.write_text(DRONE.format(collision=collision))
    inertia = [one for one in check(robot).diagnostics if one.code.startswith("INE")]
    assert [one.fix for one in inertia] == [None] * len(inertia)
    assert fix(robot, unsafe=True, select=["INE006", "INE008"]).files == ()


def test_of_a_measured_tensor_the_wrong_sign_alone_is_edited(tmp_path: Path) -> None:
    robot = tmp_path / "arm.urdf"
    robot.write_text(WRIST)
    fixes = fix(robot, unsafe=True)
    assert [one.code for one in fixes.applied] == ["INE006"]
    assert fixes.files[0].after.decode() == WRIST.replace('"0.02790"', '"-0.02790"')


def test_two_elements_do_not_become_the_same_one(tmp_path: Path) -> None:
    """ETH's SMB: <center_x> and <center_y> are not both <center>."""
    robot = tmp_path / "smb.urdf"
    robot.write_text(
        '<robot name="smb"><link name="a"/><gazebo reference="a"><sensor name="s" type="camera">'
        "<camera><distortion><center_x>1</center_x><center_y>2</center_y></distortion></camera>"
        "</sensor></gazebo></robot>"
    )
    found = check(robot, select=["GAZ003"]).diagnostics
    assert [one.fix for one in found] == [None, None]
