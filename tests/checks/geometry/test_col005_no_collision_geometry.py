"""COL005: see the rule."""

from __future__ import annotations

import pytest

from tests.physics.collision.robots import box, joint, link
from tests.reported import messages

MASS = '<inertial><mass value="{}"/></inertial>'
BASE = link("base", box(1, 1, 1))
VISUAL = f"<visual><geometry>{box(1, 1, 1)}</geometry></visual>"


def bare(mass: float, more: str = "") -> str:
    return f'<link name="arm">{MASS.format(mass)}{more}</link>'


def test_the_mass_is_told() -> None:
    assert messages("COL005", BASE + bare(0.5) + joint("base", "arm", "continuous")) == [
        "link 'arm' moves, weighs 0.5 kg, and has no shape"
    ]


@pytest.mark.parametrize(
    "text",
    [
        BASE + bare(0.5) + joint("base", "arm"),  # it does not move
        BASE + bare(0.0005) + joint("base", "arm", "continuous"),
        BASE + bare(0.5, VISUAL) + joint("base", "arm", "continuous"),  # GEO002
        link("base") + bare(0.5) + joint("base", "arm", "continuous"),  # no link has any
        BASE
        + bare(0.5)
        + link("hand", box(1, 1, 1))
        + joint("base", "arm", "continuous")
        + joint("arm", "hand"),
        BASE
        + bare(0.5)
        + link("hand", box(1, 1, 1))
        + joint("base", "arm", "continuous")
        + joint("arm", "hand", "continuous"),  # a cross of two axes
    ],
)
def test_what_has_a_shape_or_a_reason_is_no_matter(text: str) -> None:
    assert messages("COL005", text) == []
