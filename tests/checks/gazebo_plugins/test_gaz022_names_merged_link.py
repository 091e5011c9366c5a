from __future__ import annotations

import pytest

from tests.gazebos import BASE, BODY, block, child, plugin, sensor
from tests.reported import fixed, messages, reported

HAND = "libgazebo_ros_hand_of_god.so"
FORCE = "libgazebo_ros_ft_sensor.so"
KEEP = '<gazebo reference="tool_joint">\n  <preserveFixedJoint>true</preserveFixedJoint>\n</gazebo>'


def hand(link: str = "tool", inside: str = BODY) -> str:
    return (
        BASE + child("tool", "fixed", inside=inside) + plugin(HAND, f"<linkName>{link}</linkName>")
    )


def test_the_survivor_is_named() -> None:
    (found,) = reported("GAZ022", hand())
    assert found.message == (
        f"plugin 'p' ({HAND}) looks for link 'tool', which Gazebo merges into link 'base': it "
        "crashes"
    )
    assert found.help == "name 'base', or keep joint 'tool_joint' with <preserveFixedJoint>"


def test_the_fix_keeps_the_joint_and_helps() -> None:
    text = fixed("GAZ022", hand())
    assert KEEP in text
    assert reported("GAZ022", text.encode()) == []


def test_a_link_without_mass_cannot_be_kept() -> None:
    (found,) = reported("GAZ022", hand(inside=""))
    assert found.fix is None
    assert found.help == "name 'base'"


def test_a_fixed_joint_is_merged_away_too() -> None:
    tags = "<topicName>t</topicName><jointName>tool_joint</jointName>"
    text = BASE + child("tool", "fixed") + plugin(FORCE, tags)
    (message,) = messages("GAZ022", text)
    assert "looks for joint 'tool_joint', which Gazebo merges into link 'base'" in message
    assert reported("GAZ022", fixed("GAZ022", text).encode()) == []


@pytest.mark.parametrize("tag", ["preserveFixedJoint", "disableFixedJointLumping"])
def test_a_joint_that_is_kept(tag: str) -> None:
    assert reported("GAZ022", hand() + block(f"<{tag}>true</{tag}>", "tool_joint")) == []


def test_the_converter_rewrites_two_names_in_plugins_of_the_model() -> None:
    tags = "<topicName>t</topicName><bodyName>tool</bodyName><frameName>tool</frameName>"
    text = BASE + child("tool", "fixed") + plugin("libgazebo_ros_p3d.so", tags)
    assert reported("GAZ022", text) == []


def test_a_frame_is_only_stamped() -> None:
    tags = "<topicName>t</topicName><frameName>tool</frameName><bodyName>tool</bodyName>"
    imu = f'<plugin name="p" filename="libgazebo_ros_imu_sensor.so">{tags}</plugin>'
    text = BASE + child("tool", "fixed") + sensor("imu", imu, "tool")
    assert reported("GAZ022", text) == []


def test_a_link_of_its_own() -> None:
    assert reported("GAZ022", hand("base")) == []
    assert reported("GAZ022", hand().replace('type="fixed"', 'type="continuous"')) == []


def test_no_state_is_needed_of_a_fixed_joint() -> None:
    states = plugin("libgazebo_ros_joint_state_publisher.so", "<joint_name>tool_joint</joint_name>")
    text = BASE + child("tool", "fixed") + states
    assert messages("GAZ022", text) == []
