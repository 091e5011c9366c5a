"""GAZ066: see the rule."""

import pytest

from tests.gazebos import BASE, BODY, block, child
from tests.reported import messages

KEEP = block("<preserveFixedJoint>true</preserveFixedJoint>", "tip_joint")


@pytest.mark.parametrize("tag", ["preserveFixedJoint", "disableFixedJointLumping"])
def test_a_link_without_mass_is_dropped_all_the_same(tag: str) -> None:
    robot = BASE + child("tip", "fixed", inside="") + KEEP.replace("preserveFixedJoint", tag)
    assert messages("GAZ066", robot) == [
        "joint 'tip_joint' is kept, and its link 'tip' has no mass: Gazebo leaves out both"
    ]


@pytest.mark.parametrize(
    ("kind", "inside", "keep"),
    [
        ("fixed", BODY, KEEP),
        ("fixed", "", KEEP.replace("true", "false")),
        ("continuous", "", KEEP),  # INE004
        ("fixed", "", ""),
    ],
)
def test_others_are_calm(kind: str, inside: str, keep: str) -> None:
    assert messages("GAZ066", BASE + child("tip", kind, inside=inside) + keep) == []


def test_what_is_merged_into_the_link_gives_it_mass() -> None:
    robot = BASE + child("tip", "fixed", inside="") + child("end", "fixed", parent="tip")
    assert messages("GAZ066", robot + KEEP) == []
