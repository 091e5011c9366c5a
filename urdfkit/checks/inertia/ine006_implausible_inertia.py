"""The inertia tensor is implausible for the mass and the shapes of the link.

- Too large: more than twice `mass * r^2`, where r is the distance of the farthest point of the
  shapes from the centre of mass; no body of that extent has more. Such a link resists rotation like
  a flywheel: Gazebo needs a huge torque to accelerate a wheel, and light links make the solver
  unstable.
- Too small: less than a hundredth of the moments of the uniform solid; no mass in the middle
  explains that. Controllers tuned on it oscillate, and next to heavier links the solver becomes
  unstable.
- About the wrong axes: the moments are those of the shape in another order, or a product of inertia
  has the wrong sign. URDF rotates the tensor with the `<origin>` of the `<inertial>`, not with that
  of the collision or visual. Swap the values, or give the `<inertial>` the `rpy` of the shape.

A tensor that is too large on purpose is an info: one next to a comment such as "to stabilize
simulation". A shape of at most a few millimetres marks a place, and no tensor is compared with it.

The tensor comes from another link or in another unit, is a placeholder, or was not updated with the
mass. Compute it from mass and size: for a box of x, y, z it is `ixx = mass / 12 * (y*y + z*z)`, for
a cylinder along z `ixx = iyy = mass / 12 * (3*r*r + l*l)` and `izz = mass / 2 * r*r`, for a sphere
`2 / 5 * mass * r*r`.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    Gazebo Classic, inertia: https://classic.gazebosim.org/tutorials?tut=inertia
    Moments of inertia: https://en.wikipedia.org/wiki/List_of_moments_of_inertia
"""

from urdfkit.checks.inertia.copies import together
from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Severity, rule
from urdfkit.robot.inertia import principal_moments
from urdfkit.robot.inertials.defects import InertiaDefect
from urdfkit.robot.inertials.diagnosis import (
    advice,
    as_solid,
    of_unlike_shape,
    of_wrong_axes,
    opposite,
    replacement,
    values,
)
from urdfkit.robot.inertials.link_comparison import LinkInertia
from urdfkit.robot.inertials.masses import Masses
from urdfkit.robot.samples import collision_xml, inertial_xml, link_xml
from urdfkit.text.comments import comments

BAD = link_xml(
    "wheel",
    collision_xml('<cylinder radius="0.06" length="0.05"/>'),
    inertial_xml("0.5", "0.1 0.1 0.1"),
)
FIXED = GOOD = BAD.replace(
    'ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"',
    'ixx="0.000554167" ixy="0" ixz="0" iyy="0.000554167" iyz="0" izz="0.0009"',
)

#: A radius of gyration this many times the reach of the link is named.
_STRIKING = 10.0

#: In a comment beside a tensor that is too large on purpose.
_PURPOSES = (b"stabilis", b"stabiliz")

#: Times its own mass that the joints of a link carry from where on its moments stay as they are.
_CARRIED = 300.0

#: A share in the inertia of a whole rigid body that is named.
_SHARE = 0.1


@rule(
    Severity.WARNING,
    help="compute ixx, iyy and izz from mass and size (urdfkit explain INE006 has the formulas)",
    computes_fix=True,
)
def check(context: Context) -> Findings:
    masses = context.masses
    too_large = masses.defects.get(InertiaDefect.TOO_LARGE, ())
    # One value for all small links, below which no moment goes, is one decision.
    loads = {body.top.name: load for body, load in masses.overloaded(_CARRIED)} if too_large else {}
    found = ((one, _too_large(one, masses, loads.get(one.link.name))) for one in too_large)
    yield from together(found, by=lambda one: max(one.diagonal))
    too_small = masses.defects.get(InertiaDefect.TOO_SMALL, ())
    yield from together((one, _too_small(one, masses)) for one in too_small)
    yield from map(_wrong_axes, masses.defects.get(InertiaDefect.WRONG_AXES, ()))


