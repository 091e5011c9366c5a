"""A link is touched elsewhere than it is seen.

The bounding boxes of its collisions and of its visuals have less than a third of their volume in
common. Wheels sink into the floor or hover, grippers close on nothing, and MoveIt avoids a place
that is free while it drives into what is there. Usually the `<origin>` was written for the visual
and forgotten for the collision; the two do not share it. A collision that is deliberately larger or
smaller about the same place is not meant, nor is a primitive that stands for a part of a mesh.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.diagnostic import Confidence, Edit, Fix, Related, Severity
from urdfkit.editing.edits import insert_first, remove_element
from urdfkit.mechanics.shapes import Box, Lump, Solid, solid
from urdfkit.rules import Finding, rule
from urdfkit.static import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.model import Link, Shape
    from urdfkit.subject import Subject

BAD = """\
<link name="base">
  <visual>
    <origin rpy="0 0 1.5707963267948966" xyz="0 0 0.05"/>
    <geometry><box size="0.2 0.3 0.1"/></geometry>
  </visual>
  <collision>
    <geometry><box size="0.2 0.3 0.1"/></geometry>
  </collision>
</link>"""
GOOD = BAD.replace(
    "<collision>", '<collision>\n    <origin rpy="0 0 1.5707963267948966" xyz="0 0 0.05"/>'
)
FIXED = GOOD

#: Common volume by the volume of both bounding boxes together.
LEAST_OVERLAP = 1 / 3

#: A box with this part of its volume within the other one is larger or smaller on purpose.
NESTED = 0.9

#: Shapes with no edge over this, in m, mark a place.
MARKER = 0.005


@rule(
    "GEO004",
    "collision-far-from-visual",
    Severity.WARNING,
    help="give the collision the <origin> of the visual",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for link in subject.model.links:
        if not (link.visuals and link.collisions):
            continue
        touched, seen = (solid(bodies, subject.lump) for bodies in (link.collisions, link.visuals))
        if touched is None or seen is None or touched.parts == seen.parts:
            continue
        overlap = _overlap(touched.bounds, seen.bounds)
        if overlap is not None and not _is_likeness(link, touched, seen):
            yield Finding(
                link.collisions[0].at,
                f"link '{link.name}': the bounding boxes of collision and visual have only "
                f"{overlap:.0%} of their volume in common, less than {LEAST_OVERLAP:.0%}"
                f"{_why(link)}",
                fix=_fix(link) if _why(link) else None,
                related=(Related(link.visuals[0].at.span, "the visual"),),
                confidence=Confidence.INFERRED,
                weight=1 - overlap,
            )


def _fix(link: Link) -> Fix | None:
    """The origin of the visual for the collision, which is the same shape."""
    collision, visual = link.collisions[0].at, link.visuals[0].at
    if collision.frame is not visual.frame:  # expressions mean something else there
        return None
    old, new = collision.child("origin"), visual.child("origin")
    title = "give the collision the <origin> of the visual"
    if new is None:
        return Fix("remove the <origin> of the collision", remove_element(old)) if old else None
    if old is None:
        return Fix(title, insert_first(collision, (new.tag_at.whole_span.text,)))
    return Fix(title, (Edit(old.tag_at.whole_span, new.tag_at.whole_span.text),))


def _overlap(touched: Box, seen: Box) -> float | None:
    """The common volume by that of both together; None if that is as it may be."""
    if max(touched.edges) <= MARKER or max(seen.edges) <= MARKER:
        return None
    common = touched.common_volume(seen)
    overlap = common / (touched.volume + seen.volume - common)
    nested = common >= NESTED * min(touched.volume, seen.volume)
    return None if nested or overlap >= LEAST_OVERLAP else overlap


def _is_likeness(link: Link, touched: Solid, seen: Solid) -> bool:
    """True if primitives may stand for a mesh, or for a part of it, though not well.

    Makers of legs give a hip the cylinder of the motor beside it: that is no slip. The same mesh at
    another place is one, and so are shapes that are farther apart than they are long.
    """
    if not any(isinstance(part, Lump) for part in (*touched.parts, *seen.parts)) or _why(link):
        return False
    one, other = touched.bounds, seen.bounds
    gap = max(max(a - d, c - b) for a, b, c, d in zip(*one, *other, strict=True))
    return gap <= max(*one.edges, *other.edges)


def _why(link: Link) -> str:
    """In what the origins of two equal shapes differ."""
    if len(link.collisions) != 1 or len(link.visuals) != 1:
        return ""
    (one,), (other,) = link.collisions, link.visuals
    if one.shape is None or other.shape is None or _form(one.shape) != _form(other.shape):
        return ""
    shift = [b - a for a, b in zip(one.origin.position, other.origin.position, strict=True)]
    parts = []
    if one.origin.rotation != other.origin.rotation:
        parts.append("turned")
    if any(shift):
        parts.append("moved by {:.3g} {:.3g} {:.3g} m".format(*shift))
    return f"; the visual is the same shape, {' and '.join(parts)}"


def _form(shape: Shape) -> tuple[object, ...]:
    """What a shape is, wherever it is."""
    name = shape.filename.value if shape.filename else ""
    return (shape.kind, shape.size, shape.radius, shape.length, name, shape.scale)
