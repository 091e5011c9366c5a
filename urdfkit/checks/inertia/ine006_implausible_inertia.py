"""The inertia tensor is implausible for the mass and the shapes of the link.

- Too large: more than twice `mass * r^2`, where r is the distance of the farthest point of the
  shapes from the centre of mass; no body of that extent has more. Such a link resists rotation like
  a flywheel: Gazebo needs a huge torque to accelerate a wheel, and light links make the solver
  unstable.
- Too small: less than a hundredth of the moments of the uniform solid; even a concentrated mass
  does not explain that. Controllers tuned on it oscillate, and next to heavier links the solver
  becomes unstable.
- About the wrong axes: the moments are those of the shape in another order, or of a rod or a wheel
  that points another way, or a product of inertia has the wrong sign. URDF rotates the tensor with
  the `<origin>` of the `<inertial>`, not with that of the collision or visual. Swap the values, or
  give the `<inertial>` the `rpy` of the shape.
- About the wrong point: the moments are those of the shape about the origin of the link, and at
  least three times those about the centre of mass. Reduce them by mass * distance^2.

A tensor that is too large on purpose, next to a comment such as "to stabilize simulation", is an
info. A shape of at most a few millimetres is a marker, and no tensor is compared with it.

The tensor was copied from another link, is in another unit, is a placeholder, or was not updated
with the mass. Compute it from mass and size: for a box of x, y, z `ixx = mass / 12 * (y*y + z*z)`,
for a cylinder along z `ixx = iyy = mass / 12 * (3*r*r + l*l)` and `izz = mass / 2 * r*r`, for a
sphere `2 / 5 * mass * r*r`.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    Gazebo Classic, inertia: https://classic.gazebosim.org/tutorials?tut=inertia
    Moments of inertia: https://en.wikipedia.org/wiki/List_of_moments_of_inertia
"""

import os

from urdfkit.checks.inertia.copies import together
from urdfkit.core.spatial import times
from urdfkit.core.words import rounded
from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Severity, rule
from urdfkit.robot.inertia import principal_moments
from urdfkit.robot.inertials.defects import InertiaDefect
from urdfkit.robot.inertials.diagnosis import diagnose_unlike_shape, explain_wrong_axes
from urdfkit.robot.inertials.link_comparison import LinkInertia
from urdfkit.robot.inertials.masses import Masses
from urdfkit.robot.inertials.tensor_entries import opposite
from urdfkit.robot.inertials.tensor_fix import advice, replacement
from urdfkit.robot.inertials.tensor_text import describe_solid, format_moments
from urdfkit.robot.samples import collision_xml, inertial_xml, link_xml
from urdfkit.robot.symmetry import pairs
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

#: Ratio of radius of gyration to reach of the link, above which the message contains it.
_SHOWN_RATIO = 10.0

#: Words of a comment next to a tensor that is too large on purpose.
_PURPOSES = (b"stabilis", b"stabiliz")

#: Ratio of the mass that the joints of a link carry to its own, above which no fix is offered.
_CARRIED = 300.0

#: In kg: no part that a joint moves is so light, and no tensor follows from its mass.
_WEIGHTLESS = 1e-5

#: Products of inertia below this part of the largest moment hardly turn the axes.
_SMALL_PRODUCT = 0.05

_TURN = "swap the values, or give the <inertial> the rpy of the shape"

#: Ratio of the largest moments from which swapped values are not the only mistake.
_WRONG_SIZE = 2.0

#: Cosine of the angle to an axis of the frame up to which two of them were exchanged.
_ALONG = 0.95

#: Shares in the inertia of the rigid body that the message contains.
_MIN_SHARE, _MAX_SHARE = 0.1, 0.99


@rule(
    Severity.WARNING,
    confidence=Confidence.INFERRED,
    help="compute ixx, iyy and izz from mass and size (urdfkit explain INE006 has the formulas)",
    computes_fix=True,
)
def check(context: Context) -> Findings:
    masses = context.masses
    too_large = masses.defects.get(InertiaDefect.TOO_LARGE, ())
    # A common lower bound for the moments of all small links is one finding.
    loads = {body.top.name: load for body, load in masses.overloaded(_CARRIED)} if too_large else {}
    found = (
        (inertia, _too_large(inertia, masses, loads.get(inertia.link.name)))
        for inertia in too_large
    )
    yield from together(found, by=lambda inertia: max(inertia.diagonal))
    too_small = masses.defects.get(InertiaDefect.TOO_SMALL, ())
    yield from together((inertia, _too_small(inertia, masses)) for inertia in too_small)
    yield from map(_wrong_axes, masses.defects.get(InertiaDefect.WRONG_AXES, ()))
    yield from map(_about_origin, masses.defects.get(InertiaDefect.ABOUT_ORIGIN, ()))


def _too_large(inertia: LinkInertia, masses: Masses, load: float | None) -> Finding:
    """The finding.

    Args:
        load: mass in kg that the joints of the link carry; None unless far more than its own.
    """
    diagnosis = diagnose_unlike_shape(inertia, masses)
    if inertia.body.joint and inertia.body.mass <= _WEIGHTLESS:
        help, fix = "write the mass of the part, and its tensor", None
    elif load is None:
        help, fix = advice(inertia, diagnosis), replacement(inertia, diagnosis.tensor)
    else:  # only its inertia stabilises a steering link of 5 g between chassis and wheel
        help, fix = f"give it more mass first: its joints carry {load:.3g} kg", None
    high, bound = inertia.moments[2], inertia.largest_possible
    return Finding(
        inertia.at,
        f"link '{inertia.link.name}': {high:.3g} kg·m² is {high / bound:.3g} times the most that "
        f"{inertia.mass:g} kg can have within {inertia.reach:.3g} m of the centre of mass; "
        f"{describe_solid(inertia)}{_radius(inertia)}{_share(inertia, masses)}",
        help,
        fix,
        weight=high / bound,
        severity=Severity.INFO if _is_deliberate(inertia) else None,
    )


