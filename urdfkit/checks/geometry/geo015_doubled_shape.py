"""A link has the same shape twice at the same place.

The second one is drawn into the first and checked for collisions again, and changes nothing else
until somebody moves one of the two. Usually a block was copied and not changed.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Related, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import Body

_SHAPE = """\
  <collision>
    <origin xyz="{x} 0 0"/>
    <geometry><box size="0.1 0.1 0.1"/></geometry>
  </collision>
"""
BAD = f"""\
<link name="base">
{_SHAPE.format(x=0.1)}{_SHAPE.format(x=0.1)}</link>"""
GOOD = f"""\
<link name="base">
{_SHAPE.format(x=0.1)}{_SHAPE.format(x=-0.1)}</link>"""


@rule("GEO015", "doubled-shape", Severity.INFO, help="move one of the two, or remove it")
def check(subject: Subject) -> Iterator[Finding]:
    for link in subject.model.links:
        for bodies in (link.visuals, link.collisions):
            first: dict[tuple[object, ...], Body] = {}
            for body in bodies:
                if body.shape is None:
                    continue
                other = first.setdefault(_form(body), body)
                if other is not body:
                    yield Finding(
                        body.at,
                        f"link '{link.name}' has the same {body.at.tag} twice at one place",
                        related=(Related(other.at.span, "the first one"),),
                    )


def _form(body: Body) -> tuple[object, ...]:
    """What and where a shape is."""
    assert body.shape is not None
    shape = body.shape
    name = shape.filename.value if shape.filename else ""
    return (shape.kind, shape.size, shape.radius, shape.length, name, shape.scale, body.origin)
