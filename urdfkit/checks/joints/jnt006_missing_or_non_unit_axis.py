"""The axis of a joint is missing or not a unit vector.

- An axis of length 0 is an error: MuJoCo and Drake reject the robot, Gazebo drops the model,
  Pinocchio computes with an invalid rotation. urdfdom reads an `<axis>` without `xyz` as 0 0 0, not
  as the default axis.
- An axis of another length than 1 is a warning: Gazebo, MuJoCo, Drake, MoveIt and KDL normalise it;
  viewers that do not normalise it move a prismatic joint too far by the same factor. Often angles
  or a position were written instead of a direction.
- An axis that is nearly, but not exactly, x, y or z is an info: it is noise of a CAD exporter. An
  error of 0.002 rad moves a hand at one metre by 2 mm, closed-form inverse kinematics, which needs
  axes that are exactly parallel or perpendicular, fails, and Pinocchio uses its slower joint for
  arbitrary axes.
- A movable joint without an axis turns about x, or moves along it: an info. URDF's default is
  1 0 0, and all parsers agree, but few joints turn about x: a missing y or z axis goes unnoticed
  until the robot moves. Write the axis, also if it is x.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    urdfdom, joint.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/joint.cpp
    MuJoCo, user_objects.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_objects.cc
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
    kdl_parser: https://github.com/ros/kdl_parser/blob/noetic-devel/kdl_parser/src/kdl_parser.cpp
    Pinocchio, URDF joints: https://github.com/stack-of-tasks/pinocchio/blob/devel/include/pinocchio/parsers/urdf/model.hxx
"""

from math import hypot

from urdfkit.core.spatial import Vector, length
from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.robot.joint import SINGLE_DOF, Joint
from urdfkit.robot.placed import Placed
from urdfkit.robot.samples import arm_xml
from urdfkit.text.editing.edits import fix_value

BAD = arm_xml(
    "prismatic", '<axis xyz="0 3 4"/>', '<limit lower="0" upper="0.5" effort="100" velocity="1"/>'
)
FIXED = GOOD = BAD.replace("0 3 4", "0 0.6 0.8")

#: Length below which sdformat rejects an axis; MuJoCo's bound is smaller.
_ZERO = 1e-6

#: Unit vectors rounded to two decimals, such as 0.71 0.71 0, differ less from length 1.
_TOLERANCE = 0.01

#: In rad: a larger angle is likely intended, a smaller one is rounding of a 16-digit number.
_MAX_NOISE, _MIN_NOISE = 5e-3, 1e-9

_MOTION = {"prismatic": "moves along", "planar": "moves in the plane across"}


@rule(Severity.WARNING)
def check(context: Context) -> Findings:
    for joint in context.model.joints:
        at = joint.at.child("axis")
        if joint.kind not in (*SINGLE_DOF, "planar"):
            continue
        if at is None:
            motion = _MOTION.get(joint.kind, "turns about")
            message = f"joint '{joint.name}' has no <axis>: it {motion} x (1 0 0) by default"
            help = "write the axis, also if it is x"
            yield Finding(joint.at, message, help, severity=Severity.INFO)
        elif "xyz" not in at.attributes:
            message = f"joint '{joint.name}': <axis> has no xyz and is read as 0 0 0"
            yield Finding(at, message, "write the direction of the axis", severity=Severity.ERROR)
        elif joint.axis:
            yield from _findings(joint, joint.axis)


def _findings(joint: Joint, axis: Placed[Vector]) -> Findings:
    norm = length(axis.value)
    who = f"joint '{joint.name}': axis {' '.join(f'{value:g}' for value in axis.value)}"
    if norm < _ZERO:
        message = f"{who} has length 0"
        yield Finding(axis, message, "write the direction of the axis", severity=Severity.ERROR)
    elif abs(norm - 1) > _TOLERANCE:
        normalized = " ".join(f"{part / norm + 0.0:.10g}" for part in axis.value)  # + 0.0: no -0
        message = f"{who} has length {norm:.4g}, not 1"
        help = "write a vector of length 1 in the direction of the axis"
        yield Finding(axis, message, help, fix_value(axis.at, normalized))
    elif joint.is_single_dof:
        yield from _noise(joint, axis)


def _noise(joint: Joint, axis: Placed[Vector]) -> Findings:
    """A unit vector that deviates a little from x, y or z."""
    sizes = [abs(part) for part in axis.value]
    main = sizes.index(max(sizes))
    deviation = hypot(*sizes[:main], *sizes[main + 1 :])
    if _MIN_NOISE < deviation < _MAX_NOISE:
        sign = "-" if axis.value[main] < 0 else ""
        suggested = " ".join(f"{sign}1" if index == main else "0" for index in range(3))
        message = (
            f"joint '{joint.name}': axis deviates from {sign}{'xyz'[main]} by {deviation:.2g} rad"
        )
        help = "write the intended axis"
        yield Finding(axis, message, help, fix_value(axis.at, suggested), severity=Severity.INFO)
