"""GAZ069: see the rule."""

import pytest

from tests.gazebos import BASE, block, child
from tests.reported import fixed, messages

OLD = block("<disableFixedJointLumping>true</disableFixedJointLumping>", "tip_joint")
TIP = child("tip", "fixed")


def test_the_older_tag_makes_a_joint_that_turns() -> None:
    assert messages("GAZ069", BASE + TIP + OLD) == [
        "joint 'tip_joint' becomes a revolute joint in Gazebo, which gives way under load"
    ]
    assert "<preserveFixedJoint>true</preserveFixedJoint>" in fixed("GAZ069", BASE + TIP + OLD)


@pytest.mark.parametrize(
    ("robot", "tags"),
    [
        (TIP, OLD.replace("true", "false")),
        (TIP, OLD + block("<preserveFixedJoint>true</preserveFixedJoint>", "tip_joint")),
        (child("tip"), OLD),
    ],
)
def test_others_are_calm(robot: str, tags: str) -> None:
    assert messages("GAZ069", BASE + robot + tags) == []
