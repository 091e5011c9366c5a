"""The origins of joints look like millimetres.

Lengths are metres in URDF. A drawing in millimetres makes a robot of the size of a town: the parts
lie hundreds of metres apart. An origin of 10 m or more is reported if the rest of the model speaks
against it: the other joints lie less than 1 m apart and a hundredth of it, or the meshes are
scaled by 0.001, or no shape has a hundredth of that size. Divide by 1000.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.joints import related, several
from urdfkit.robot.model import length
from urdfkit.text.diagnostic import Confidence, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import RobotModel

BAD = """\
<link name="base"><visual><geometry><box size="0.3 0.2 0.1"/></geometry></visual></link>
<link name="arm"><visual><geometry><box size="0.4 0.1 0.1"/></geometry></visual></link>
<joint name="shoulder" type="continuous">
  <parent link="base"/>
  <child link="arm"/>
  <origin xyz="0 0 150"/>
  <axis xyz="0 0 1"/>
</joint>"""
GOOD = BAD.replace("150", "0.150")

#: In m; few robots reach so far from one joint to the next, and in mm most do.
_FAR = 10.0
#: In m; shorter origins are rounding.
_NONE = 1e-4
#: How much further than what it is compared with.
_RATIO = 100.0


@rule(
    "JNT012",
    "origin-looks-like-millimetres",
    Severity.WARNING,
    help="divide by 1000: lengths are metres",
)
def check(subject: Subject) -> Iterator[Finding]:
    model = subject.model
    reaches = [(joint, length(joint.origin.position)) for joint in model.joints]
    far = [(joint, reach) for joint, reach in reaches if reach >= _FAR]
    if not far:
        return
    near = sorted(reach for _, reach in reaches if _NONE < reach < _FAR)
    least = min(reach for _, reach in far)
    if evidence := _evidence(model, least, near, len(far)):
        joints = [joint for joint, _ in far]
        places = [(joint, (joint.at.child("origin") or joint.at).span) for joint in joints]
        first, reach = far[0]
        yield Finding(
            first.at.child("origin") or first.at,
            f"{several(joints)}: the origin is {reach:g} m away, but {evidence}; that looks like "
            "millimetres",
            related=related(places),
            confidence=Confidence.INFERRED,
        )


def _evidence(model: RobotModel, least: float, near: list[float], count: int) -> str:
    """What speaks against origins of ``least`` metres and more; empty if nothing does."""
    if len(near) > max(2, count):
        median = near[len(near) // 2]
        if median < 1 and least > _RATIO * median:
            return f"half of the other {len(near)} joints lie less than {median:.2g} m apart"
        return ""
    shapes = model.shapes
    if any(shape.filename and max(map(abs, shape.scale)) == 0.001 for shape in shapes):
        return "meshes are scaled by 0.001"
    sizes = [max(half) * 2 for shape in shapes if (half := shape.half_extents)]
    if sizes and least > _RATIO * max(sizes) and not any(shape.filename for shape in shapes):
        return f"no shape is larger than {max(sizes):g} m"
    return ""
