"""A joint is not where its twin on the other side would put it.

Left and right are mirror images: their origins on the body differ in the sign of one coordinate.
Two twins at one place, or one that is also forward or higher than the other, are a sign that was
forgotten or copied too often: the robot stands on three wheels, and drives in circles.

Sources:
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.diagnostic import Confidence, Related, Severity
from urdfkit.mechanics.twins import pairs
from urdfkit.rules import Finding, rule
from urdfkit.static import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.model import Joint
    from urdfkit.spatial import Vector
    from urdfkit.subject import Subject

_WHEEL = """\
<link name="{side}_wheel"/>
<joint name="{side}_wheel_joint" type="continuous">
  <parent link="base"/>
  <child link="{side}_wheel"/>
  <origin xyz="0.1 {y} -0.05"/>
  <axis xyz="0 1 0"/>
</joint>
"""
BAD = f"""\
<link name="base"/>
{_WHEEL.format(side="left", y=0.2)}{_WHEEL.format(side="right", y=0.2)}"""
GOOD = f"""\
<link name="base"/>
{_WHEEL.format(side="left", y=0.2)}{_WHEEL.format(side="right", y=-0.2)}"""

#: In m; people round.
_NEAR = 1e-4
_AXES = "xyz"


@rule(
    "JNT031",
    "twin-misplaced",
    Severity.WARNING,
    help="mirror its origin in the plane between the two",
)
def check(subject: Subject) -> Iterator[Finding]:
    joints = {joint.name: joint for joint in subject.model.joints if joint.name}
    for left, right in pairs(joints):
        one, other = joints[left], joints[right]
        if one.parent is None or other.parent is None or one.parent.value != other.parent.value:
            continue
        if one.kind != other.kind:
            continue
        if reason := _reason(one, other):
            yield Finding(
                other.at.child("origin") or other.at,
                f"joint '{right}' at {_shown(other.origin.position)} m {reason} its twin "
                f"'{left}' at {_shown(one.origin.position)} m",
                related=(Related(one.at.span, f"the twin '{left}'"),),
                confidence=Confidence.INFERRED,
            )


def _reason(one: Joint, other: Joint) -> str:
    """What is wrong with two places that should be mirror images; empty if nothing is."""
    if one.origin.rotation != other.origin.rotation:
        return ""
    first, second = one.origin.position, other.origin.position
    equal = [abs(a - b) < _NEAR for a, b in zip(first, second, strict=True)]
    flipped = [abs(a + b) < _NEAR <= abs(a) for a, b in zip(first, second, strict=True)]
    if all(equal):
        return "is at the place of" if abs(first[1]) >= _NEAR and _axis(one) == _axis(other) else ""
    if not all(e or f for e, f in zip(equal, flipped, strict=True)) or not flipped[1]:
        return ""
    others = [axis for axis, turned in zip(_AXES, flipped, strict=True) if turned and axis != "y"]
    return f"is on the other side in y and in {others[0]}, too, of" if len(others) == 1 else ""


def _axis(joint: Joint) -> Vector | None:
    return joint.axis.value if joint.axis else None


def _shown(place: Vector) -> str:
    return " ".join(f"{value:.4g}" for value in place)
