"""A link without mass has an inertia tensor.

Gazebo adds the tensor of a link that it merges into its parent, even without mass: a sensor frame
of 0 kg with a tensor of 1, 1, 1 multiplies the inertia of a small robot. Other programs ignore it.
A frame needs no `<inertial>`; a real part needs a mass.

Sources:
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
"""

from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.robot.inertials.link_comparison import NOISE
from urdfkit.robot.inertials.tensor_text import format_moments
from urdfkit.robot.samples import inertial_xml, joint_xml, link_xml, robot_xml
from urdfkit.ros.targets import GAZEBO

BAD = robot_xml(
    link_xml("base", inertial_xml("3", "0.03 0.03 0.05")),
    link_xml("sonar", inertial_xml("0", "1 1 1")),
    joint_xml("fixed", name="sonar_mount", child="sonar"),
)
GOOD = BAD.replace('"1"', '"0"')


@rule(
    Severity.INFO,
    help="remove the <inertial>, or write the mass of the part",
    by_target=dict.fromkeys(GAZEBO, Severity.WARNING),
)
def check(context: Context) -> Findings:
    masses = context.masses
    for link in context.model.links:
        inertial, body = link.inertial, masses.body_of.get(link.name)
        if inertial is None or inertial.mass is None or inertial.tensor is None:
            continue
        tensor = inertial.tensor.value
        merged = body is not None and body.top is not link
        if merged and inertial.mass.value == 0 and max(map(abs, tensor)) > NOISE:
            moments = format_moments((tensor.ixx, tensor.iyy, tensor.izz))
            message = f"link '{link.name}' has a mass of 0 kg and moments of inertia of {moments}"
            yield Finding(inertial.tensor, message, weight=max(map(abs, tensor)))
