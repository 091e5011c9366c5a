"""COL002: see the rule."""

from __future__ import annotations

import pytest

pytest.importorskip("coal")

from tests.physics.collision.robots import box, cylinder, joint, link, revolute, sphere
from tests.reported import messages

NECK = '<axis xyz="0 0 1"/>'


def body(head: str, more: str = NECK, kind: str = "continuous") -> str:
    return "\n".join(
        (
            link("body", cylinder(0.2, 0.6)),
            link("leg", box(0.1, 0.2, 0.6)),
            link("head", head),
            joint("body", "leg", origin="0 0.22 0.15"),
            joint("body", "head", kind, "0 0 0.3", more),
        )
    )


def test_a_ball_that_turns_in_place() -> None:
    """The leg begins 0.12 m from the axis of the head and ends 0.15 m above its middle."""
    (message,) = messages("COL002", body(sphere(0.2)))
    assert message.startswith("links 'head' and 'leg' overlap in every pose, by ")
    assert float(message.split()[9]) == pytest.approx(80, abs=0.1)


def test_a_box_that_turns_away_is_no_matter() -> None:
    assert messages("COL002", body(box(0.1, 0.3, 0.2))) == []


def test_a_limit_that_parts_them() -> None:
    lifted = revolute(0, 0.5)
    assert messages("COL002", body(sphere(0.2), lifted, "prismatic")) == []
    low = revolute(0, 0.05)
    assert len(messages("COL002", body(sphere(0.2), low, "prismatic"))) == 1
