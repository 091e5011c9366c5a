"""How much work a picture is worth."""

from __future__ import annotations

from typing import NamedTuple


class Quality(NamedTuple):
    """How much work a picture is worth.

    Attributes:
        samples: of a pixel, for smooth edges.
        sky, sun: samples of what hides the sky and the sun; none are taken for 0.
    """

    samples: int
    sky: int
    sun: int


QUALITIES = {
    "draft": Quality(3, 0, 4),
    "default": Quality(6, 16, 10),
    "high": Quality(16, 32, 16),
}
