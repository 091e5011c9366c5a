"""JNT037: a camera on top of a robot may have the base for its parent, as those of wpr robots."""

import pytest

from tests.massive import joint, link, shape
from tests.reported import messages

SMALL = shape("visual", '<box size="0.01 0.01 0.01"/>')
TORSO = shape("visual", '<box size="0.3 0.3 1.2"/>', xyz="0 0 0.7")
CAMERA = link("camera", SMALL) + joint("base", "camera", xyz="0 0 1.37")


@pytest.mark.parametrize(
    ("between", "count"),
    [
        (link("torso", TORSO) + joint("base", "torso"), 0),  # merged with the base
        (
            link("torso", shape("visual", '<mesh filename="torso.stl"/>')) + joint("base", "torso"),
            0,
        ),
        (link("torso", TORSO) + joint("base", "torso", "revolute"), 1),  # which may turn away
        (link("torso") + joint("base", "torso"), 1),
        ("", 1),
    ],
)
def test_what_fixed_joints_merge_with_the_parent(between: str, count: int) -> None:
    assert len(messages("JNT037", link("base", SMALL) + between + CAMERA)) == count


def test_what_is_merged_with_the_child() -> None:
    mast = link("mast", shape("visual", '<box size="0.1 0.1 1.3"/>', xyz="0 0 -0.7"))
    robot = link("base", SMALL) + CAMERA
    assert messages("JNT037", robot + mast + joint("camera", "mast")) == []
    assert len(messages("JNT037", robot + link("mast", SMALL) + joint("camera", "mast"))) == 1


@pytest.mark.parametrize(("root", "count"), [("world", 0), ("footprint", 1)])
def test_a_camera_above_an_arm_that_is_fixed_to_the_world(root: str, count: int) -> None:
    """An arm of a course: its camera is mounted on the ceiling, and has the base for its parent."""
    robot = link(root) + link("base", SMALL) + joint(root, "base")
    assert len(messages("JNT037", robot + CAMERA)) == count
