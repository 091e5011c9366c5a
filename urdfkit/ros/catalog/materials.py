"""Materials that Gazebo knows by name."""

from __future__ import annotations

from functools import cache

from urdfkit.core.record import Record
from urdfkit.ros.catalog import data


class GazeboMaterial(Record):
    """A material script of Gazebo.

    Attributes:
        name: as a model must write it.
        rgba: a colour for it, each from 0 to 1; None where it has none.
        textured: True if it is an image, which gz-sim does not draw.
        internal: True if it is for the renderer itself.
        gz_rgb: the colour that gz-sim 7 and later draw instead; None if it is the same.
    """

    name: str
    rgba: tuple[float, ...] | None
    textured: bool
    internal: bool
    gz_rgb: tuple[float, ...] | None


@cache
def materials() -> dict[str, GazeboMaterial]:
    """The materials by name; upper and lower case matter."""
    found: dict[str, GazeboMaterial] = {}
    for name, fact in data("materials")["materials"].items():
        rgba, other = fact.get("rgba"), fact.get("gz_diffuse")
        found[name] = GazeboMaterial(
            name,
            tuple(rgba) if rgba else None,
            fact.get("kind") == "textured",
            fact.get("internal", False),
            tuple(other) if other else None,
        )
    return found
