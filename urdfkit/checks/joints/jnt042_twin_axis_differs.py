"""A joint turns about another axis than its twin on the other side.

Left and right are mirror images: where the left hip turns about x, so does the right one, forwards
or backwards. Two joints are compared if both turn, their names differ in the side only, and their
frames are mirror images in the plane y = 0 of the root, in the zero pose; which of the two ways an
axis points is free. One letter of an `<axis>` was mistaken, or an `rpy` was not mirrored: the legs
part where they should swing.

Sources:
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
    measured: of 1300 public descriptions none has such twins.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.spatial import dot, rotate
from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.kinematics import TURNING, direction
from urdfkit.text.diagnostic import Confidence, Related, Severity

if TYPE_CHECKING:
    from urdfkit.core.spatial import Transform, Vector
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import Joint

_HIP = """\
<link name="{side}_leg"/>
<joint name="{side}_hip" type="revolute">
  <parent link="base"/>
  <child link="{side}_leg"/>
  <origin xyz="0 {y} 0"/>
  <axis xyz="{axis}"/>
  <limit lower="-1" upper="1" effort="40" velocity="10"/>
</joint>
"""
_LEFT = _HIP.format(side="left", y=0.1, axis="0 1 0")
BAD = f"""\
<link name="base"/>
{_LEFT}{_HIP.format(side="right", y=-0.1, axis="1 0 0")}"""
GOOD = BAD.replace("1 0 0", "0 1 0")

#: In m; people round.
_NEAR = 1e-3

#: Cosine of the angle of two axes that are not one, written with an error.
_ACROSS = 0.5


@rule(
    "JNT042",
    "twin-axis-differs",
    Severity.WARNING,
    help="give both the same axis, seen from the root, or the opposite one",
)
def check(subject: Subject) -> Iterator[Finding]:
    frames = subject.tree.frames
    for left, right in subject.symmetric_joints:
        if left.kind not in TURNING or right.kind not in TURNING:
            continue
        one, other = (frames.get(joint.child.value) for joint in (left, right) if joint.child)
        if one is None or other is None or not _are_mirrored(one, other):
            continue
        a, b = _axis(left, one), _axis(right, other)
        if abs(dot((a[0], -a[1], a[2]), b)) < _ACROSS:
            yield Finding(
                right.at.child("axis") or right.at,
                f"joint '{right.name}' turns about {_shown(b)}, seen from the root, and its twin "
                f"'{left.name}' about {_shown(a)}",
                related=(Related((left.at.child("axis") or left.at).span, "the twin's axis"),),
                confidence=Confidence.INFERRED,
            )


def _are_mirrored(one: Transform, other: Transform) -> bool:
    (x, y, z), (a, b, c) = one.position, other.position
    return abs(y) > _NEAR and max(abs(x - a), abs(y + b), abs(z - c)) <= _NEAR


def _axis(joint: Joint, frame: Transform) -> Vector:
    """Of a joint, in the frame of the root."""
    return rotate(frame.rotation, direction(joint))


def _shown(axis: Vector) -> str:
    return " ".join(f"{round(part, 3) + 0.0:g}" for part in axis)
