"""The radius of a shape is exactly twice that of the same shape beside it.

A cylinder of the visual and one of the collision lie at the same place and have the same length,
and one has the diameter where the other has the radius. A wheel is then seen twice as large as it
rolls, or the other way round.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Confidence, Related, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import Body

BAD = """\
<link name="wheel">
  <visual>
    <geometry><cylinder radius="0.1" length="0.04"/></geometry>
  </visual>
  <collision>
    <geometry><cylinder radius="0.2" length="0.04"/></geometry>
  </collision>
</link>"""
GOOD = BAD.replace("0.2", "0.1")


@rule("GEO014", "radius-is-diameter", Severity.INFO, help="write the radius in both")
def check(subject: Subject) -> Iterator[Finding]:
    for link in subject.model.links:
        if len(link.visuals) != 1 or len(link.collisions) != 1:
            continue
        seen, touched = link.visuals[0], link.collisions[0]
        first, second = _radius(seen, touched), _radius(touched, seen)
        if first and second and abs(max(first, second) / min(first, second) - 2) < 1e-6:
            large, small = (seen, touched) if first > second else (touched, seen)
            assert large.shape is not None
            yield Finding(
                large.shape.at,
                f"link '{link.name}': the radius of the {large.at.tag}, {max(first, second):g} m, "
                f"is twice that of the {small.at.tag}, {min(first, second):g} m",
                related=(Related(small.at.span, f"the {small.at.tag}"),),
                confidence=Confidence.INFERRED,
            )


def _radius(body: Body, other: Body) -> float | None:
    """Of a shape that is like the other in all but the radius."""
    one, two = body.shape, other.shape
    if one is None or two is None or one.kind != two.kind or one.length != two.length:
        return None
    return one.radius if body.origin == other.origin else None
