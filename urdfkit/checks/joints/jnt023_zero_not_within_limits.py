"""The position 0 is outside the limits of joints.

Simulators and inverse kinematics start joints at 0. Gazebo moves such a joint to its limit in the
first step, and other programs start with a configuration that they then reject. The limits are
often intended, as for an elbow that cannot be straightened: then set an initial position in the
simulation, or rotate the origin of the joint so that 0 is within the limits.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
"""

from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.robot.joints import bounds, related, several, unit
from urdfkit.robot.model import Joint, Limit
from urdfkit.robot.samples import arm_xml

BAD = arm_xml("revolute", '<limit lower="0.5" upper="2.5" effort="30" velocity="1"/>')
GOOD = BAD.replace('lower="0.5"', 'lower="0"')

#: Part of the range by which 0 may be outside: a margin, not a defect.
_MARGIN = 0.01


@rule(
    Severity.INFO,
    help="set an initial position, or rotate its origin so that 0 is within the limits",
)
def check(context: Context) -> Findings:
    """One finding for all joints: the legs of a quadruped have the same limits."""
    joints: list[tuple[Joint, Limit]] = []
    for joint in context.model.joints:
        ends = bounds(joint)
        if joint.limit is None or ends is None or joint.mimic:
            continue
        lower, upper = ends
        if max(lower, -upper) > _MARGIN * (upper - lower) > 0:
            joints.append((joint, joint.limit))
    if joints:
        first, limit = joints[0]
        lower, upper = bounds(first) or (0.0, 0.0)
        yield Finding(
            limit.at,
            f"{several([joint for joint, _ in joints])}: position 0 is outside the limits "
            f"[{lower:g}, {upper:g}] {unit(first)}",
            related=related((joint, limit.at.span) for joint, limit in joints),
        )
