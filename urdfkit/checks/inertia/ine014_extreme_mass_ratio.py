"""A light link between joints carries more than a thousand times its own mass.

Iterative solvers, such as those of Gazebo, Bullet and PhysX (Isaac Sim), converge slowly with a
large mass ratio: joints separate, and the robot jitters or explodes. A light hand on a heavy arm is
not a problem, but a link of a gram that carries a kilogram is. Move mass from the heavy link to the
light one, or merge the two joints into one link.

Sources:
    gazebosim/gazebo-classic#895: https://github.com/gazebosim/gazebo-classic/issues/895
    robotology/icub-models#121: https://github.com/robotology/icub-models/issues/121
"""

from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.robot.samples import inertial_xml, joint_xml, link_xml, robot_xml
from urdfkit.ros.targets import GAZEBO

BAD = robot_xml(
    link_xml("base"),
    link_xml("steering", inertial_xml("0.005", "1e-6 1e-6 1e-6")),
    link_xml("wheel", inertial_xml("15", "0.35 0.35 0.675")),
    joint_xml("continuous", name="steer", child="steering"),
    joint_xml("continuous", name="axle", parent="steering", child="wheel"),
)
GOOD = BAD.replace('"0.005"', '"1"').replace('"1e-6"', '"0.001"')


@rule(
    Severity.INFO,
    help="move mass from the heavy links to the light one, or merge the two joints into one",
    by_target=dict.fromkeys(GAZEBO, Severity.WARNING),
    options={"ratio": 1000.0},
)
def check(context: Context) -> Findings:
    bound = check.option(context, "ratio")
    for body, load in context.masses.overloaded(bound):
        link = body.top
        mass = link.inertial.mass if link.inertial else None
        yield Finding(
            mass or link.at,
            f"link '{link.name}' has {body.mass:.3g} kg and carries {load:.3g} kg by joints, "
            f"{load / body.mass:.0f} times its own mass; solvers are stable up to {bound:g} times",
            weight=load / body.mass,
        )