def _is_deliberate(inertia: LinkInertia) -> bool:
    """True if a comment on the line of the tensor states a purpose."""
    span = inertia.at.tag_at.whole_span
    line_end = span.source.data.find(b"\n", span.end)
    following = comments(span.source.data[span.end : line_end if line_end >= 0 else None])
    return any(word in comment[1].lower() for comment in following for word in _PURPOSES)


def _radius(inertia: LinkInertia) -> str:
    radius = inertia.radius_of_gyration
    striking = radius > _SHOWN_RATIO * inertia.reach
    return f"; its radius of gyration is {radius:.3g} m" if striking else ""


def _share(inertia: LinkInertia, masses: Masses) -> str:
    """The share in the inertia of the rigid body, if fixed joints merge the link into one."""
    if sum(link.mass > 0 for link, _ in inertia.body.links) < 2:
        return ""
    share = inertia.moments[2] / masses.moments_of(inertia.body)[2]
    if not _MIN_SHARE < share < _MAX_SHARE:
        return ""
    return f"; it is {share:.0%} of what a simulator merges into '{inertia.body.top.name}'"


def _too_small(inertia: LinkInertia, masses: Masses) -> Finding:
    diagnosis = diagnose_unlike_shape(inertia, masses)
    assert inertia.expected is not None
    high, expected = inertia.moments[2], principal_moments(inertia.expected)[2]
    return Finding(
        inertia.at,
        f"link '{inertia.link.name}' of {inertia.mass:g} kg has at most {high:.3g} kg·m², "
        f"1/{expected / high:.0f} of its shape; {describe_solid(inertia)}",
        advice(inertia, diagnosis),
        replacement(inertia, diagnosis.tensor),
        weight=expected / high,
    )


def _wrong_axes(inertia: LinkInertia) -> Finding:
    if not inertia.is_at_wrong_axes:
        return _turned(inertia)
    _, tensor = explain_wrong_axes(inertia)
    flipped = opposite(inertia.tensor, tensor)
    fix = replacement(inertia, tensor)
    message = _signs(inertia, flipped) if flipped else _moments(inertia)
    if flipped and (other := _mesh_of_other_side(inertia)):
        message += f"; '{other}' is the mesh of the other side"
        help = "show the mesh of this side, which fits the tensor"
        return Finding(inertia.at, message, help)
    help = f"{fix.title}, or rotate the <inertial>" if fix else _TURN
    return Finding(inertia.at, message, help, fix)


def _about_origin(inertia: LinkInertia) -> Finding:
    fix = replacement(inertia, inertia.about_center)
    return Finding(
        inertia.at,
        f"link '{inertia.link.name}' has moments of inertia of {format_moments(inertia.diagonal)}, "
        f"as about the origin of the link; {describe_solid(inertia)} about its centre of mass",
        f"write those about the centre of mass{f': {fix.title}' if fix else ''}",
        fix,
    )


def _mesh_of_other_side(inertia: LinkInertia) -> str:
    """The mesh whose name differs from that of the link in its side alone; empty without one."""
    names = [os.path.basename(body.file.value) for body in inertia.link.bodies if body.file]
    return next((n for n in names if pairs((inertia.link.name, os.path.splitext(n)[0]))), "")


def _turned(inertia: LinkInertia) -> Finding:
    """A tensor of a rod or a wheel that points another way than the shape."""
    tensor = inertia.tensor
    if max(map(abs, (tensor.ixy, tensor.ixz, tensor.iyz))) < _SMALL_PRODUCT * inertia.moments[2]:
        help = _TURN if _is_of_size(inertia) else ""
        return Finding(inertia.at, _moments(inertia), help)
    assert inertia.turned_axis is not None
    axes = [axis if max(axis, key=abs) > 0 else times(axis, -1) for axis in inertia.turned_axis]
    own, other = (rounded(axis, 2) for axis in axes)
    help = "correct the signs of the products, or give the <inertial> the rpy of the shape"
    if all(max(axis) > _ALONG for axis in axes):
        one, two = sorted("xyz"[axis.index(max(axis))] for axis in axes)
        help = f"swap i{one}{one} and i{two}{two}, and the products with them"
    return Finding(
        inertia.at,
        f"link '{inertia.link.name}': the tensor is that of a body with the axis {own}, but the "
        f"solid {inertia.solid} has the axis {other}",
        help,
    )


def _is_of_size(inertia: LinkInertia) -> bool:
    """True if the largest moment is about that of the shape."""
    if (tensor := inertia.expected) is None:
        return True
    low, high = sorted((max(inertia.diagonal), max(tensor.ixx, tensor.iyy, tensor.izz)))
    return high < _WRONG_SIZE * low


def _moments(inertia: LinkInertia) -> str:
    return (
        f"link '{inertia.link.name}' has moments of inertia of {format_moments(inertia.diagonal)}"
        f" about x, y and z; {describe_solid(inertia)} in its orientation"
    )


def _signs(inertia: LinkInertia, keys: list[str]) -> str:
    """Message for products of inertia that differ from those of the shape only in their sign."""
    pairs = [(getattr(inertia.tensor, key), getattr(inertia.expected, key)) for key in keys]
    return (
        f"link '{inertia.link.name}' has "
        + " and ".join(f"{key} {old:.3g}" for key, (old, _) in zip(keys, pairs, strict=True))
        + f" kg·m², with the sign opposite to that of the solid {inertia.solid}, which has "
        + " and ".join(f"{new:.3g}" for _, new in pairs)
    )
