"""A link and its left/right counterpart differ in mass or inertia.

Mirror images have the same mass and the same principal moments. If one side has clearly more, a
decimal point is misplaced, or only one side was edited. The robot pulls to one side, and a
controller tuned for one hand oscillates with the other. Compare the two, and give both the right
value.

Sources:
    robotology/icub-models#269: https://github.com/robotology/icub-models/issues/269
"""

from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Related, Severity, rule
from urdfkit.robot.inertials.diagnosis import format_moments
from urdfkit.robot.inertials.link_comparison import LinkInertia
from urdfkit.robot.inertials.masses import unlike
from urdfkit.robot.samples import hand_xml, inertial_xml

_ORIGINS = ['<origin xyz="0 0.02 0"/>'], ['<origin xyz="0 -0.02 0"/>']
GOOD = hand_xml("fixed", *_ORIGINS, inertial_xml("0.015", "2.4e-6 2.4e-6 7.5e-7"))
BAD = '"0.15"'.join(GOOD.rsplit('"0.015"', 1))


@rule(Severity.WARNING, help="compare the two, and give both the right value")
def check(context: Context) -> Findings:
    for left, right in context.masses.asymmetric_pairs:
        yield _of_mass(left, right) if unlike(left, right) == "mass" else _of_inertia(left, right)


def _of_mass(left: LinkInertia, right: LinkInertia) -> Finding:
    assert left.inertial.mass is not None
    assert right.inertial.mass is not None
    ratio = max(left.mass, right.mass) / min(left.mass, right.mass)
    return Finding(
        right.inertial.mass,
        f"link '{right.link.name}' has {right.mass:g} kg, its counterpart '{left.link.name}' "
        f"{left.mass:g} kg: a factor of {ratio:.3g}",
        related=(Related(left.inertial.mass.span, f"'{left.link.name}' has {left.mass:g} kg"),),
        confidence=Confidence.INFERRED,
        weight=ratio,
    )


def _of_inertia(left: LinkInertia, right: LinkInertia) -> Finding:
    return Finding(
        right.at,
        f"link '{right.link.name}' has principal moments of inertia of "
        f"{format_moments(right.moments)}, its counterpart '{left.link.name}' of the same mass "
        f"{format_moments(left.moments)}",
        related=(Related(left.at.span, f"the inertia of '{left.link.name}'"),),
        confidence=Confidence.INFERRED,
    )
