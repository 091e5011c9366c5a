"""The inertia tensor differs from that of the link's shape.

The tensor is possible, but a solid of uniform density has clearly larger or smaller moments, or
other principal axes. Moments of hollow parts are up to twice as large, and those of a part with a
motor in its centre are smaller; otherwise the numbers were guessed. The effect is small for a light
link, or a link that is fixed to a heavy one; a wheel or an arm moves incorrectly. Write the tensor
of the shape, or suppress this for a link whose tensor you know. It is a warning if the tensor is
exactly that of a cylinder with radius and length exchanged.

Sources:
    Moments of inertia: https://en.wikipedia.org/wiki/List_of_moments_of_inertia
    Gazebo Classic, inertia: https://classic.gazebosim.org/tutorials?tut=inertia
"""

from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Severity, rule
from urdfkit.robot.inertials.defects import InertiaDefect
from urdfkit.robot.inertials.diagnosis import diagnose_unlike_shape
from urdfkit.robot.inertials.tensor_fix import advice, replacement
from urdfkit.robot.inertials.tensor_text import describe_solid, format_moments
from urdfkit.robot.samples import collision_xml, inertial_xml, link_xml

BAD = link_xml(
    "imu", collision_xml('<box size="0.05 0.05 0.05"/>'), inertial_xml("0.01", "1e-6 1e-6 1e-6")
)
FIXED = GOOD = BAD.replace('"1e-6"', '"4.16667e-06"')


#: Beginning of a cause that is no coincidence: round moments are often four times too large.
_EXCHANGED = "was computed with the radius as the length"


@rule(
    Severity.INFO,
    confidence=Confidence.INFERRED,
    help="compute ixx, iyy and izz from mass and size (urdfkit explain INE006 has the formulas)",
    computes_fix=True,
)
def check(context: Context) -> Findings:
    masses = context.masses
    for inertia in masses.defects.get(InertiaDefect.UNLIKE_SHAPE, ()):
        assert inertia.expected is not None
        diagnosis = diagnose_unlike_shape(inertia, masses)
        ratios = inertia.ratios(inertia.expected)
        yield Finding(
            inertia.at,
            f"link '{inertia.link.name}' of {inertia.mass:g} kg has moments of inertia of "
            f"{format_moments(inertia.diagonal)}; {describe_solid(inertia)}",
            advice(inertia, diagnosis),
            replacement(inertia, diagnosis.tensor),
            weight=max(*ratios, 1 / max(min(ratios), 1e-9)),
            group_key="other shape",
            severity=Severity.WARNING if diagnosis.cause.startswith(_EXCHANGED) else None,
        )
