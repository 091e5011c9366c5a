"""How a robot is converted."""

from __future__ import annotations

from urdfkit.core.record import Record

#: What becomes of the root link.
BASES = ("auto", "fixed", "free")
#: What becomes of the links of fixed joints: bodies of their own, or parts of their parents.
FIXED = ("keep", "merge")
#: What becomes of a collision mesh: its convex hull, convex pieces of it, or what
#: ``urdfkit mesh collision`` takes for it.
COLLISIONS = ("hull", "decompose", "primitives")
#: Which pairs of links do not collide: those that the SRDF disables, or those that
#: ``urdfkit collisions`` finds.
EXCLUSIONS = ("srdf", "computed")


class ConversionOptions(Record):
    """One of each of the above."""

    base: str = "auto"
    fixed: str = "keep"
    collision: str = "hull"
    exclude: str = "srdf"
    visuals: bool = True  # False for a simulation, which needs none
