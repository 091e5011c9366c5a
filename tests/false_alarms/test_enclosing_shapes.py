"""COL004 is about bodies that are hidden by accident, not about shapes made to enclose others."""

import pytest

pytest.importorskip("coal")

from tests.naming import naming
from tests.physics.collision.robots import box, cylinder, joint, revolute, sphere
from tests.reported import messages

PALM = box(0.1, 0.1, 0.05)


def visual(shape: str, alpha: float = 1) -> str:
    material = f'<material name="red_{alpha}"><color rgba="1 0 0 {alpha}"/></material>'
    return f"<visual><geometry>{shape}</geometry>{material}</visual>"


def collision(shape: str) -> str:
    return f"<collision><geometry>{shape}</geometry></collision>"


def gripper(envelope: str) -> str:
    """A hand with a finger that slides in it, and a link fixed to the hand that holds both."""
    return "".join(
        (
            f'<link name="hand">{visual(PALM) + collision(PALM)}</link>',
            f'<link name="finger">{visual(sphere(0.01)) + collision(sphere(0.01))}</link>',
            f'<link name="hand_sc">{envelope}</link>',
            joint("hand", "finger", "prismatic", "0 0 0.05", revolute(0, 0.04, "1 0 0")),
            joint("hand", "hand_sc"),
        )
    )


def test_a_capsule_for_self_collision_is_no_matter() -> None:
    """Franka's ``fr3_hand_sc``: not drawn, fixed to the hand."""
    assert messages("COL004", gripper(collision(cylinder(0.12, 0.3)))) == []


def test_a_transparent_safety_box_is_no_matter() -> None:
    shape = box(0.3, 0.3, 0.3)
    assert messages("COL004", gripper(visual(shape, 0.3) + collision(shape))) == []


def test_a_housing_that_is_drawn_is_reported() -> None:
    shape = box(0.3, 0.3, 0.3)
    (found,) = messages("COL004", gripper(visual(shape) + collision(shape)))
    assert found == naming("finger", "inside", "collision", "hand_sc")
    bare = f"<visual><geometry>{shape}</geometry></visual>"
    assert len(messages("COL004", gripper(bare + collision(shape)))) == 1


def test_a_link_that_is_not_drawn_and_stands_alone_is_reported() -> None:
    """Nothing else is the body that it is around."""
    alone = gripper(collision(box(0.3, 0.3, 0.3))).replace(visual(PALM), "")
    assert len(messages("COL004", alone)) == 1


def test_no_overlap_is_over_100_percent() -> None:
    """COL001: a rod of 20 mm that stands through a plate, pushed out along it."""
    parts = (
        f'<link name="plate">{collision(box(0.5, 0.5, 0.5))}</link>',
        f'<link name="rod">{collision(box(0.02, 0.02, 0.8))}</link>',
        joint("plate", "rod", "continuous"),
    )
    assert messages("COL001", "".join(parts)) == [naming("rod", "plate", "260 mm")]


@pytest.mark.parametrize(("size", "count"), [("0", 0), ("0.001", 1)])
def test_a_shape_without_a_size_is_none(size: str, count: int) -> None:
    """Reachy's antennas have a cylinder of no length and no radius in the head."""
    antenna = collision(f'<cylinder radius="{size}" length="{size}"/>')
    parts = (
        f'<link name="head">{visual(PALM)}{collision(box(0.1, 0.1, 0.1))}</link>',
        f'<link name="antenna">{antenna}</link>',
        joint("head", "antenna", "continuous"),
    )
    assert len(messages("COL004", "".join(parts))) == count


def test_a_shape_of_a_micrometre_is_no_matter() -> None:
    """DAVE's sonars: a collision that Gazebo wants, and that is to touch nothing."""
    robot = "".join(
        (
            f'<link name="hand">{visual(PALM) + collision(PALM)}</link>',
            f'<link name="sonar">{collision(cylinder(1e-6, 1e-6))}</link>',
            joint("hand", "sonar", "revolute", "0 0 0", revolute(0, 0.1, "1 0 0")),
        )
    )
    assert messages("COL004", robot) == []
