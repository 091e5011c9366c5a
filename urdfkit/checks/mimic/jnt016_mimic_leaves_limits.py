"""A joint that mimics another one leaves its own limits.

The position of the joint is the leader's times `multiplier` plus `offset`. If the leader's range
drives the joint beyond its own limits, a simulator that supports mimic pulls at a joint at its
stop, and the leader stops early or shakes; MoveIt and RViz show the joint outside of its limits.
Often only the sign of the multiplier is wrong, or limits were copied from the leader.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
"""

from urdfkit.lint.rules import Context, Finding, Findings, Related, Severity, rule
from urdfkit.robot.joints import bounds, overshoot, unit
from urdfkit.robot.model import Joint
from urdfkit.robot.samples import hand_xml

_LIMIT = '<limit lower="0" upper="0.8" effort="20" velocity="2"/>'
BAD = hand_xml("revolute", [_LIMIT], [_LIMIT, '<mimic joint="left_joint" multiplier="-1"/>'])
GOOD = BAD.replace(' multiplier="-1"', "")


@rule(Severity.WARNING)
def check(context: Context) -> Findings:
    known = context.model.joints_by_name
    for joint in context.model.joints:
        mimic, own = joint.mimic, bounds(joint)
        leader = known.get(joint.leader)
        leading = bounds(leader) if leader and leader is not joint else None
        if mimic is None or own is None or leader is None or leading is None:
            continue
        if own[0] >= own[1] or leading[0] > leading[1]:
            continue  # JNT003
        taken = _taken(leading, mimic.multiplier, mimic.offset)
        if overshoot(taken, own) <= 0:
            continue
        assert leader.limit is not None
        yield Finding(
            mimic.at,
            f"joint '{joint.name}': the mimic of '{leader.name}' drives it through [{taken[0]:g}, "
            f"{taken[1]:g}] {unit(joint)}, beyond its limits [{own[0]:g}, {own[1]:g}]",
            _advice(joint, leading, taken, own),
            related=(Related(leader.limit.at.span, f"the limits of '{leader.name}'"),),
            group_key="beyond",
        )


def _taken(leading: tuple[float, float], multiplier: float, offset: float) -> tuple[float, float]:
    ends = sorted(end * multiplier + offset for end in leading)
    return ends[0] + 0.0, ends[1] + 0.0  # no -0


def _advice(
    joint: Joint,
    leading: tuple[float, float],
    taken: tuple[float, float],
    own: tuple[float, float],
) -> str:
    """Where a sign is wrong, the limits may have it as well as the multiplier."""
    assert joint.mimic is not None
    turned = _taken(leading, -joint.mimic.multiplier, joint.mimic.offset)
    if overshoot(turned, own) <= 0:
        return (
            f'if it turns the right way, write lower="{taken[0]:g}" upper="{taken[1]:g}"; '
            f"else multiplier {-joint.mimic.multiplier:g}"
        )
    return "correct multiplier and offset, or the limits of one of the two"
