"""An inertia tensor is a placeholder such as 1, 1, 1.

A moment of 1 kg·m² is that of a car wheel: a link of an arm or a finger of a gripper resists
rotation like one, so motors stall, the robot oscillates, and the simulation does not predict the
real robot. Take the tensor from the CAD program, or compute it from mass and size; a box around the
mesh is accurate enough.

Sources:
    Gazebo Classic, inertia: https://classic.gazebosim.org/tutorials?tut=inertia
    measured: a tensor of ones in 122 of 676 public models
"""

from urdfkit.checks.inertia.copies import together
from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Severity, rule
from urdfkit.mesh.samples import PLATE
from urdfkit.robot.inertials.defects import InertiaDefect
from urdfkit.robot.inertials.link_comparison import LinkInertia
from urdfkit.robot.inertials.tensor_text import format_moments
from urdfkit.robot.samples import inertial_xml, link_xml, visual_xml

BAD = link_xml("arm", visual_xml('<mesh filename="arm.stl"/>'), inertial_xml("1", "1 1 1"))
GOOD = BAD.replace('="1" ixy', '="0.012" ixy').replace(
    '="1" iyz="0" izz="1"', '="0.011" iyz="0" izz="0.002"'
)
FILES = {"arm.stl": PLATE}


@rule(
    Severity.WARNING,
    confidence=Confidence.INFERRED,
    help="take the tensor from the CAD program, or compute it for a box around the link",
)
def check(context: Context) -> Findings:
    links = context.masses.defects.get(InertiaDefect.PLACEHOLDER, ())
    yield from together((inertia, _finding(inertia)) for inertia in links)


def _finding(inertia: LinkInertia) -> Finding:
    message = (
        f"link '{inertia.link.name}' of {inertia.mass:g} kg: placeholder inertia "
        f"{format_moments(inertia.diagonal)} (radius of gyration "
        f"{inertia.radius_of_gyration:.3g} m)"
    )
    return Finding(inertia.at, message, weight=inertia.radius_of_gyration)
