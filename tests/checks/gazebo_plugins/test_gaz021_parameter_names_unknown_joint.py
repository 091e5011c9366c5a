from __future__ import annotations

from tests.gazebos import WHEELS, plugin
from tests.reported import messages, reported

STATES = "libgazebo_ros_joint_state_publisher.so"


def states(joints: str) -> str:
    return WHEELS + plugin(STATES, f"<jointName>{joints}</jointName>")


def test_every_name_of_a_list() -> None:
    name = f"plugin 'p' ({STATES}) looks for joint"
    outcome = "which does not exist"
    heard = messages("GAZ021", states("left_joint, rihgt_joint,spare"))
    assert [one.partition(":")[0] for one in heard] == [
        f"{name} 'rihgt_joint', {outcome}",
        f"{name} 'spare', {outcome}",
    ]


def test_the_name_of_a_link_is_no_joint() -> None:
    (found,) = reported("GAZ021", states("left"))
    assert "looks for joint 'left'" in found.message


def test_joints_that_exist() -> None:
    assert reported("GAZ021", states("left_joint, right_joint")) == []


def test_joints_that_sdf_adds() -> None:
    added = '<gazebo><joint name="spare" type="revolute"/></gazebo>'
    assert reported("GAZ021", states("spare") + added) == []
