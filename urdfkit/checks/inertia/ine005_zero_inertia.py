"""A link that a joint moves has a mass, but no moment of inertia about some axis.

The link does not resist rotation about that axis: the equations of motion have no solution, or
engines divide by zero, and the link spins or vanishes. MuJoCo rejects the robot. A tensor of zeros
is the result of a failed export, or of too few decimal places; compute it from mass and size, or
use the tensor and centre of mass of the left/right counterpart. A single zero moment was rounded,
or a CAD program exported a wire or a surface: give the part its thickness, as even a rod has
`mass / 2 * radius^2` about its length. A single zero moment is a warning, and so is a link of at
most a gram, which is a placeholder for a part that a plugin of Gazebo computes, a tensor that is
not zero, but less than 1e-15 kg·m², and a link that carries others by joints about other axes, as a
steering carries its wheel: their inertia resists the rotation.

If MuJoCo is a target, every link with a moment below 1e-14 kg·m² is an error, also if it is fixed
to a heavier link: MuJoCo reads each tensor before it merges links. A tensor of zeros is allowed for
a link that is fixed to another one: it has no inertia.

Sources:
    MuJoCo, user_objects.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_objects.cc
    gz_ros2_control, test_ackermann_drive.xacro.urdf, whose steering links have none: https://github.com/ros-controls/gz_ros2_control
    robotology/icub-models#269: https://github.com/robotology/icub-models/issues/269
    Moments of inertia: https://en.wikipedia.org/wiki/List_of_moments_of_inertia
"""

from collections.abc import Iterator

from urdfkit.checks.inertia.copies import together
from urdfkit.core.spatial import dot, rotate
from urdfkit.core.words import more_like_this
from urdfkit.lint.rules import Context, Finding, Findings, Fix, Related, Severity, rule
from urdfkit.robot.inertia import principal_moments
from urdfkit.robot.inertials.defects import MAX_PART_DENSITY, MIN_PART_DENSITY
from urdfkit.robot.inertials.diagnosis import MAX_RELATED
from urdfkit.robot.inertials.link_comparison import LARGEST_PART, LinkInertia
from urdfkit.robot.inertials.masses import LEAST_MOMENT, PAIR_MOMENTS
from urdfkit.robot.inertials.mirroring import along_inertial, center_edits, mirror_image
from urdfkit.robot.inertials.tensor_entries import is_possible
from urdfkit.robot.inertials.tensor_fix import replacement
from urdfkit.robot.inertials.tensor_text import describe_solid, format_moments
from urdfkit.robot.joint import Joint
from urdfkit.robot.kinematics import direction, frames
from urdfkit.robot.link import Tensor
from urdfkit.robot.samples import collision_xml, inertial_xml, joint_xml, link_xml, robot_xml
from urdfkit.text.diagnostic import Edit

BAD = robot_xml(
    link_xml("base"),
    link_xml(
        "arm", collision_xml('<cylinder radius="0.05" length="0.2"/>'), inertial_xml("0.5", "0 0 0")
    ),
    joint_xml("continuous"),
)
FIXED = GOOD = BAD.replace('ixx="0"', 'ixx="0.00197917"').replace(
    '"0" iyz="0" izz="0"', '"0.00197917" iyz="0" izz="0.000625"'
)

#: In kg: thrusters of UUV Simulator are links of a gram without a tensor.
PLACEHOLDER_MASS = 0.001

#: Cosine of the angle between two axes that count as one.
_PARALLEL = 0.999

#: In kg/m³: the density of air is 1.2.
MIN_DENSITY = 1.0

#: In kg/m³: five times that of osmium. The collision of a thruster is a cylinder of a micrometre.
MAX_DENSITY = 1e5

#: In m.
MILLIMETRE = 0.001


@rule(
    Severity.ERROR,
    help="compute the tensor from mass and size (urdfkit explain INE006 has the formulas)",
    computes_fix=True,
)
def check(context: Context) -> Findings:
    yield from together(_zero(context))
    thin = sorted(_thin(context), key=lambda finding: -finding.weight)
    if thin:
        worst, *others = thin
        yield worst._replace(
            message=worst.message + more_like_this(len(others)),
            related=tuple(Related(other.span, other.message) for other in others[:MAX_RELATED]),
            severity=worst.severity or Severity.WARNING,
        )


def _zero(context: Context) -> Iterator[tuple[LinkInertia, Finding]]:
    masses = context.masses
    is_rejected = any(target.least_moment for target in context.given_facts)
    carrying = _carrying(context)
    for body in masses.without_inertia:
        assert body.joint is not None
        for link, _ in body.links:
            if inertia := masses.by_name.get(link.name):
                finding = _finding(inertia, body.joint, context)
                is_placeholder = body.mass <= PLACEHOLDER_MASS or masses.moments_of(body)[2] > 0
                is_harmless = is_placeholder or body.top.name in carrying
                if is_harmless and not is_rejected:
                    finding = finding._replace(severity=Severity.WARNING)
                yield inertia, finding


def _carrying(context: Context) -> set[str]:
    """The moving links on which joints carry others, which resist a rotation with their inertia.

    A link that turns about the same axis itself does not.
    """
    masses, placed = context.masses, frames(context.tree, {})
    carrying = set()
    for body in masses.bodies:
        if body.joint and masses.moments_of(body)[2] > LEAST_MOMENT:
            carrier = masses.body_of[body.joint.parent_name]
            axes = [
                rotate(placed[joint.child_name].rotation, direction(joint))
                for joint in (body.joint, carrier.joint)
                if joint and joint.is_rotational
            ]
            if len(axes) < 2 or abs(dot(*axes)) < _PARALLEL:
                carrying.add(carrier.top.name)
    return carrying