def _too_large(one: LinkInertia, masses: Masses, load: float | None) -> Finding:
    """Of a link whose joints carry a load in kg; None unless that is far more than the link."""
    diagnosis = of_unlike_shape(one, masses)
    if load is None:
        help, fix = advice(one, diagnosis), replacement(one, diagnosis.tensor)
    else:  # a steering link of 5 g between chassis and wheel is stable by its inertia alone
        help, fix = f"give it more mass first: its joints carry {load:.3g} kg", None
    high, bound = one.moments[2], one.largest_possible
    return Finding(
        one.at,
        f"link '{one.link.name}': {high:.3g} kg·m² is {high / bound:.3g} times the most that "
        f"{one.mass:g} kg can have within {one.reach:.3g} m of the centre of mass; "
        f"{as_solid(one)}{_radius(one)}{_share(one, masses)}",
        help,
        fix,
        confidence=Confidence.INFERRED,
        weight=high / bound,
        severity=Severity.INFO if _is_deliberate(one) else None,
    )


def _is_deliberate(one: LinkInertia) -> bool:
    """True where a comment in the line of the tensor gives a purpose."""
    span = one.at.tag_at.whole_span
    line_end = span.source.data.find(b"\n", span.end)
    following = comments(span.source.data[span.end : line_end if line_end >= 0 else None])
    return any(word in comment[1].lower() for comment in following for word in _PURPOSES)


def _radius(one: LinkInertia) -> str:
    radius = one.radius_of_gyration
    striking = radius > _STRIKING * one.reach
    return f"; its radius of gyration is {radius:.3g} m" if striking else ""


def _share(one: LinkInertia, masses: Masses) -> str:
    """How much of a simulated body's inertia it is, if fixed joints make it a part of one."""
    if sum(link.mass > 0 for link, _ in one.body.links) < 2:
        return ""
    share = one.moments[2] / masses.moments_of(one.body)[2]
    top = one.body.top.name
    return f"; it is {share:.0%} of what a simulator merges into '{top}'" if share > _SHARE else ""


def _too_small(one: LinkInertia, masses: Masses) -> Finding:
    diagnosis = of_unlike_shape(one, masses)
    assert one.expected is not None
    high, expected = one.moments[2], principal_moments(one.expected)[2]
    return Finding(
        one.at,
        f"link '{one.link.name}' of {one.mass:g} kg has at most {high:.3g} kg·m², "
        f"1/{expected / high:.0f} of its shape; {as_solid(one)}",
        advice(one, diagnosis),
        replacement(one, diagnosis.tensor),
        confidence=Confidence.INFERRED,
        weight=expected / high,
    )


def _wrong_axes(one: LinkInertia) -> Finding:
    _, tensor = of_wrong_axes(one)
    flipped = opposite(one.tensor, tensor)
    fix = replacement(one, tensor)
    message = _signs(one, flipped) if flipped else _moments(one)
    help = (
        f"{fix.title}, or rotate the <inertial>"
        if fix
        else "swap the values, or give the <inertial> the rpy of the shape"
    )
    return Finding(one.at, message, help, fix, confidence=Confidence.INFERRED)


def _moments(one: LinkInertia) -> str:
    return (
        f"link '{one.link.name}' has moments of inertia of {values(one.diagonal)}"
        f" about x, y and z; {as_solid(one)} in its orientation"
    )


def _signs(one: LinkInertia, keys: list[str]) -> str:
    """Products of inertia, of which only the sign differs from that of the shape."""
    pairs = [(getattr(one.tensor, key), getattr(one.expected, key)) for key in keys]
    return (
        f"link '{one.link.name}' has "
        + " and ".join(f"{key} {old:.3g}" for key, (old, _) in zip(keys, pairs, strict=True))
        + f" kg·m², with the sign opposite to that of the solid {one.solid}, which has "
        + " and ".join(f"{new:.3g}" for _, new in pairs)
    )
