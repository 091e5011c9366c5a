"""A continuous joint has position limits.

A continuous joint turns without end. Gazebo, MoveIt, ros2_control, MuJoCo and Pinocchio ignore
`lower` and `upper`; Drake enforces them, so that the same robot moves differently there, and not at
all with 0 and 0. Remove them, or make the joint revolute if it has stops. Limits of a whole turn or
more, and zeros, as exporters write them, are an info, unless Drake is a given target: no robot
relies on them. The fix removes only these limits: with narrower ones the joint may be revolute.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
"""

from math import pi

from urdfkit.lint.rules import Context, Finding, Findings, Fix, Severity, rule
from urdfkit.robot.model import Limit
from urdfkit.robot.samples import arm_xml
from urdfkit.robot.values import number
from urdfkit.text.editing.edits import all_or_none, remove_attribute

BAD = arm_xml(
    "continuous",
    '<axis xyz="0 0 1"/>',
    '<limit lower="-6.28" upper="6.28" effort="9" velocity="6.28"/>',
)
FIXED = GOOD = BAD.replace('lower="-6.28" upper="6.28" ', "")

#: A turn in rad, with a tolerance for rounded limits such as 3.14.
_TURN = 2 * pi - 0.01


@rule(Severity.WARNING, help="remove lower and upper, or make the joint revolute")
def check(context: Context) -> Findings:
    for joint in context.model.joints:
        if joint.kind != "continuous" or joint.limit is None:
            continue
        written = [
            attribute
            for name, attribute in joint.limit.at.attributes.items()
            if name in ("lower", "upper")
        ]
        if written:
            narrows = _narrows(joint.limit)
            is_harmless = not narrows and "drake" not in context.given_targets
            values = " and ".join(f'{attribute.name}="{attribute.value}"' for attribute in written)
            yield Finding(
                written[0],
                f"joint '{joint.name}' is continuous and has {values}, which only Drake obeys",
                # Narrow limits are right more often than the type, and lost once removed.
                fix=None
                if narrows
                else Fix.of("remove lower and upper", all_or_none(map(remove_attribute, written))),
                group_key="continuous",
                severity=Severity.INFO if is_harmless else None,
            )


def _narrows(limit: Limit) -> bool:
    """True if the limits allow less than a turn."""
    lower, upper = (number(limit.at.get(key)) or 0.0 for key in ("lower", "upper"))
    return lower != upper and upper - lower < _TURN
