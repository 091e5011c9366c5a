"""The friction or damping of a joint exceeds its effort limit.

A joint whose friction exceeds its effort never moves. The damping torque grows with the velocity;
it is reported if it equals the effort at less than 0.1 rad/s or 0.01 m/s, and at a twentieth of the
velocity limit. Friction is in N·m (or N), damping in N·m per rad/s: values from a data sheet in
N mm, or tuned for another simulator, are a thousand times too large. Gazebo, MuJoCo and Drake use
them unchanged.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    measured: of 1300 public descriptions one hand has it, with friction of 5 and effort of 0.7 N·m.
"""

from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.robot.joint import Joint
from urdfkit.robot.joint_loads import effort
from urdfkit.robot.samples import arm_xml
from urdfkit.robot.values import number
from urdfkit.text.document import Element

BAD = arm_xml(
    "revolute",
    '<limit lower="-2" upper="2" effort="10" velocity="3"/>',
    '<dynamics damping="0.1" friction="500"/>',
)
GOOD = BAD.replace('"500"', '"0.5"')

#: Velocities at full effort below which damping is reported, in rad/s and m/s.
_CREEPS = {"rad": 0.1, "m": 0.01}

#: The same bound as a part of the velocity limit.
_MAX_VELOCITY_PART = 0.05


@rule(Severity.WARNING, help="write friction in N·m (N for a slide), damping in N·m·s/rad (N·s/m)")
def check(context: Context) -> Findings:
    for joint in context.model.joints:
        dynamics = joint.at.child("dynamics")
        limit = effort(joint)
        if dynamics and limit and joint.is_single_dof and not joint.mimic:
            yield from _excessive(joint, dynamics, limit)


def _excessive(joint: Joint, dynamics: Element, limit: float) -> Findings:
    friction, damping = (number(dynamics.get(key)) or 0.0 for key in ("friction", "damping"))
    who, of = f"joint '{joint.name}'", joint.effort_unit
    if friction > limit:
        message = f"{who}: friction {friction:g} {of} exceeds the effort limit of {limit:g} {of}"
        yield Finding(
            dynamics.attributes["friction"], message, weight=friction / limit, group_key="friction"
        )
    speed = joint.limit.velocity.value if joint.limit and joint.limit.velocity else 0.0
    reached = limit / damping if damping > 0 else speed
    if reached < min(_CREEPS[joint.unit], _MAX_VELOCITY_PART * speed):
        yield Finding(
            dynamics.attributes["damping"],
            f"{who}: with damping {damping:g} {of}·s/{joint.unit}, the effort limit of {limit:g} "
            f"{of} reaches {reached:.2g} {joint.unit}/s; the velocity limit is {speed:g}",
            weight=speed / reached,
            group_key="damping",
        )
