"""MuJoCo rejects a joint that URDF allows.

Reported if MuJoCo is a target:

- A `floating` joint below a link that moves: "free joint can only be used on top level". MuJoCo
  merges links that are fixed to the root into the world, so that such a joint may be on any of
  these links; with `<compiler fusestatic="false"/>` only on a link `world`. Use prismatic joints
  and a ball joint, or remove the joint.
- A `spherical` joint whose lower limit is not 0, and below the upper one: "range[0] should be 0 in
  ball joint". The limit of a ball joint is the largest angle in any direction.
- A joint with limits or effort under `<compiler autolimits="false"/>`: URDF has no attribute that
  declares a joint as limited, so MuJoCo rejects the range. Remove `autolimits`.

Sources:
    MuJoCo, user_objects.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_objects.cc
    MuJoCo, autolimits: https://mujoco.readthedocs.io/en/stable/XMLreference.html#compiler-autolimits
    MuJoCo, URDF: https://github.com/google-deepmind/mujoco/blob/main/src/xml/xml_urdf.cc
"""

from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.robot.joint import SINGLE_DOF, Joint
from urdfkit.robot.joint_limits import BOUNDED, several
from urdfkit.robot.samples import inertial_xml, joint_xml, link_xml, robot_xml
from urdfkit.robot.values import number

TARGETS = ("mujoco",)
_INERTIAL = inertial_xml("1", "0.1 0.1 0.1")
GOOD = robot_xml(link_xml("base"), link_xml("arm", _INERTIAL), joint_xml("floating"))
BAD = robot_xml(
    GOOD,
    link_xml("tool", _INERTIAL),
    joint_xml("floating", name="wrist", parent="arm", child="tool"),
)


@rule(Severity.ERROR)
def check(context: Context) -> Findings:
    if not any(target.reads_joints_as_mjcf for target in context.given_facts):
        return
    for joint in context.model.joints:
        if joint.kind == "floating" and not _is_on_top(context, joint):
            yield Finding(
                joint.type or joint.at,
                f"joint '{joint.name}' is floating, and link '{joint.parent_name}' above it is not "
                "fixed to the world: MuJoCo rejects the robot",
                "connect the link to the root, or use prismatic joints and a ball joint",
            )
        elif joint.kind == "spherical":
            yield from _ball(joint)
    yield from _without_autolimits(context)


def _is_on_top(context: Context, joint: Joint) -> bool:
    """True if MuJoCo merges the parent of a joint into the world."""
    if not context.mujoco.fuses_static:
        return joint.parent_name == "world"
    return all(above.kind == "fixed" for above in context.tree.path(joint.parent_name))


def _ball(joint: Joint) -> Findings:
    lower = _lower(joint)
    if joint.limit and lower:
        yield Finding(
            joint.limit.at,
            f"joint '{joint.name}' is spherical and its lower limit is {lower:g} rad: MuJoCo "
            "rejects the robot unless it is 0",
            "set lower to 0, and upper to the largest angle",
        )


def _without_autolimits(context: Context) -> Findings:
    block = context.document.root.child("mujoco")
    compiler = block.child("compiler") if block else None
    autolimits = compiler.attributes.get("autolimits") if compiler else None
    if autolimits is None or autolimits.value != "false":
        return
    limited = [joint for joint in context.model.joints if _is_limited(joint)]
    if limited:
        yield Finding(
            autolimits,
            f"autolimits is false: MuJoCo rejects the <limit> of {several(limited)}",
            "remove autolimits",
        )


def _is_limited(joint: Joint) -> bool:
    """True if MuJoCo reads a range of positions or forces."""
    has_range = joint.kind in (*BOUNDED, "planar", "spherical") and _lower(joint) is not None
    has_effort = joint.kind in (*SINGLE_DOF, "planar")
    return has_range or (has_effort and bool(joint.limit and number(joint.limit.at.get("effort"))))


def _lower(joint: Joint) -> float | None:
    """The lower limit; None if there is no range, which requires both limits in MuJoCo."""
    if joint.limit is None:
        return None
    lower, upper = (number(joint.limit.at.get(key)) for key in ("lower", "upper"))
    return lower if lower is not None and upper is not None and lower < upper else None
