"""COL006: see the rule."""

from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("coal")

from tests.physics.collision.robots import box, cube, joint, link, mesh
from tests.reported import messages, places


def wheel(inside: float, shape: str = box(0.2, 0.04, 0.2), kind: str = "continuous") -> str:
    """A wheel 0.04 m wide, as far inside a chassis 0.4 m wide, and lower than it."""
    return "\n".join(
        (
            link("chassis", box(0.6, 0.4, 0.1)),
            link("wheel", shape),
            joint("chassis", "wheel", kind, f"0.2 {0.22 - inside} -0.05"),
        )
    )


def test_the_depth_and_the_wheel() -> None:
    assert messages("COL006", wheel(0.035)) == [
        "link 'wheel' overlaps its neighbour 'chassis' by 35 mm, 88% of its thickness"
    ]
    assert places("COL006", wheel(0.035)) == [(3, "<collision>")]


@pytest.mark.parametrize("inside", [-0.01, 0.0, 0.01, 0.02])
def test_half_a_wheel_in_the_chassis_is_no_matter(inside: float) -> None:
    assert messages("COL006", wheel(inside)) == []


def test_what_is_fixed_is_no_matter() -> None:
    assert messages("COL006", wheel(0.035, kind="fixed")) == []


def test_the_depth_of_surfaces_is_not_trusted(tmp_path: Path) -> None:
    solid = mesh(cube(tmp_path / "solid.stl", 0.02))
    assert len(messages("COL006", wheel(0.035, solid).replace("-0.05", "-0.04"))) == 1
    hollow = mesh(cube(tmp_path / "hollow.stl", 0.02, 5))
    assert messages("COL006", wheel(0.035, hollow).replace("-0.05", "-0.04")) == []
