"""Compares an SDF model with the robot that it was converted from."""

from collections.abc import Iterator, Mapping

from urdfkit.core.grouping import by_key
from urdfkit.core.spatial import Transform, length, minus
from urdfkit.lint.context import Context
from urdfkit.output.conversion.random_poses import random_poses
from urdfkit.output.conversion.result import Proof
from urdfkit.output.conversion.sdf_reader import Sdf, pose, text
from urdfkit.output.conversion.sdf_values import SNAP
from urdfkit.robot.inertia import ZERO, MassProperties, combined
from urdfkit.robot.joint import Joint
from urdfkit.robot.kinematics import frames, positions
from urdfkit.robot.link import Tensor
from urdfkit.robot.rigid_bodies import properties_of
from urdfkit.robot.tree import KinematicTree
from urdfkit.robot.values import number
from urdfkit.ros.gazebo.conversion import SdfConversion
from urdfkit.text.document import Element

#: Number of random poses at which frames are compared.
POSES = 20
#: Bounds: of frames and centres of mass in m; of other differences relative to the largest entry.
MAX_OFFSET, MAX_ERROR = 1e-9, 1e-6
#: Bound of inertia where sdformat rounds a pitch near 90 degrees to 90 degrees.
ROUNDED = 1e-2


def prove(sdf: Sdf, robot: Context, conversion: SdfConversion) -> Proof:
    """Compare an SDF with a robot.

    Args:
        conversion: has the links that Gazebo drops.
    """
    tree = robot.tree
    names = [name for name in tree.parents if name not in conversion.dropped and name != "world"]
    worst = (0.0, "")
    for sample in random_poses(tree.model.joints, POSES):
        ours, theirs = frames(tree, sample), sdf.placed(names, positions(tree, sample))
        root = ours[tree.roots[0].name]
        for name in names:
            worst = max(worst, (difference(root.inverse @ ours[name], theirs[name]), name))
    groups = by_key((sdf.link_of(name), name) for name in names)
    masses = [*_masses(sdf, tree, groups)]
    mass, center, tensor = (max((row[i] for row in masses), default=0.0) for i in range(3))
    shapes = [*_shapes(sdf, tree, groups)]
    shape = max((distance for distance, _ in shapes), default=0.0)
    missing = sum(number for _, number in shapes)
    joint = max(_joints(sdf, robot, conversion), default=0.0)
    is_rounded = _is_rounded(tree)
    is_placed = max(worst[0], shape) <= MAX_OFFSET and not missing
    bounds = (ROUNDED, ROUNDED) if is_rounded else (MAX_OFFSET, MAX_ERROR)
    is_heavy = mass <= MAX_ERROR and center <= bounds[0] and tensor <= bounds[1]
    return Proof(
        is_placed and is_heavy and joint <= MAX_ERROR,
        "the SDF agrees with the robot on frames, shapes, masses, inertia, joints and limits",
        f"the SDF does not agree with the robot: frames {worst[0]:.2g} m ('{worst[1]}'), "
        f"masses {mass:.2g}, centres {center:.2g} m, inertia {tensor:.2g}, joints {joint:.2g}, "
        f"shapes {shape:.2g} m, of which {missing} are missing",
        {
            "frames": worst[0],  # of link poses, in m and in entries of the rotation
            "masses": mass,  # of merged links, relative to the mass
            "centers": center,  # of mass of merged links, in m
            "inertia": tensor,  # of merged links, relative to the largest entry
            "joints": joint,  # of limits, relative; 1 for other parent, child or type
            "shapes": shape,  # of their poses, in m and in entries of the rotation
            "missing": missing,  # number of missing visuals and collisions
            "is_rounded": is_rounded,  # True if sdformat rounds a pitch in a merged link
            "part": worst[1],  # the link whose frame differs most
        },
    )


def difference(first: Transform, second: Transform) -> float:
    """The largest difference of two frames, in m or in entries of the rotation."""
    pairs = [*zip(first.position, second.position, strict=True)]
    for rows in zip(first.rotation, second.rotation, strict=True):
        pairs += zip(*rows, strict=True)
    return max(abs(a - b) for a, b in pairs)


def _shape_error(ours: Transform, theirs: Transform) -> float:
    """Difference of two shape poses; only of position if urdfdom rounds the rotation."""
    is_rounded = abs(ours.rotation[2][0]) >= SNAP
    error = difference(ours, theirs)
    return (
        length(minus(ours.position, theirs.position)) if is_rounded and error < ROUNDED else error
    )


