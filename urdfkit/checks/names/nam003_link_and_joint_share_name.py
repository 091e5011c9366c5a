"""A joint has the name of a link.

URDF has separate namespaces for links and joints, SDF does not: Gazebo (gz sim) reports that the
name is not unique and does not load the model. A `<gazebo reference>` of that name applies to both.
Add `_joint` to the name of the joint.

When Gazebo merges a fixed joint, frames with the names of the joint and of the link below it remain
in SDF (sdformat from 12.7.2): gz sim requires that these names are unique, too. Gazebo Classic has
no such frames: there the shared name is an info.

Sources:
    sdformat, FrameSemantics.cc: https://github.com/gazebosim/sdformat/blob/main/src/FrameSemantics.cc
    gazebosim/sdformat#1148: https://github.com/gazebosim/sdformat/pull/1148
    stack-of-tasks/pinocchio#1771: https://github.com/stack-of-tasks/pinocchio/issues/1771
    o3de/o3de-extras#476: https://github.com/o3de/o3de-extras/issues/476
"""

from urdfkit.lint.rules import Context, Finding, Findings, Need, Related, Severity, rule
from urdfkit.robot.joint import Joint
from urdfkit.robot.samples import joint_xml, link_xml, robot_xml
from urdfkit.ros.gazebo.rejection import shared_frames

BAD = robot_xml(
    link_xml("base"), link_xml("gripper"), joint_xml("continuous", name="gripper", child="gripper")
)
GOOD = BAD.replace('joint name="gripper"', 'joint name="gripper_joint"')


@rule(
    Severity.INFO,
    needs=(Need.MODEL, Need.GAZEBO),
    help="rename the joint, and its name in controllers and launch files",
    by_target={
        **dict.fromkeys(("classic-ros1", "classic-ros2"), Severity.WARNING),
        **dict.fromkeys(("gz-fortress", "gz-harmonic", "gz-jetty"), Severity.ERROR),
    },
)
def check(context: Context) -> Findings:
    links = context.model.links_by_name
    is_gz = any(name.startswith("gz-") for name in context.targets.names)
    frames = shared_frames(context.gazebo) if is_gz else frozenset()
    for joint in context.model.joints:
        if joint.name not in links:
            continue
        is_allowed = _is_merged(joint, context) and joint.name not in frames
        yield Finding(
            joint.at.attributes["name"],
            f"joint '{joint.name}' has the name of a link"
            + ("" if is_allowed else ", which Gazebo's SDF does not allow"),
            related=(Related(links[joint.name].at.span, "the link"),),
            severity=Severity.INFO if is_allowed else None,
        )


def _is_merged(joint: Joint, context: Context) -> bool:
    """True if Gazebo merges the joint, or the link of its name, so that one of them remains."""
    gazebo = context.gazebo
    merged = joint.kind == "fixed" and joint.name not in gazebo.kept
    return merged or joint.name in gazebo.merged
