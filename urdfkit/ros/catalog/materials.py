"""Materials that Gazebo knows by name."""

from __future__ import annotations

from functools import cache

from urdfkit.core.record import Record
from urdfkit.ros.catalog import data, record


class GazeboMaterial(Record):
    """A material script of Gazebo."""

    name: str  # as a model must write it
    #: A colour for it, each from 0 to 1; None where it has none.
    rgba: tuple[float, ...] | None = None
    kind: str = ""  # ``textured``, or empty
    internal: bool = False  # True if it is for the renderer itself
    #: The colour that gz-sim 7 and later draw instead; None if it is the same.
    gz_diffuse: tuple[float, ...] | None = None

    @property
    def is_textured(self) -> bool:
        """True if it is an image, which gz-sim does not draw."""
        return self.kind == "textured"


@cache
def materials() -> dict[str, GazeboMaterial]:
    """The materials by name; upper and lower case matter."""
    facts = data("materials")["materials"]
    return {name: record(GazeboMaterial, fact, name=name) for name, fact in facts.items()}
