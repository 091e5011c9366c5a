"""An element stands twice where readers take one.

urdfdom (RViz, MoveIt, Gazebo, Pinocchio), Drake and PyBullet take the first and pass over the
second without a word; MuJoCo refuses the file. A `<geometry>` holds one shape, an `<inertial>` one
mass. Remove the one that is not meant, or put a second shape into a visual or collision of its own.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.diagnostic import Related, Severity
from urdfkit.document import Element
from urdfkit.grammar import owner
from urdfkit.rules import Finding, rule
from urdfkit.schema import SHAPES

if TYPE_CHECKING:
    from urdfkit.subject import Subject

BAD = """\
<link name="base">
  <collision>
    <geometry>
      <box size="0.4 0.3 0.1"/>
      <sphere radius="0.1"/>
    </geometry>
  </collision>
</link>"""
GOOD = """\
<link name="base">
  <collision>
    <geometry><box size="0.4 0.3 0.1"/></geometry>
  </collision>
  <collision>
    <geometry><sphere radius="0.1"/></geometry>
  </collision>
</link>"""


@rule(
    "URD007",
    "duplicate-element",
    Severity.WARNING,
    help="remove the one that is not meant",
)
def check(subject: Subject) -> Iterator[Finding]:
    for element, *_ in subject.deviations.get("URD007", ()):
        assert element.parent is not None
        first = _first(element, element.parent)
        who, place = owner(element.parent), element.parent.tag
        if first.tag == element.tag:
            message = f"{who}: a second <{element.tag}> in <{place}>; readers take the first"
        else:
            message = f"{who}: <{element.tag}> after <{first.tag}> in one <{place}>; readers take "
            message += "the first shape"
        yield Finding(element, message, related=(Related(first.span, "the first"),))


def _first(element: Element, parent: Element) -> Element:
    """The one that readers take."""
    alternatives = SHAPES if parent.tag == "geometry" else (element.tag,)
    return next(child for child in parent.children if child.tag in alternatives)
