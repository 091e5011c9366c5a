"""A joint has an axis or position limits that its type ignores.

- An axis and limits have no effect on a fixed joint: URDF parsers ignore them. They are left over
  from a joint that once moved, or the joint should be revolute or prismatic. Limits of zero, as
  exporters write them, are not reported. An info.
- A continuous joint turns without end. Gazebo, MoveIt, ros2_control, MuJoCo and Pinocchio ignore
  `lower` and `upper`; Drake enforces them, so that the same robot moves differently there, and not
  at all with 0 and 0. Remove them, or make the joint revolute if it has stops: a warning. Limits of
  a whole turn or more, and zeros, as exporters write them, are an info, unless Drake is a given
  target: no robot relies on them. The fix removes only these limits: with narrower ones the joint
  may be revolute.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
    measured: an axis or limits of fixed joints in 143 of 676 public models
"""

from math import pi

from urdfkit.lint.rules import Context, Finding, Findings, Fix, Severity, rule
from urdfkit.robot.joint import Joint, Limit
from urdfkit.robot.samples import arm_xml
from urdfkit.robot.values import number
from urdfkit.text.editing.edits import all_or_none, remove_attribute, remove_element

BAD = arm_xml("fixed", '<axis xyz="0 1 0"/>')
FIXED = GOOD = BAD.replace('  <axis xyz="0 1 0"/>\n', "")

#: A turn in rad, with a tolerance for rounded limits such as 3.14.
_TURN = 2 * pi - 0.01


@rule(Severity.INFO)
def check(context: Context) -> Findings:
    for joint in context.model.joints:
        if joint.kind == "fixed":
            yield from _fixed(joint)
        elif joint.kind == "continuous" and joint.limit:
            yield from _continuous(joint, joint.limit, is_obeyed="drake" in context.given_targets)


def _fixed(joint: Joint) -> Findings:
    axis, limit = joint.at.child("axis"), joint.limit
    ends = (limit.lower, limit.upper) if limit else (None, None)
    lower, upper = (end.value if end else 0.0 for end in ends)
    is_limited = lower < upper
    if axis is not None:
        message = f"joint '{joint.name}' is fixed; its <axis> has no effect"
        # With limits it is needed again as soon as the joint gets the right type.
        fix = None if is_limited else Fix("remove the axis", remove_element(axis), safe=True)
        help = 'write type="revolute" or "prismatic", or remove the axis'
        yield Finding(axis, message, help if is_limited else "remove the axis", fix)
    if limit is not None and is_limited:
        yield Finding(
            limit.at,
            f"joint '{joint.name}' is fixed; its limits [{lower:g}, {upper:g}] have no effect",
            'write type="revolute" or "prismatic", or remove the <limit>',
        )


def _continuous(joint: Joint, limit: Limit, *, is_obeyed: bool) -> Findings:
    attributes = limit.at.attributes.items()
    written = [attribute for name, attribute in attributes if name in ("lower", "upper")]
    if not written:
        return
    lower, upper = (number(limit.at.get(key)) or 0.0 for key in ("lower", "upper"))
    narrows = lower != upper and upper - lower < _TURN
    # Narrow limits are right more often than the type, and lost once removed.
    edits = None if narrows else all_or_none(map(remove_attribute, written))
    values = " and ".join(f'{attribute.name}="{attribute.value}"' for attribute in written)
    yield Finding(
        written[0],
        f"joint '{joint.name}' is continuous and has {values}, which only Drake obeys",
        "remove lower and upper, or make the joint revolute",
        Fix.of("remove lower and upper", edits),
        severity=Severity.WARNING if narrows or is_obeyed else None,
    )
