"""A joint has no `<limit>`, or its `<limit>` has no effort or velocity.

A revolute or prismatic joint requires a `<limit>`, and every `<limit>`, of any joint, requires
`effort` and `velocity`. Without them urdfdom, and with it RViz, MoveIt, Gazebo and Pinocchio,
rejects the robot. `lower` and `upper` are optional and default to 0. A joint that turns without
end is continuous and needs no `<limit>`. MuJoCo and Drake read a missing limit as unlimited: if
they are the only targets, nothing is reported.

A continuous joint without `<limit>` is an info if another continuous joint on the same link has
one, such as three wheels of four: a simulation drives them differently once a controller exceeds
the limit.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    urdfdom, joint.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/joint.cpp
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
"""

from urdfkit.lint.rules import Context, Finding, Findings, Related, Severity, rule
from urdfkit.robot.joint import Joint, Limit
from urdfkit.robot.joint_limits import BOUNDED
from urdfkit.robot.model import RobotModel
from urdfkit.robot.samples import arm_xml

BAD = arm_xml("revolute", '<limit lower="-1" upper="1"/>')
GOOD = BAD.replace('upper="1"', 'upper="1" effort="10" velocity="1"')


@rule(Severity.ERROR)
def check(context: Context) -> Findings:
    yield from _inconsistent(context.model)
    incomplete = list(_incomplete(context.model))
    if incomplete and not context.targets.all_are("ignores_limits"):
        yield from incomplete


def _incomplete(model: RobotModel) -> Findings:
    """Joints whose limit lacks values that urdfdom requires."""
    for joint in model.joints:
        units = {"effort": joint.effort_unit, "velocity": f"{joint.unit}/s"}
        if joint.limit is None:
            if joint.kind in BOUNDED:
                yield Finding(
                    joint.at,
                    f"joint '{joint.name}' is {joint.kind} and has no <limit>",
                    f"add <limit> with lower and upper in {joint.unit}, effort in "
                    f"{units['effort']} and velocity in {units['velocity']}",
                )
            continue
        missing = [key for key in units if key not in joint.limit.at.attributes]
        if missing:
            message = f"joint '{joint.name}': <limit> has no {' and no '.join(missing)}"
            help = "add " + " and ".join(f"{key} in {units[key]}" for key in missing)
            yield Finding(joint.limit.at, message, help)


def _inconsistent(model: RobotModel) -> Findings:
    """Continuous joints without limit, if another one on the same link has effort and velocity."""
    limited: dict[str, tuple[Joint, Limit]] = {}
    joints = [joint for joint in model.joints if joint.kind == "continuous" and joint.parent]
    for joint in joints:
        if joint.limit and joint.limit.effort and joint.limit.velocity:
            limited.setdefault(joint.parent_name, (joint, joint.limit))
    for joint in joints:
        if joint.limit or joint.mimic or joint.parent_name not in limited:
            continue
        other, limit = limited[joint.parent_name]
        yield Finding(
            joint.at,
            f"joint '{joint.name}' has no effort and velocity limit; '{other.name}' on the same "
            "link has both",
            "give all continuous joints a <limit> with effort and velocity, or none",
            related=(Related(limit.at.span, f"limit of '{other.name}'"),),
            group_key=other.name,
            severity=Severity.INFO,
        )
