"""Joints: their frames, limits and mimics, with source locations.

Parsing is tolerant: a value that cannot be parsed is None here, and the grammar rules report it,
so that one bad number does not hide the rest. Units are those of URDF: m, rad, kg, N and N·m.
"""

from __future__ import annotations

from urdfkit.core.record import Record
from urdfkit.core.spatial import Transform, Vector
from urdfkit.robot.origin import read_origin
from urdfkit.robot.placed import Placed, placed_number, placed_text
from urdfkit.robot.values import number, vector
from urdfkit.text.document import Element

#: By joint type; a planar joint has two translations and a rotation.
DEGREES_OF_FREEDOM = {"revolute": 1, "continuous": 1, "prismatic": 1, "planar": 3, "floating": 6}
#: Types of joints with one coordinate, an angle or a distance.
SINGLE_DOF = ("revolute", "continuous", "prismatic")


class Limit(Record):
    """``<limit>``: position in rad or m, effort in N·m or N, velocity in rad/s or m/s."""

    at: Element
    lower: Placed[float] | None
    upper: Placed[float] | None
    effort: Placed[float] | None
    velocity: Placed[float] | None

    @property
    def ends(self) -> tuple[float, float]:
        """The lower and the upper limit; 0 if it is missing or unreadable, as in urdfdom."""
        lower, upper = (end.value if end else 0.0 for end in (self.lower, self.upper))
        return lower, upper


class Mimic(Record):
    """``<mimic>``: position = multiplier * position of the leader + offset."""

    at: Element
    joint: Placed[str] | None
    multiplier: float
    offset: float


class Joint(Record):
    """``<joint>``; ``axis`` is None if it is not written (the default in URDF is x)."""

    at: Element
    name: str
    type: Placed[str] | None
    parent: Placed[str] | None
    child: Placed[str] | None
    origin: Transform
    axis: Placed[Vector] | None
    limit: Limit | None
    mimic: Mimic | None

    @property
    def kind(self) -> str:
        """The type as written; empty if it is missing."""
        return self.type.value if self.type else ""

    @property
    def is_rotational(self) -> bool:
        """True if its position is an angle."""
        return self.kind in ("revolute", "continuous")

    @property
    def is_prismatic(self) -> bool:
        return self.kind == "prismatic"

    @property
    def is_single_dof(self) -> bool:
        """True if its position is one number, in rad or m; also for a mimic joint."""
        return self.kind in SINGLE_DOF

    @property
    def unit(self) -> str:
        """The unit of its position."""
        return "m" if self.is_prismatic else "rad"

    @property
    def effort_unit(self) -> str:
        return "N" if self.is_prismatic else "N·m"

    @property
    def parent_name(self) -> str:
        """Name of the parent link; empty if it is missing."""
        return self.parent.value if self.parent else ""

    @property
    def child_name(self) -> str:
        """Name of the child link; empty if it is missing."""
        return self.child.value if self.child else ""

    @property
    def leader(self) -> str:
        """Name of the joint that it mimics; empty without ``<mimic>``."""
        return self.mimic.joint.value if self.mimic and self.mimic.joint else ""

    @property
    def degrees_of_freedom(self) -> int:
        """Number of independent coordinates; 0 for a mimic joint."""
        return 0 if self.mimic else DEGREES_OF_FREEDOM.get(self.kind, 0)


def read_joint(element: Element) -> Joint:
    """The joint of a ``<joint>``."""
    axis, limit, mimic = (element.child(tag) for tag in ("axis", "limit", "mimic"))
    xyz = axis.attributes.get("xyz") if axis else None
    direction = vector(xyz.value) if xyz else None
    return Joint(
        element,
        element.get("name") or "",
        placed_text(element, "type"),
        placed_text(element.child("parent"), "link"),
        placed_text(element.child("child"), "link"),
        read_origin(element),
        Placed(direction, xyz) if xyz and direction else None,
        _limit(limit) if limit else None,
        _mimic(mimic) if mimic else None,
    )


def _limit(element: Element) -> Limit:
    keys = ("lower", "upper", "effort", "velocity")
    return Limit(element, *(placed_number(element, key) for key in keys))


def _mimic(element: Element) -> Mimic:
    multiplier = number(element.get("multiplier"))
    return Mimic(
        element,
        placed_text(element, "joint"),
        1.0 if multiplier is None else multiplier,
        number(element.get("offset")) or 0.0,
    )
