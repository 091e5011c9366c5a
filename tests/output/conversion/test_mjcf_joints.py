"""Joints, their actuators and the SRDF in MJCF, and what is lost of them."""

from pathlib import Path

import pytest

from tests.output.conversion.test_mjcf import INERTIAL, LIMIT, arm, loaded
from tests.own_robots import PICKER
from urdfkit import convert, read

SRDF = """<robot name="arm">
<group name="all"><joint name="turn"/></group>
<group name="same"><joint name="turn"/></group>
<group_state name="up" group="all"><joint name="turn" value="1.5"/></group_state>
<group_state name="home" group="all"><joint name="turn" value="0.5"/></group_state>
<group_state name="home" group="same"><joint name="turn" value="-0.5"/></group_state>
<group_state name="none" group="same"><joint name="other" value="-0.5"/></group_state>
<disable_collisions link1="base" link2="hand" reason="Never"/>
</robot>"""
HAND = (
    f'<link name="hand">{INERTIAL}</link><joint name="grip" type="revolute">'
    f'<parent link="tip"/><child link="hand"/>{LIMIT}<mimic joint="turn" multiplier="2"/></joint>'
    '<ros2_control name="c" type="system"><joint name="turn">'
    '<command_interface name="position"/></joint></ros2_control>'
)


def test_states_are_keyframes(tmp_path: Path) -> None:
    path = tmp_path / "arm.urdf"
    path.write_bytes(arm(LIMIT, more=HAND).data)
    (tmp_path / "arm.srdf").write_text(SRDF)
    model, _ = loaded(path, tmp_path / "o")
    assert [model.key(number).name for number in range(model.nkey)] == [
        "up",
        "all home",
        "same home",
    ]
    assert model.key_qpos.tolist() == [[1.5, 3], [0.5, 1], [-0.5, -1]]
    assert model.key_ctrl.tolist() == [[1.5], [0.5], [-0.5]]
    assert "base hand" in [model.exclude(number).name for number in range(model.nexclude)]


def test_computed_exclusions(tmp_path: Path) -> None:
    pytest.importorskip("coal")
    before, _ = loaded(PICKER, tmp_path / "o")
    after, _ = loaded(PICKER, tmp_path / "p", exclude="computed")
    assert after.nexclude > before.nexclude


def test_joints_with_names_of_generated_joints(tmp_path: Path) -> None:
    hand = (
        HAND.split("<ros2_control", maxsplit=1)[0]
        .replace("grip", "turn[1]")
        .replace('<mimic joint="turn" multiplier="2"/>', "")
    )
    model, _ = loaded(arm(kind="planar", more=hand), tmp_path / "o")
    names = [model.joint(number).name for number in range(model.njnt)]
    assert names == ["turn[0]", "turn[1]_2", "turn[2]", "turn[1]"]


@pytest.mark.parametrize(("kind", "bias"), [("revolute", True), ("continuous", False)])
def test_wheels_have_velocity_actuators(kind: str, bias: bool, tmp_path: Path) -> None:
    offered = "".join(f'<command_interface name="{one}"/>' for one in ("position", "velocity"))
    control = f'<ros2_control name="c" type="system"><joint name="turn">{offered}</joint>'
    robot = arm(LIMIT, more=f"{control}</ros2_control>", kind=kind)
    model, _ = loaded(robot, tmp_path / "o")
    assert bool(model.actuator_biasprm[0, 1]) is bias  # one for positions pulls back


FOLLOWER = (
    f'<link name="finger">{INERTIAL}</link>'
    '<joint name="follow" type="{kind}"><parent link="tip"/><child link="finger"/>'
    '<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1" jerk="2"/>'
    '<dynamics damping="1"/>{mimic}</joint>'
)


@pytest.mark.parametrize(
    ("kind", "leader", "reason"),
    [
        ("revolute", "x", "no independent joint leads it: the joint moves freely"),
        ("revolute", "follow", "no independent joint leads it"),
        ("planar", "turn", "a planar joint cannot follow another joint"),
        ("fixed", "turn", "a fixed joint does not move"),
    ],
)
def test_reasons_of_lost_mimics(kind: str, leader: str, reason: str, tmp_path: Path) -> None:
    follower = FOLLOWER.format(kind=kind, mimic=f'<mimic joint="{leader}"/>')
    _, parts = loaded(arm(LIMIT, more=follower), tmp_path / "o")
    assert parts["joint/follow/mimic"].startswith(f"lost: {reason}")


@pytest.mark.parametrize(
    ("kind", "part", "reason"),
    [
        ("planar", "limit", "a planar joint has three motions"),
        ("planar", "dynamics@damping", "a planar joint has three motions"),
        ("floating", "axis", "a floating joint has none"),
        ("revolute", "limit@jerk", "MuJoCo does not limit jerk"),
    ],
)
def test_reasons_of_lost_joint_parts(kind: str, part: str, reason: str, tmp_path: Path) -> None:
    _, parts = loaded(arm(LIMIT, more=FOLLOWER.format(kind=kind, mimic="")), tmp_path / "o")
    assert parts[f"joint/follow/{part}"].startswith(f"lost: {reason}")


def test_only_written_parts_are_kept(tmp_path: Path) -> None:
    shapes = '<geometry><box size="1 1 1"/><sphere radius="1"/></geometry>'
    tip = f"{INERTIAL}{INERTIAL}<collision>{shapes}</collision>"
    tags = (
        '<gazebo reference="tip"><mu1>1</mu1></gazebo><gazebo reference="tip"><mu1>2</mu1></gazebo>'
        '<gazebo reference="base"><mu1>1</mu1><sensor name="gps" type="navsat"/></gazebo>'
        '<transmission name="t"><type>transmission_interface/SimpleTransmission</type>'
        '<joint name="turn"><hardwareInterface>PositionJointInterface</hardwareInterface></joint>'
        "</transmission>"
    )
    robot = read(arm(LIMIT, tip=tip, more=tags))
    found = convert(robot, tmp_path / "o")
    notes = [(one.part, f"{one.result.value}: {one.note}") for one in found.entries]
    parts = dict(notes)
    assert parts["link/tip/inertial[2]"] == "lost: only the first <inertial> is read"
    only = "lost: only the first shape in <geometry> is read"
    assert parts["link/tip/collision/geometry/sphere"] == only
    assert [note for part, note in notes if part == "gazebo/tip/mu1"] == [
        "lost: a later <gazebo> sets the friction",
        "kept: friction",
    ]
    assert parts["gazebo/base/mu1"] == "lost: the link has no collision"
    assert parts["gazebo/base/sensor/gps"] == ("lost: no MuJoCo sensor for type 'navsat'")
    assert parts["transmission/t"] == "kept: actuator for position"
    assert parts["transmission/t@name"] == "lost: urdfkit does not convert it"
