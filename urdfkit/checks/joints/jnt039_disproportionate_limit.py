"""An effort or velocity limit is out of proportion to those of the other joints.

The limit is 200 times the largest effort of the other joints, or 20 times the largest velocity; or
200 times below the smallest. Its unit is wrong (N mm, degrees per second, turns per minute), its
decimal point is misplaced, or it is a placeholder. Controllers and planners use the limit: one
joint jerks, or slows all others down. Joints are compared with joints of the same type; a value
that several joints share is not reported.

A prismatic joint whose position limits are, to the last of at least four digits, those of a
revolute joint is reported, too: they are angles, and its type is wrong.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    measured: in 1300 public descriptions Baxter's head_pan has it, and one joint of an IRB 6700.
"""

from collections.abc import Iterable

from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Related, Severity, rule
from urdfkit.robot.joint import SINGLE_DOF, Joint
from urdfkit.robot.joint_limits import bounds
from urdfkit.robot.placed import Placed
from urdfkit.robot.samples import joint_xml, link_xml, robot_xml

_LIMIT = '<limit lower="-2" upper="2" effort="80" velocity="3"/>'
BAD = robot_xml(
    *map(link_xml, ("base", "arm", "forearm", "wrist", "hand")),
    joint_xml("revolute", _LIMIT),
    joint_xml("revolute", _LIMIT, name="elbow", parent="arm", child="forearm"),
    joint_xml("revolute", _LIMIT, name="roll", parent="forearm", child="wrist"),
    joint_xml("revolute", _LIMIT.replace("80", "40000"), name="tip", parent="wrist", child="hand"),
)
GOOD = BAD.replace("40000", "40")

#: Ratio to the largest of the others; shoulders are stronger than wrists, and fingers are weak.
_MAX_RATIOS = {"effort": 200.0, "velocity": 20.0}

#: Ratio below the smallest of the others; DYN003 reports weak motors.
_TIMES_LESS = 200.0

#: Least number of other joints to compare with.
_MIN_OTHERS = 3


@rule(
    Severity.WARNING,
    confidence=Confidence.INFERRED,
    help="check the unit (N·m or N, rad/s or m/s) and the decimal point",
)
def check(context: Context) -> Findings:
    joints = [joint for joint in context.model.joints if joint.is_single_dof and joint.limit]
    for kind in SINGLE_DOF:  # wheels have other motors than arms
        same_kind = [joint for joint in joints if joint.kind == kind]
        for key, times in _MAX_RATIOS.items():
            yield from _outlier(same_kind, key, times)
    yield from _angles(context.model.joints)


def _angles(joints: Iterable[Joint]) -> Findings:
    """Prismatic joints with the limits of a revolute joint."""
    ranges = {
        bounds(joint): joint
        for joint in joints
        if joint.kind == "revolute" and any(map(_is_exact, bounds(joint) or ()))
    }
    for joint in joints:
        other = ranges.get(bounds(joint)) if joint.is_prismatic else None
        if other and joint.type and joint.limit:
            lower, upper = joint.limit.ends
            yield Finding(
                joint.type,
                f"joint '{joint.name}' is prismatic, but its limits [{lower:g}, {upper:g}] m are "
                f"those of the revolute joint '{other.name}' in rad",
                'write type="revolute", or limits in m',
                related=(Related(other.at.span, f"joint '{other.name}'"),),
            )


def _is_exact(end: float) -> bool:
    """True for a limit with at least four digits, which two joints do not share by chance."""
    return float(f"{end:.3g}") != end


def _outlier(joints: list[Joint], key: str, times: float) -> Findings:
    """The one joint whose limit is far above, or far below, those of all others."""
    known = [(joint, limit) for joint in joints if (limit := _limit(joint, key))]
    known.sort(key=lambda pair: pair[1].value)
    if len(known) <= _MIN_OTHERS:
        return
    (weakest, lowest), (_, low), (_, high), (strongest, highest) = *known[:2], *known[-2:]
    if highest.value >= times * high.value:
        ratio = f"{highest.value / high.value:.3g} times the largest"
        yield _finding(strongest, highest, key, ratio)
    elif lowest.value * _TIMES_LESS <= low.value:
        yield _finding(weakest, lowest, key, f"{lowest.value / low.value:.2g} of the smallest")


def _limit(joint: Joint, key: str) -> Placed[float] | None:
    limit: Placed[float] | None = getattr(joint.limit, key)
    return limit if limit and limit.value > 0 else None


def _finding(joint: Joint, limit: Placed[float], key: str, ratio: str) -> Finding:
    in_unit = joint.effort_unit if key == "effort" else f"{joint.unit}/s"
    return Finding(
        limit,
        f"joint '{joint.name}': {key} limit {limit.value:g} {in_unit} is {ratio} of the other "
        "joints",
    )
