"""The gravity torque of a joint exceeds its effort limit.

In a pose within the limits the gravity torque exceeds the `effort` of the joint's `<limit>`: with
any controller, the robot sags or falls there. A search finds the worst pose, with the root fixed.
Raise the effort, use a larger motor, move masses inwards or narrow the limits. Springs and
counterweights are not part of URDF: if the real robot has them, ignore this finding. Links whose
gravity is off in Gazebo (`<turnGravityOff>`, `<gravity>`), the usual substitute for counterweights,
are ignored. Robots that several rotors or thrusters carry are not searched: their root is not
fixed. `urdfkit statics` prints the torques of all joints, and accepts payloads.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
"""

from __future__ import annotations

from functools import lru_cache
from math import isfinite

from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.errors import Unavailable
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.robot.joint_loads import effort, overloadable_joints
from urdfkit.robot.joints import effort_unit
from urdfkit.robot.model import Joint
from urdfkit.robot.rotors import is_carried_by_rotors
from urdfkit.robot.samples import inertial_xml, joint_xml, link_xml, robot_xml
from urdfkit.ros.gazebo.gravity import links_without_gravity

if TYPE_CHECKING:
    from urdfkit.physics.gravity import Load
    from urdfkit.physics.gravity_model import GravityModel

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

#: Number of random start poses; a serial arm needs none.
_SAMPLES = 20


@rule(
    Severity.WARNING,
    needs=(Need.MODEL,),
    help="raise the effort to what the motor has, or correct the masses (urdfkit statics)",
)
def check(context: Context) -> Findings:
    overloaded = overloadable_joints(context.tree)
    if not overloaded or context.is_part or context.masses.consistently_wrong:  # INE010
        return
    if is_carried_by_rotors(context.model):
        return
    from urdfkit.physics.gravity import is_searched
    from urdfkit.physics.gravity_model import GravityModel

    model = GravityModel(context.tree, weightless=links_without_gravity(context.tree))
    joints = {joint.name: joint for joint in overloaded}
    loads = _loads(model, tuple((name, effort(joint)) for name, joint in joints.items()))
    for load in loads:
        if load.is_exceeded and isfinite(load.worst):
            yield _finding(joints[load.joint], load)
    if not is_searched(len(loads)):
        raise Unavailable(f"the worst pose of {len(loads)} joints is not searched, only zero")


@lru_cache(maxsize=16)  # editors and fixes check a robot repeatedly with the same masses
def _loads(model: GravityModel, efforts: tuple[tuple[str, float | None], ...]) -> list[Load]:
    from urdfkit.physics.gravity import gravity_loads

    return gravity_loads(model, dict(efforts), model.starts(_SAMPLES, seed=0), pose={})


def _finding(joint: Joint, load: Load) -> Finding:
    assert joint.limit is not None
    assert joint.limit.effort is not None
    pose = ", ".join(
        f"{name} {place:.3g}" for name, place in load.pose.items() if abs(place) > 5e-4
    )
    unit = effort_unit(joint)
    message = (
        f"joint '{joint.name}' needs {load.worst:.4g} {unit} to hold against gravity at "
        f"{pose or 'zero'}; its effort limit is {load.effort:.4g} {unit}"
    )
    return Finding(joint.limit.effort, message, weight=load.used or 0.0, group_key="effort")
