"""A joint moves nothing: no link below it has a mass, a visual or a collision.

The degree of freedom has no effect. Its row of the mass matrix is zero, which Pinocchio's forward
dynamics and MuJoCo reject; Gazebo drops the joint with the massless link. If the joint only defines
a frame, make it fixed; if it is part of a mechanism, add `<mimic>`.

Sources:
    MuJoCo, user_objects.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_objects.cc
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
"""

from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.robot.joint_limits import driven
from urdfkit.robot.joint_loads import joints_without_load
from urdfkit.robot.samples import joint_xml, link_xml, robot_xml
from urdfkit.ros.gazebo.samples import solid_xml

BAD = robot_xml(solid_xml("base"), link_xml("arm"), joint_xml("continuous"))
GOOD = BAD.replace("continuous", "fixed")


@rule(
    Severity.INFO,
    help='make it type="fixed", or give the link below it a mass',
    reports_missing=True,
)
def check(context: Context) -> Findings:
    if context.is_part or not any(link.mass for link in context.model.links):
        return
    actuated = driven(context.model)
    sensing = {block.get("reference") for block in context.model.gazebo if block.child("sensor")}
    for joint in joints_without_load(context.tree):
        child = joint.child_name
        if joint.name in actuated or not sensing.isdisjoint(context.tree.below(child)):
            continue
        yield Finding(
            joint.at,
            f"joint '{joint.name}' ({joint.kind}): link '{child}' and the links below it "
            "have neither mass nor shape",
        )
