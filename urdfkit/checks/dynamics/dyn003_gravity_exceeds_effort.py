"""The gravity torque of a joint exceeds its effort limit.

In a pose within the limits the gravity torque exceeds the `effort` of the joint's `<limit>`: with
any controller, the robot sags or falls there. A search finds the worst pose, with the root fixed.
Raise the effort, use a larger motor, move masses inwards or narrow the limits. Springs and
counterweights are not part of URDF: if the real robot has them, ignore this finding. Links whose
gravity is off in Gazebo (`<turnGravityOff>`, `<gravity>`), the usual substitute for counterweights,
are ignored, and so are robots that launch files start only in worlds of Gazebo without gravity.
Robots that several rotors or thrusters carry are not searched: their root is not fixed. An info if
the torque exceeds the limit by less than a twentieth, as masses are hardly known better, and for a
joint that swings freely: transmissions or `<ros2_control>` drive others, but not this one, or it
is the rocker or bogie of a suspension, whose wheels stand on the ground.

`urdfkit statics` prints the torques of all joints, and accepts payloads.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
"""

from __future__ import annotations

import re

from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.core.words import listed
from urdfkit.errors import Unavailable
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.robot.inertials.defects import InertiaDefect, center_is_outside
from urdfkit.robot.joint import Joint
from urdfkit.robot.joint_limits import driven
from urdfkit.robot.joint_loads import GRAVITY, overloadable_joints
from urdfkit.robot.samples import inertial_xml, joint_xml, link_xml, robot_xml

if TYPE_CHECKING:
    from urdfkit.physics.gravity import Load

BAD = robot_xml(
    link_xml("base"),
    link_xml("arm", inertial_xml("4", "0.34 0.34 0.005", '<origin xyz="0 0 0.5"/>')),
    joint_xml(
        "revolute",
        '<axis xyz="0 1 0"/>',
        '<limit lower="-1.5" upper="1.5" effort="10" velocity="2"/>',
    ),
)
GOOD = BAD.replace('effort="10"', 'effort="30"')

#: Most links that the help names.
_MAX_NAMED = 3
_DISPLACED = "correct centres of mass first: they are outside the shapes of {} (INE011)"
_PASSIVE = "nothing drives it: raise the effort if it has a motor"
#: Ratio of torque and limit up to which the masses may be wrong.
_TOLERANCE = 1.05
#: Words in the names of joints between the body and its wheels.
_SUSPENSION = r"(?i)suspension|rocker|bogie|boogie|shock"
_STANDS = "the ground carries the wheels: raise the effort if it has a motor"


@rule(
    Severity.WARNING,
    needs=(Need.MODEL,),
    help="raise the effort to what the motor has, or correct the masses (urdfkit statics)",
)
def check(context: Context) -> Findings:
    overloadable = overloadable_joints(context.tree)
    if not overloadable or context.is_part or context.masses.consistently_wrong:  # INE010
        return
    from urdfkit.physics.gravity import is_searched
    from urdfkit.physics.overloads import overloads
    from urdfkit.ros.launch.weightless import is_started_weightless

    loads = overloads(context.tree)
    if loads and is_started_weightless(context.source, context.resolver):
        return
    motors = driven(context.model)
    moments = _moments_of_displaced(context)
    for load in loads:
        joint = context.model.joints_by_name[load.joint]
        finding = _finding(joint, load)
        if displaced := _displaced(context, joint, load, moments):
            finding = finding._replace(help=_DISPLACED.format(displaced))
        if motors and load.joint not in motors:
            finding = finding._replace(severity=Severity.INFO, help=_PASSIVE)
        elif _is_suspension(context, joint):
            finding = finding._replace(severity=Severity.INFO, help=_STANDS)
        elif (load.used or 0.0) < _TOLERANCE:
            finding = finding._replace(severity=Severity.INFO)
        yield finding
    if not is_searched(len(overloadable)):
        raise Unavailable(
            f"the worst pose of {len(overloadable)} joints is not searched, only zero"
        )


def _moments_of_displaced(context: Context) -> dict[str, float]:
    """Gravity moments in N·m by which centres of mass outside their shapes may be wrong."""
    links = context.masses.defects.get(InertiaDefect.CENTER_OF_MASS, ())
    return {one.link.name: one.mass * GRAVITY * (center_is_outside(one) or 0.0) for one in links}


def _displaced(context: Context, joint: Joint, load: Load, moments: dict[str, float]) -> str:
    """The links whose centres of mass may explain half of the excess or more; empty if none."""
    links = [link for link in context.tree.below(joint.child_name) if link in moments]
    explained = sum(moments[link] for link in links)
    if joint.is_prismatic or 2 * explained < load.worst - (load.effort or 0.0):
        return ""
    return listed([f"'{link}'" for link in links], _MAX_NAMED) if links else ""


def _is_suspension(context: Context, joint: Joint) -> bool:
    links = {joint.child_name, *context.tree.below(joint.child_name)}
    has_wheel = any(
        other.kind == "continuous" and other.parent_name in links for other in context.model.joints
    )
    return has_wheel and re.search(_SUSPENSION, joint.name) is not None


def _finding(joint: Joint, load: Load) -> Finding:
    from urdfkit.physics.overloads import worst_pose

    assert joint.limit is not None
    assert joint.limit.effort is not None
    unit = joint.effort_unit
    message = (
        f"joint '{joint.name}' needs {load.worst:.4g} {unit} to hold against gravity at "
        f"{worst_pose(load)}; its effort limit is {load.effort:.4g} {unit}"
    )
    return Finding(joint.limit.effort, message, weight=load.used or 0.0, group_key="effort")
