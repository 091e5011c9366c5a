"""The position 0 lies outside of the limits of joints.

0 is where simulators and inverse kinematics put a joint at first. Gazebo throws such a joint to its
stop in the first step, and other programs start with a posture that they then reject. It is often
meant, as for an elbow that does not stretch: then give the simulation an initial position. Or turn
the origin of the joint, so that 0 is a posture that the robot can take.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.robot.joints import bounds, related, several, unit
from urdfkit.robot.model import Joint, Limit
from urdfkit.robot.samples import arm_xml
from urdfkit.text.diagnostic import Severity

BAD = arm_xml("revolute", '<limit lower="0.5" upper="2.5" effort="30" velocity="1"/>')
GOOD = BAD.replace('lower="0.5"', 'lower="0"')

#: Part of the range that is a margin, not a defect.
_MARGIN = 0.01


@rule(
    Severity.INFO,
    help="give the joint an initial position, or turn its origin so that 0 is within the limits",
)
def check(subject: Subject) -> Findings:
    """One finding for all: the legs of a quadruped are alike."""
    found: list[tuple[Joint, Limit]] = []
    for joint in subject.model.joints:
        ends = bounds(joint)
        if joint.limit is None or ends is None or joint.mimic:
            continue
        lower, upper = ends
        if max(lower, -upper) > _MARGIN * (upper - lower) > 0:
            found.append((joint, joint.limit))
    if found:
        first, limit = found[0]
        lower, upper = bounds(first) or (0.0, 0.0)
        yield Finding(
            limit.at,
            f"{several([joint for joint, _ in found])}: 0 is not within the limits {lower:g} to "
            f"{upper:g} {unit(first)}",
            related=related((joint, limit.at.span) for joint, limit in found),
        )