def _masses(
    sdf: Sdf, tree: KinematicTree, groups: Mapping[str, list[str]]
) -> Iterator[tuple[float, float, float]]:
    """Differences of mass, centre and tensor of each SDF link from its links of the robot.

    Args:
        groups: links of the robot by the link of the SDF.
    """
    at_zero, links = frames(tree, {}), tree.model.links_by_name
    for top, names in groups.items():
        if not top:
            yield 1.0, 1.0, 1.0
            continue
        back = at_zero[top].inverse
        ours = combined(properties_of(links[name], back @ at_zero[name]) for name in names)
        yield _different(ours, _inertia(sdf.links[top]))


def _shapes(
    sdf: Sdf, tree: KinematicTree, groups: Mapping[str, list[str]]
) -> Iterator[tuple[float, int]]:
    """Distance of shapes from the nearest shape of the robot, and number of missing shapes."""
    at_zero, links = frames(tree, {}), tree.model.links_by_name
    for top, names in groups.items():
        for kind in ("visual", "collision") if top else ():
            ours = [
                at_zero[top].inverse @ at_zero[name] @ body.origin
                for name in names
                for body in (links[name].visuals if kind == "visual" else links[name].collisions)
            ]
            theirs = [pose(shape)[1] for shape in sdf.links[top].all(kind)]
            near = (min((_shape_error(a, shape) for a in ours), default=1.0) for shape in theirs)
            yield max(near, default=0.0), abs(len(ours) - len(theirs))


def _inertia(link: Element) -> MassProperties:
    inertial = link.child("inertial")
    inertia = inertial.child("inertia") if inertial else None
    if inertial is None or inertia is None:
        return MassProperties(0.0, (0.0, 0.0, 0.0), ZERO)
    _, at = pose(inertial)
    tensor = Tensor(*(number(text(inertia, name)) or 0.0 for name in Tensor._fields))
    own = MassProperties(number(text(inertial, "mass")) or 0.0, (0.0, 0.0, 0.0), tensor)
    return own.moved(at)


def _different(ours: MassProperties, theirs: MassProperties) -> tuple[float, float, float]:
    mass = abs(ours.mass - theirs.mass) / (abs(ours.mass) or 1.0)
    center = max(abs(a - b) for a, b in zip(ours.center, theirs.center, strict=True))
    largest = max(map(abs, ours.tensor)) or 1.0
    tensors = zip(ours.tensor, theirs.tensor, strict=True)
    return mass, center, max(abs(a - b) for a, b in tensors) / largest


def _joints(sdf: Sdf, robot: Context, conversion: SdfConversion) -> Iterator[float]:
    """Differences of the joints: 1 for other links or type, else relative differences of limits."""
    for joint in robot.model.joints:
        if joint.child_name in conversion.dropped or joint.kind == "fixed":
            continue
        tag = sdf.joints.get(joint.name)
        kind = "prismatic" if joint.is_prismatic else "revolute"
        parent = joint.parent_name
        if (
            tag is None
            or tag.get("type") != kind
            or text(tag, "child") != joint.child_name
            or text(tag, "parent") != (parent if parent == "world" else sdf.link_of(parent))
        ):
            yield 1.0
        else:
            yield from _limits(tag, joint)


def _limits(tag: Element, joint: Joint) -> Iterator[float]:
    axis = tag.child("axis")
    limit = axis.child("limit") if axis else None
    if joint.limit is None or limit is None or not joint.is_single_dof:
        return
    limits = {}
    if joint.kind != "continuous":
        limits["lower"], limits["upper"] = sorted(joint.limit.ends)
    for name, bound in (("effort", joint.limit.effort), ("velocity", joint.limit.velocity)):
        limits[name] = bound.value if bound else 0.0
    for name, value in limits.items():
        converted = number(text(limit, name))
        yield 1.0 if converted is None else abs(converted - value) / (abs(value) or 1.0)


def _is_rounded(tree: KinematicTree) -> bool:
    """True if a frame has a pitch that urdfdom rounds to 90 degrees."""
    fixed = (joint.origin for joint in tree.model.joints if joint.kind == "fixed")
    own = (link.inertial.origin for link in tree.model.links if link.inertial)
    return any(abs(at.rotation[2][0]) >= SNAP for at in (*fixed, *own))
