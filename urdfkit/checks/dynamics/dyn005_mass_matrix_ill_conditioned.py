"""The mass matrix is ill-conditioned: a link is too light for the links below it.

A simulator solves for accelerations with the joint-space mass matrix at every step. If a body
between two joints with parallel axes has almost no mass, both joints can spin against each other
without resistance: the solution loses as many digits as the masses differ by, and none remain with
single precision (PhysX, Bullet). The robot trembles or explodes. Give the link the mass of the real
part, or make one of the joints fixed.

Sources:
    Featherstone 2004, An Empirical Study of the Joint Space Inertia Matrix: https://dokumen.tips/documents/an-empirical-study-of-the-joint-space-inertia-matrix.html
    robotology/icub-models#121: https://github.com/robotology/icub-models/issues/121
"""

from math import isinf

from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.robot.joint_loads import light_joints
from urdfkit.robot.samples import joint_xml, link_xml, robot_xml
from urdfkit.ros.gazebo.samples import solid_xml

BAD = robot_xml(
    link_xml("base"),
    solid_xml("turret", mass="1e-9", moments="1e-11 1e-11 1e-11"),
    solid_xml("gun", mass="5", moments="0.1 0.1 0.1"),
    joint_xml("continuous", '<axis xyz="0 0 1"/>', name="turret_joint", child="turret"),
    joint_xml("continuous", '<axis xyz="0 0 1"/>', name="gun_joint", parent="turret", child="gun"),
)
GOOD = BAD.replace("1e-9", "1").replace("1e-11", "0.01")


@rule(
    Severity.WARNING,
    needs=(Need.MODEL, Need.DYNAMICS),
    help="give the light link the mass and inertia of the real part, or fix one of the joints",
)
def check(context: Context) -> Findings:
    light = light_joints(context.tree)
    if not light or context.is_part:
        return
    robot = context.dynamics  # first, as it reports if the libraries of the module are missing
    from urdfkit.physics.dynamics.conditioning import MAX_RATIO, conditioning

    result = conditioning(robot)
    if not result.is_ill:
        return
    names = {joint.name for joint in light}
    first = next((name for name in result.joints if name in names), light[0].name)
    number = f"has the condition {result.number:.2g}, over {MAX_RATIO:.0e}"
    ratio = "is singular" if isinf(result.number) else number
    joints = " against ".join(f"'{name}'" for name in result.joints[:2])
    message = f"the mass matrix {ratio}: joint {joints} moves almost no mass"
    yield Finding(context.model.joints_by_name[first].at, message)
