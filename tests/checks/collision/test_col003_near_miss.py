"""COL003: see the rule."""

from __future__ import annotations

import pytest

pytest.importorskip("coal")

from tests.physics.collision.robots import box, joint, link, revolute
from tests.reported import messages

CUBE = box(0.1, 0.1, 0.1)


def drop(gap: float, limits: str) -> str:
    """A cube above another one; what holds it is to the side."""
    return "\n".join(
        (
            link("base", CUBE),
            link("post", f"{CUBE}@0.5 0 0"),
            link("drop", CUBE),
            joint("base", "post"),
            joint("post", "drop", "prismatic", f"0 0 {0.1 + gap}", limits),
        )
    )


def test_at_zero() -> None:
    assert messages("COL003", drop(0.0005, revolute(0, 0.1, "0 0 1"))) == [
        "links 'base' and 'drop' come within 0.5 mm at zero"
    ]


def test_at_a_limit() -> None:
    assert messages("COL003", drop(0.0008, revolute(-0.0005, 0.1, "0 0 1"))) == [
        "links 'base' and 'drop' come within 0.3 mm at post_drop -0.0005"
    ]


@pytest.mark.parametrize("gap", [0.0, 0.0015, -0.01])
def test_touching_overlapping_and_clear_ones_are_no_matter(gap: float) -> None:
    assert messages("COL003", drop(gap, revolute(0, 0.1, "0 0 1"))) == []


def test_a_collision_at_another_limit_is_none() -> None:
    assert messages("COL003", drop(0.0005, revolute(-0.05, 0.1, "0 0 1"))) == []
