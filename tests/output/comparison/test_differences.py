"""What counts as a difference between two states of a robot."""

import os
from math import pi
from typing import Any

import pytest

from tests.documents import model
from urdfkit.output.comparison.differences import KINDS, Tolerances, differences

ROBOT = """\
<robot name="r">
  <link name="base"/>
  <link name="arm">
    <inertial>
      <origin xyz="0 0 0.1" rpy="0 0 0"/>
      <mass value="2"/>
      <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.25"/>
    </inertial>
    <visual><geometry><mesh filename="a.stl" scale="1 1 1"/></geometry></visual>
    <collision><origin xyz="0 0 1"/><geometry><box size="1 2 3"/></geometry></collision>
  </link>
  <joint name="j" type="revolute">
    <origin xyz="1 0 0" rpy="0 0 0"/>
    <parent link="base"/>
    <child link="arm"/>
    <axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="10" velocity="2"/>
  </joint>
</robot>
"""


def found(old: str, new: str, **allowed: Any) -> list[str]:
    """What one change of the text makes different."""
    assert old in ROBOT
    found = differences(model(ROBOT), model(ROBOT.replace(old, new)), Tolerances(**allowed))
    assert {difference.kind for difference in found} <= set(KINDS)
    return list(map(str, found))


def test_the_path_of_a_mesh_in_the_current_directory_is_relative() -> None:
    """What xacro finds has an absolute path."""
    (text,) = found("a.stl", f"{os.getcwd()}/meshes/b.stl")
    assert text == "link 'arm': visual mesh a.stl -> mesh meshes/b.stl"


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ('<mass value="2"', '<mass value="2.1"', "link 'arm': mass 2 kg -> 2.1 kg"),
        ('0 0 0.1"', '0 0.3 0.5"', "link 'arm': its centre of mass moved by 0.5 m"),
        (
            'ixy="0"',
            'ixy="0.01"',
            "link 'arm': inertia ixy 0 -> 0.01 kg·m²",
        ),
        ("a.stl", "b.stl", "link 'arm': visual mesh a.stl -> mesh b.stl"),
        (
            'scale="1 1 1"',
            'scale="0.001 1 1"',
            "link 'arm': visual mesh a.stl: 1 x 1 x 1 -> 0.001 x 1 x 1",
        ),
        ('size="1 2 3"', 'size="1 2 4"', "link 'arm': collision box: 1 x 2 x 3 -> 1 x 2 x 4"),
        ('size="1 2 3"', "", "link 'arm': collision box: 1 x 2 x 3 -> no size"),
        ('<box size="1 2 3"/>', '<sphere radius="1"/>', "link 'arm': collision box -> sphere"),
        ('<box size="1 2 3"/>', "", "link 'arm': collision box -> nothing"),
        (
            'xyz="0 0 1"/><g',
            'xyz="0 0 2"/><g',
            "link 'arm': the origin of its collision moved by 1 m",
        ),
        ('type="revolute"', 'type="prismatic"', "joint 'j': type revolute -> prismatic"),
        ('<parent link="base"', '<parent link="b"', "joint 'j': parent base -> b"),
        ('<child link="arm"/>', "", "joint 'j': child arm -> none"),
        ('xyz="1 0 0"', 'xyz="1 0.5 0"', "joint 'j': the origin of its frame moved by 0.5 m"),
        (
            'xyz="1 0 0" rpy="0 0 0"',
            'xyz="1 0 0" rpy="0 0 0.01"',
            "joint 'j': the origin of its frame turned by 0.01 rad",
        ),
        ('<axis xyz="0 0 1"/>', '<axis xyz="0 0 -1"/>', "joint 'j': its axis turned by 3.142 rad"),
        ('upper="1"', 'upper="1.5"', "joint 'j': upper 1 -> 1.5"),
        ('effort="10"', "", "joint 'j': effort 10 -> none"),
        ("<limit", '<mimic joint="k"/><limit', "joint 'j': mimic none -> k x 1 + 0"),
    ],
)
def test_each_difference_is_one_sentence(old, new, sentence):
    assert found(old, new) == [sentence]


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ('<axis xyz="0 0 1"/>', '<axis xyz="0 0 7"/>'),
        ('xyz="1 0 0" rpy="0 0 0"', f'xyz="1 0 0" rpy="0 0 {2 * pi}"'),
        ('value="2"', 'value="2.0005"'),
        ('<robot name="r">', '<robot name="s"><!-- said otherwise -->'),
        (
            (
                'rpy="0 0 0"/>\n      <mass value="2"/>\n      '
                '<inertia ixx="0.1" ixy="0" ixz="0" iyy="0.2"'
            ),
            (
                f'rpy="0 0 {pi / 2}"/>\n      <mass value="2"/>\n      '
                '<inertia ixx="0.2" ixy="0" ixz="0" iyy="0.1"'
            ),
        ),
    ],
)
def test_the_same_robot_said_otherwise_does_not_differ(old, new):
    assert found(old, new) == []


def test_rounding_of_a_turned_tensor_is_not_reported():
    """A quarter of a turn leaves 1e-17 where nothing is."""
    old = (
        'rpy="0 0 0"/>\n      <mass value="2"/>\n      <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.2"'
    )
    new = old.replace('"0 0 0"', f'"0 0 {pi / 2}"').replace('"0.2"', '"0.3"')
    assert found(old, new) == ["link 'arm': inertia ixx 0.1 -> 0.3, iyy 0.2 -> 0.1 kg·m²"]


def test_a_small_tensor_is_not_rounding_of_a_large_one():
    old = 'ixx="0.1" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.25"'
    new = 'ixx="1e-11" ixy="0" ixz="0" iyy="1e-11" iyz="0" izz="1e-11"'
    changed = "ixx 0.1 -> 1e-11, iyy 0.2 -> 1e-11, izz 0.25 -> 1e-11"
    assert found(old, new) == [f"link 'arm': inertia {changed} kg·m²"]


def test_tolerances_are_what_may_differ():
    assert found('value="2"', 'value="2.1"', mass=0.05) == []
    assert found('value="2"', 'value="2.1"', mass=0.04) != []
    assert found("0 0 0.1", "0 0 0.2", position=0.11) == []
    assert found('upper="1"', 'upper="1.5"', limit=0.34) == []
    assert found('upper="1"', 'upper="1.5"', limit=0.33) != []


def test_links_and_joints_that_come_and_go():
    assert found('<link name="base"/>', "") == ["link 'base': removed"]
    assert found('<link name="base"/>', "", links=True) == []
    renamed = ["joint 'j': removed", "joint 'k': added"]
    assert found('name="j"', 'name="k"') == renamed
    assert found('name="j"', 'name="k"', joints=True) == []


def test_a_massless_link_has_no_centre():
    old = model(ROBOT.replace('value="2"', 'value="0"'))
    new = model(ROBOT.replace('value="2"', 'value="0"').replace("0 0 0.1", "0 0 9"))
    assert differences(old, new, Tolerances()) == []
