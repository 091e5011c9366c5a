"""A link and its left/right counterpart differ in mass, inertia or centre of mass.

Mirror images have the same mass and the same principal moments. If one side has clearly more, a
decimal point is misplaced, or only one side was edited. The robot pulls to one side, and a
controller tuned for one hand oscillates with the other. Compare the two, and give both the right
value.

In the plane y = 0 of the root, the mirror image of a link has the y of its centre of mass, ixy and
iyz with the other sign. One that would be the mirror image of its counterpart with another sign is
reported if all other pairs are mirror images. Weights that balance the robot may differ.

Sources:
    robotology/icub-models#269: https://github.com/robotology/icub-models/issues/269
"""

import re

from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Related, Severity, rule
from urdfkit.robot.inertials.link_comparison import LinkInertia
from urdfkit.robot.inertials.masses import unlike
from urdfkit.robot.inertials.mirror_images import WrongSign, wrong_signs
from urdfkit.robot.inertials.tensor_text import format_moments
from urdfkit.robot.samples import hand_xml, inertial_xml

_ORIGINS = ['<origin xyz="0 0.02 0"/>'], ['<origin xyz="0 -0.02 0"/>']
GOOD = hand_xml("fixed", *_ORIGINS, inertial_xml("0.015", "2.4e-6 2.4e-6 7.5e-7"))
BAD = '"0.15"'.join(GOOD.rsplit('"0.015"', 1))
#: Words in the names of weights that balance a robot.
_BALANCES = r"(?i)ballast|counter_?weight|trim"


@rule(Severity.WARNING, help="compare the two, and give both the right value")
def check(context: Context) -> Findings:
    for left, right in context.masses.asymmetric_pairs:
        if unlike(left, right) != "mass":
            yield _of_inertia(left, right)
        elif not re.search(_BALANCES, left.link.name):
            yield _of_mass(left, right)
    for wrong in wrong_signs(context.masses):
        yield _of_sign(wrong)


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


def _of_sign(wrong: WrongSign) -> Finding:
    is_product = wrong.what.startswith("i")
    name = wrong.what if is_product else f"{wrong.what} of the centre of mass"
    unit = "kg·m²" if is_product else "m"
    return Finding(
        wrong.at,
        f"link '{wrong.right.name}': {name} is {wrong.value:g} {unit}; with the other sign the "
        f"link would be the mirror image of its counterpart '{wrong.left.name}', as others are",
        f"write {-wrong.value:g}, or correct the counterpart",
        related=(Related(wrong.left.at.span, f"the inertia of '{wrong.left.name}'"),),
        confidence=Confidence.INFERRED,
    )
