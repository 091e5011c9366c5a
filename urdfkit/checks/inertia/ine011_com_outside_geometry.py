"""The centre of mass is outside the shapes of the link.

Gravity then acts with a wrong lever arm: the robot tips over, arms need torque to hold still, and a
wheeled robot drives in circles. The centre of mass is in the link's own frame. Most often the
`<origin>` of the `<inertial>` was copied from the joint or from the visual of another link, or is
in millimetres: then the distance exceeds the length of the link. Smaller distances are reported if
a mistake explains them: a wrong sign, two swapped coordinates, or an `<origin>` left at zero while
the shapes are elsewhere. Inside the shapes, a wrong sign is reported if the centre of mass would
otherwise be exactly that of the solid.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    Gazebo Classic, inertia: https://classic.gazebosim.org/tutorials?tut=inertia
    measured: of 1300 public descriptions, 42 have a link whose centre a sign would bring inside.
"""

from math import inf

from urdfkit.core.words import spaced
from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Severity, rule
from urdfkit.robot.inertials.defects import (
    InertiaDefect,
    center_is_outside,
    center_mistake,
    mirrored_center,
)
from urdfkit.robot.samples import collision_xml, inertial_xml, link_xml

GOOD = link_xml(
    "caster", collision_xml('<sphere radius="0.05"/>'), inertial_xml("0.5", "0.0005 0.0005 0.0005")
)
BAD = GOOD.replace("<mass", '<origin xyz="-0.4 0 0"/>\n    <mass')


@rule(
    Severity.WARNING,
    confidence=Confidence.INFERRED,
    help="write the <origin> of the <inertial> in the link's own frame, in m",
)
def check(context: Context) -> Findings:
    for inertia in context.masses.defects.get(InertiaDefect.CENTER_OF_MASS, ()):
        distance = center_is_outside(inertia)
        assert distance is not None
        mistake = center_mistake(inertia)
        bounds, center = inertia.bounds, inertia.inertial.origin.position
        yield Finding(
            inertia.inertial.at.child_or_self("origin"),
            f"link '{inertia.link.name}': the centre of mass at {spaced(center, 3)} m is "
            f"{distance:.3g} m outside the shapes, which are {max(bounds.edges):.3g} m long "
            f"about {spaced(bounds.center, 3)}{f'; it {mistake}' if mistake else ''}",
            weight=distance / max(bounds.edges) if any(bounds.edges) else inf,
            group_key="outside",
        )
    outside = context.masses.defects.get(InertiaDefect.CENTER_OF_MASS, ())
    for inertia in context.masses.inertias:
        if inertia not in outside and (mirrored := mirrored_center(inertia)):
            axis, expected = mirrored
            value = expected["xyz".index(axis)]
            yield Finding(
                inertia.inertial.at.child_or_self("origin"),
                f"link '{inertia.link.name}': the centre of mass is that of the solid "
                f"{inertia.solid}, but for the sign of {axis}",
                f"write {value:.4g} for {axis}",
            )
