"""A shape is fifty times as large as the rest of the robot.

URDF is in metres. A box of 50 x 50 x 240 is probably in millimetres: RViz shows a wall where the
robot should be, and everything collides with it.

Sources:
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.robot.model import Body
from urdfkit.text.diagnostic import Confidence, Related, Severity

_LINK = """\
<link name="{name}">
  <visual>
    <geometry><box size="{size}"/></geometry>
  </visual>
</link>
"""
_JOINT = """\
<joint name="wrist" type="fixed">
  <parent link="arm"/>
  <child link="hand"/>
</joint>"""
_ARM = _LINK.format(name="arm", size="0.1 0.1 0.3")
BAD = _ARM + _LINK.format(name="hand", size="50 50 240") + _JOINT
GOOD = BAD.replace("50 50 240", "0.05 0.05 0.24")

#: Times the size of the other links; and in m.
_TIMES = 50.0
_LEAST = 5.0
#: Names of links that are surroundings.
_GROUNDS = ("ground", "floor", "world", "plane", "room", "map", "terrain", "field")


@rule(Severity.WARNING, help="divide by 1000: lengths are metres")
def check(subject: Subject) -> Findings:
    sizes: dict[str, list[tuple[float, float, Body]]] = {}
    for link in subject.model.links:
        for body in (*link.visuals, *link.collisions):
            if body.shape and (half := body.shape.half_extents):
                sizes.setdefault(link.name, []).append((2 * max(half), 2 * min(half), body))
    rest = [size for found in sizes.values() for size, _, _ in found if size < _LEAST]
    if not rest:
        return
    longest = max(rest)
    for name, bodies in sizes.items():
        # A rail may be long; what is written in millimetres is thick as well.
        found = [
            (size, body)
            for size, thickness, body in bodies
            if size >= max(_LEAST, _TIMES * longest) and thickness > longest
        ]
        if found and not any(word in name.lower() for word in _GROUNDS):
            yield _finding(name, found, longest)


def _finding(link: str, found: list[tuple[float, Body]], longest: float) -> Finding:
    (size, body), *others = found
    assert body.shape is not None
    return Finding(
        body.shape.at,
        f"link '{link}': the {body.at.tag} is {size:g} m long, the rest of the robot at most "
        f"{longest:.3g} m",
        related=tuple(Related(other.at.span, f"{one:g} m as well") for one, other in others),
        confidence=Confidence.INFERRED,
    )
