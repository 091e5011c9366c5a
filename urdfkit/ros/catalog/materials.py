"""Material scripts of Gazebo."""

from __future__ import annotations

from functools import cache

from urdfkit.core.record import Record
from urdfkit.ros.catalog import data, record


class GazeboMaterial(Record):
    """A material script of Gazebo."""

    name: str  # case-sensitive
    #: Its colour, components from 0 to 1; None without a colour.
    rgba: tuple[float, ...] | None = None
    kind: str = ""  # ``textured``, or empty
    internal: bool = False  # True if only the renderer uses it
    #: The colour that gz-sim 7 and later draw instead; None if it is the same.
    gz_diffuse: tuple[float, ...] | None = None

    @property
    def is_textured(self) -> bool:
        """True if it has a texture, which gz-sim does not draw."""
        return self.kind == "textured"


@cache
def materials() -> dict[str, GazeboMaterial]:
    """The materials by name."""
    facts = data("materials")["materials"]
    return {name: record(GazeboMaterial, fact, name=name) for name, fact in facts.items()}
