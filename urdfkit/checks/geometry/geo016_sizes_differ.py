"""A link is seen many times as large as it is touched, or as small.

The visual is at least five times as long, as wide and as high as the collision, or the other way
round; for two meshes, half as large again is enough where all three edges say the same. One of the
two has the wrong unit: a mesh in millimetres or inches without its `scale`, one with a scale that
it does not need, a radius in centimetres. A collision that is too large knocks the robot about and
lets no planner find a way; one that is too small is never touched.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    measured: of 579 public robots, nine have such a link, eight of them by a scale.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Confidence, Related, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.shapes import BoundingBox

BAD = """\
<link name="base">
  <visual>
    <geometry><box size="300 200 100"/></geometry>
  </visual>
  <collision>
    <geometry><box size="0.3 0.2 0.1"/></geometry>
  </collision>
</link>"""
GOOD = BAD.replace("300 200 100", "0.3 0.2 0.1")

#: Factors between units of length, and what they are made of.
_UNITS = {
    1000.0: "millimetres taken for metres",
    100.0: "centimetres taken for metres",
    39.37: "inches taken for metres",
    25.4: "inches taken for millimetres, or the other way round",
    10.0: "a decimal point",
}
#: A factor is that of two units if it is this near to it: visual and collision are rarely equal.
_NEAR = 1.08


@rule(
    "GEO016",
    "sizes-differ",
    Severity.WARNING,
    help="correct the scale or the size of the one that is wrong",
)
def check(subject: Subject) -> Iterator[Finding]:
    visual_collision_pairs = subject.visual_collision_pairs
    for one in visual_collision_pairs.diagnoses.get("GEO016", ()):
        assert one.factor
        larger, smaller = ("visual", "collision") if one.factor > 1 else ("collision", "visual")
        factor = max(one.factor, 1 / one.factor)
        wrong = one.unusual(visual_collision_pairs.span)
        is_visual = wrong is one.link.visuals[0]
        other = one.link.collisions[0] if is_visual else one.link.visuals[0]
        yield Finding(
            wrong.shape.at if wrong.shape else wrong.at,
            f"link '{one.link.name}': the {larger} is {_times(factor)} times as large as the "
            f"{smaller}{_unit(factor)}; they are {_edges(one.seen.bounds)} (visual) and "
            f"{_edges(one.touched.bounds)} (collision)",
            related=(Related(other.at.span, "the collision" if is_visual else "the visual"),),
            confidence=Confidence.INFERRED,
            weight=factor,
        )


def _unit(factor: float) -> str:
    """Which units were confused, if the factor is that of two."""
    reported = (why for f, why in _UNITS.items() if f / _NEAR < factor < f * _NEAR)
    why = next(reported, "")
    return f", as by {why}" if why else ""


def _times(factor: float) -> str:
    return f"{factor:.3g}" if factor < 999.5 else f"{factor:.0f}"


def _edges(box: BoundingBox) -> str:
    return " x ".join(f"{edge:.3g}" for edge in box.edges) + " m"
