"""Shapes and colours of visuals and collisions."""

from __future__ import annotations

from urdfkit.lint.context import Subject

#: Former codes and names, and the rules that report their findings now.
REDIRECTS = {
    "colour-out-of-range": "GEO007", "GEO010": "GEO007", "invisible-visual": "GEO007",
    "invisible": "GEO007",
    "GEO006": "GEO001", "negative-scale": "GEO001",
    "negative-size": "GEO001", "GEO005": "GEO001", "zero-scale": "GEO001", "GEO012": "GEO001",
    "zero-size": "GEO001",
    "visual-without-collision": "GEO002", "GEO003": "GEO002", "collision-without-visual": "GEO002",
    "GEO008": "GEO002", "no-geometry-robot": "GEO002", "COL005": "GEO002",
    "no-collision-geometry": "GEO002",
    "collision-far-from-visual": "GEO004", "GEO014": "GEO004", "radius-is-diameter": "GEO004",
    "GEO016": "GEO004", "sizes-differ": "GEO004", "GEO017": "GEO004",
    "turned-against-collision": "GEO004",

    "GEO015": "", "doubled-shape": "", "GEO018": "", "sensor-inside-a-body": "",
}  # fmt: skip


def applies(subject: Subject) -> bool:
    """True for a document with a robot in it."""
    return bool(subject.model.links)
