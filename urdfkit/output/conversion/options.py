"""Options of a conversion."""

from __future__ import annotations

from urdfkit.core.record import Record
from urdfkit.ros.moveit.srdf import Srdf

#: Base of the robot: welded to the world, or floating.
BASES = ("auto", "fixed", "free")
#: Links of fixed joints: separate bodies, or parts of their parents.
FIXED = ("keep", "merge")
#: Replacement of a collision mesh: its convex hull, convex pieces, or the shapes of
#: ``urdfkit mesh collision``.
COLLISIONS = ("hull", "decompose", "primitives")
#: Pairs of links that do not collide: pairs that the SRDF disables, or that
#: ``urdfkit collisions`` finds.
EXCLUSIONS = ("srdf", "computed")


class ConversionOptions(Record):
    """The chosen options."""

    base: str = "auto"
    fixed: str = "keep"
    collision: str = "hull"
    exclude: str = "srdf"
    visuals: bool = True  # False for a simulation, which needs no visuals
    srdf: Srdf | None = None  # replaces the SRDF of the robot's package