def _finding(inertia: LinkInertia, joint: Joint, context: Context) -> Finding:
    help, fix = _from_counterpart(inertia, context) or _from_shape(inertia)
    message = (
        f"link '{inertia.link.name}' of {inertia.mass:g} kg has no moment of inertia and is moved "
        f"by the {joint.kind} joint '{joint.name}'"
    )
    return Finding(inertia.at, message, help, fix, weight=inertia.mass)


def _from_counterpart(inertia: LinkInertia, context: Context) -> tuple[str, Fix | None] | None:
    """Help and fix with the tensor of the counterpart; None if the shape gives about the same."""
    other = context.masses.counterpart(inertia)
    if other is None or other.is_negligible or not is_possible(other.tensor):
        return None
    if _matches_shape(inertia, other):
        return None
    image = mirror_image(inertia, other, frames(context.tree, {}))
    fix = image and _fix(
        inertia, along_inertial(inertia, image.tensor), center_edits(inertia, image.center)
    )
    moments = format_moments(other.diagonal)
    return f"its counterpart '{other.name}' of the same mass has {moments}", fix


def _matches_shape(inertia: LinkInertia, other: LinkInertia) -> bool:
    """True if the tensor of ``other`` is about that of the shape of this link."""
    if not inertia.is_measured or inertia.expected is None:
        return False
    pairs = zip(principal_moments(inertia.expected), other.moments, strict=True)
    return all(max(pair) <= PAIR_MOMENTS * min(pair) for pair in pairs)


def _from_shape(inertia: LinkInertia) -> tuple[str, Fix | None]:
    if not inertia.is_measured or inertia.solid is None or inertia.expected is None:
        return "", None
    # No tensor follows from a placeholder mass.
    if inertia.mass < MIN_DENSITY * inertia.solid.volume:
        size = f"{inertia.solid.volume:.3g} m³"
        help = f"write the mass of the link, which has {size}, and its tensor"
        density_in_mm = inertia.mass / (inertia.solid.volume * MILLIMETRE**3)
        is_large = max(inertia.solid.bounds.edges) > LARGEST_PART
        if is_large and MIN_PART_DENSITY < density_in_mm < MAX_PART_DENSITY:
            help = f"the shape has {size}: scale it if it is in mm, and write the tensor"
        return help, None
    if inertia.mass > MAX_DENSITY * inertia.solid.volume:  # a placeholder shape
        size = f"{inertia.solid.volume:.1g} m³"
        return f"write the tensor of the real part: the shape has {size}", None
    # A failed export writes zeros here, too.
    is_unplaced = not any(inertia.inertial.origin.position)
    center = inertia.solid.properties(inertia.mass).center
    edits = center_edits(inertia, center) if is_unplaced else ()
    return describe_solid(inertia), _fix(inertia, inertia.expected, edits or ())


def _fix(inertia: LinkInertia, tensor: Tensor, center: tuple[Edit, ...] | None) -> Fix | None:
    """Writes a tensor, and the centre of mass if it differs."""
    fix = replacement(inertia, tensor)
    if fix is None or center is None:
        return None
    title = " and ".join([fix.title, *(f'xyz="{edit.text}"' for edit in center)])
    return Fix(title, (*fix.edits, *center))


def _thin(context: Context) -> Findings:
    masses = context.masses
    rejected = list(_rejected(context))
    yield from rejected
    if rejected:
        return
    for body in masses.singular:
        assert body.joint is not None
        inertia = masses.by_name.get(body.top.name)
        if inertia is not None:
            low, middle, high = masses.moments_of(body)
            others = " with the links fixed to it" if len(body.links) > 1 else ""
            yield Finding(
                inertia.at,
                f"link '{body.top.name}'{others}, moved by the {body.joint.kind} joint "
                f"'{body.joint.name}', has principal moments of inertia of {low:.1g}, "
                f"{middle:.3g} and {high:.3g} kg·m²: almost 0 about one axis",
                "write the moment about the thin axis as well: mass / 2 * radius^2 for a rod"
                if any(inertia.tensor)
                else "write the tensor of the link: it is 0",
                weight=body.mass,
            )


def _rejected(context: Context) -> Findings:
    """Tensors that a target rejects, of moving and of fixed links."""
    targets = [target for target in context.given_facts if target.least_moment]
    if not targets or context.mujoco.least_moment:
        return
    least = max(target.least_moment for target in targets)
    names = " and ".join(target.title for target in targets)
    for link in context.model.links:
        tensor = link.inertial.tensor if link.inertial else None
        if tensor is None or not any(tensor.value):
            continue
        low, middle, high = principal_moments(tensor.value)
        inertia = context.masses.by_name.get(link.name)
        if low < least and not (inertia and inertia.is_indefinite):
            yield Finding(
                tensor,
                f"link '{link.name}' has principal moments of inertia of {low:.1g}, {middle:.3g} "
                f"and {high:.3g} kg·m²: {names} rejects less than {least:g}",
                "write all three moments, or zeros for a frame that a fixed joint holds",
                weight=link.mass,
                severity=Severity.ERROR,
                targets=tuple(target.name for target in targets),
            )
