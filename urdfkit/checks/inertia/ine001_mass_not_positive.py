"""A mass is negative, or zero on a link that a joint moves.

Gazebo drops a moving link of zero mass together with its children, MuJoCo rejects the robot,
PyBullet fixes the link to the world; Gazebo rejects a robot with a negative mass, and in other
engines it falls upwards. Write the mass in kg. A frame needs no `<inertial>` if its joint is fixed.
A link without shape between two joints, such as in a ball joint, is reported only if the robot is
for a simulator.

Sources:
    MuJoCo, user_objects.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_objects.cc
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
    PyBullet, UrdfParser.cpp: https://github.com/bulletphysics/bullet3/blob/master/examples/Importers/ImportURDFDemo/UrdfParser.cpp
"""

from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.robot.joint_limits import can_move
from urdfkit.robot.link import Link
from urdfkit.robot.samples import inertial_xml, joint_xml, link_xml, robot_xml

BAD = robot_xml(
    link_xml("base", inertial_xml("2", "0.02 0.02 0.02")),
    link_xml("wheel", inertial_xml("0", "0.001 0.001 0.001")),
    joint_xml("continuous", name="axle", child="wheel"),
)
GOOD = BAD.replace('"0"/>\n    <inertia ixx="0.001"', '"0.5"/>\n    <inertia ixx="0.001"')


@rule(Severity.ERROR, help="write the mass of the link in kg")
def check(context: Context) -> Findings:
    masses = context.masses
    for link in context.model.links:
        mass = link.inertial.mass if link.inertial else None
        if mass is None:
            continue
        body = masses.body_of.get(link.name)
        if mass.value < 0:
            yield Finding(mass, f"link '{link.name}' has a mass of {mass.value:g} kg")
        elif mass.value == 0 and masses.total > 0 and body and body.joint and body.mass <= 0:
            if _is_between_axes(link, context):
                continue
            joint = body.joint
            yield Finding(
                mass,
                f"link '{link.name}' has a mass of 0 kg and is moved by "
                f"the {joint.kind} joint '{joint.name}'",
                group_key="zero",
            )


def _is_between_axes(link: Link, context: Context) -> bool:
    """True for a link without shape and inertia between two moving joints, such as in a ball joint.

    Only simulators need the mass of such a link.
    """
    tensor = link.inertial.tensor if link.inertial else None
    if link.visuals or link.collisions or (tensor and any(tensor.value)):
        return False
    carries = any(map(can_move, context.tree.children[link.name]))
    return carries and not context.targets.that("simulates")
