"""A link is touched elsewhere than it is seen.

The bounding boxes of its collisions and of its visuals have no more than a third of their volume in
common, as where the `<origin>` of half the height stands in the visual alone. Wheels sink into the
floor or hover, grippers close on nothing, and MoveIt avoids a place that is free while it drives
into what is there. Usually the `<origin>` was written for the visual and forgotten for the
collision; the two do not share it. A collision that is deliberately larger or smaller about the
same place is not meant, nor is a primitive that stands for a part of a mesh.
Where a quarter turn explains it, or a unit, GEO017 and GEO016 say so.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.spatial import Transform
from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.assets.visual_collision import LEAST_OVERLAP
from urdfkit.text.diagnostic import Confidence, Edit, Fix, Related, Severity
from urdfkit.text.editing.edits import insert_first, remove_element

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import Body, Link
    from urdfkit.text.document import Element

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


@rule(
    "GEO004",
    "collision-far-from-visual",
    Severity.WARNING,
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for one in subject.visual_collision_pairs.diagnoses.get("GEO004", ()):
        link = one.link
        why = _why(link) if one.has_one_shape else ""
        wrong, right = _sides(link)
        yield Finding(
            wrong.at,
            f"link '{link.name}': the bounding boxes of collision and visual have only "
            f"{one.overlap:.0%} of their volume in common, less than {LEAST_OVERLAP:.0%}{why}",
            f"give the {wrong.at.tag} the <origin> of the {right.at.tag}",
            _fix(wrong.at, right.at) if why else None,
            (Related(right.at.span, f"the {right.at.tag}"),),
            confidence=Confidence.INFERRED,
            weight=1 - one.overlap,
            alike="moved" if why else "apart",
        )


def _sides(link: Link) -> tuple[Body, Body]:
    """The body that is probably misplaced, and the other one.

    That is the collision, which nobody sees, unless its origin was written for the inertia, too.
    """
    collision, visual = link.collisions[0], link.visuals[0]
    inertial = link.inertial.origin if link.inertial else Transform()
    if Transform() != inertial == collision.origin != visual.origin:
        return visual, collision
    return collision, visual


def _fix(wrong: Element, right: Element) -> Fix | None:
    """The origin of one body for the other, which is the same shape."""
    if wrong.frame is not right.frame:  # expressions mean something else there
        return None
    old, new = wrong.child("origin"), right.child("origin")
    title = f"give the {wrong.tag} the <origin> of the {right.tag}"
    if new is None:
        return Fix(f"remove the <origin> of the {wrong.tag}", remove_element(old)) if old else None
    if old is None:
        return Fix(title, insert_first(wrong, (new.tag_at.whole_span.text,)))
    return Fix(title, (Edit(old.tag_at.whole_span, new.tag_at.whole_span.text),))


def _why(link: Link) -> str:
    """In what the origins of two equal shapes differ."""
    (one,), (other,) = link.collisions, link.visuals
    shift = [b - a for a, b in zip(one.origin.position, other.origin.position, strict=True)]
    parts = []
    if one.origin.rotation != other.origin.rotation:
        parts.append("turned")
    if any(shift):
        parts.append("moved by {:.3g} {:.3g} {:.3g} m".format(*shift))
    return f"; the visual is the same shape, {' and '.join(parts)}"
