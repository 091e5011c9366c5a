"""A wheel or propeller turns about another axis than its shape, or a wheel has position limits.

- The axis of the joint is not the axis of the wheel: the wheel tumbles, and the robot jumps or does
  not move. Either the axis is wrong, or the shape is not rotated: the axis of a cylinder in URDF is
  z, and a wheel whose axle is y needs rpy="1.5707963 0 0". The axle of a mesh is assumed to be the
  short edge of its bounding box if the other two edges are equal. The same holds for the disc that
  stands for a propeller.
- The joint is revolute: the wheel stops at its limit, while the motor keeps pushing. A wheel needs
  type="continuous".

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
"""

import re
from collections.abc import Callable, Iterable

from urdfkit.core.grouping import by_key
from urdfkit.core.spatial import AXES, Z_AXIS, Vector, dot, length, minus, rotate
from urdfkit.core.words import rounded
from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Related, Severity, rule
from urdfkit.robot.joint import Joint
from urdfkit.robot.joint_limits import bounds
from urdfkit.robot.kinematics import direction
from urdfkit.robot.link import Body, Link
from urdfkit.robot.samples import collision_xml, joint_xml, link_xml, robot_xml
from urdfkit.robot.shapes import LinkSolid, MeshSolid, solid

BAD = robot_xml(
    link_xml("base"),
    link_xml("wheel", collision_xml('<cylinder radius="0.1" length="0.04"/>')),
    joint_xml("continuous", '<axis xyz="0 1 0"/>', name="wheel_joint", child="wheel"),
)
GOOD = BAD.replace("<geometry>", '<origin rpy="1.5707963 0 0"/>\n    <geometry>', 1)

#: Added to the help for a vertical axis.
_STEERED = "; a wheel that steers needs two joints, with a link between them"

#: Words in the names of links whose cylinder need not roll.
_NOT_WHEELS = ("caster", "castor", "swivel", "steer", "mount", "support", "bracket", "hub", "fork")

#: Words in the names of what turns about the axis of its flat shape.
_FLAT_THINGS = {"wheel": "wheel", "propeller": "propeller|(?<![a-z])(prop|rotor)(?![a-z])"}

#: Cosine of the angle between two axes, below which they differ, and above which they are equal.
_MAX_COSINE_ACROSS, _MIN_COSINE_ALONG = 0.5, 0.9

#: Most wheels of a link with which another one is compared.
_MAX_COMPARED = 16

#: In rad: limits of wheels that are written as revolute joints without stops.
_MIN_UNLIMITED = 100.0

#: A mesh is a wheel if two of its edges are about equal, and the third is shorter.
_ROUND, _FLAT = 0.94, 0.75


@rule(Severity.WARNING, confidence=Confidence.INFERRED)
def check(context: Context) -> Findings:
    links = context.model.links_by_name
    wheels = by_key(
        (joint.parent_name, joint) for joint in context.model.joints if _is_wheel(joint)
    )
    for joint in context.model.joints:
        if link := links.get(joint.child_name):
            beside = wheels.get(joint.parent_name, [])[:_MAX_COMPARED]
            yield from _across(joint, link, context.mesh_solid, beside)
            yield from _limited(joint, link)


def _is_wheel(joint: Joint) -> bool:
    return joint.kind == "continuous" and "wheel" in joint.child_name.lower()


def _across(
    joint: Joint,
    link: Link,
    mesh_solid: Callable[[Body], MeshSolid | None],
    beside: Iterable[Joint],
) -> Findings:
    """A wheel whose joint turns about another axis than its shape.

    Args:
        beside: the joints of wheels on the same parent.
    """
    kind = _kind(joint, link) if joint.kind == "continuous" else ""
    if not kind:
        return
    if joint.axis and not any(joint.axis.value):
        return  # JNT006: it has no direction
    wheel = _wheel_shape(link, mesh_solid)
    if wheel is None:
        return
    (body, axle), axis = wheel, direction(joint)
    shape = "cylinder" if body.shape and body.shape.kind == "cylinder" else "mesh"
    shape_name = f"{'collision' if body in link.collisions else 'visual'} {shape}"
    if abs(dot(axis, axle)) < _MAX_COSINE_ACROSS:
        yield Finding(
            joint.at.child_or_self("axis"),
            f"joint '{joint.name}' turns {kind} '{link.name}' about {rounded(axis, 3)}, but the "
            f"axis of its {shape_name} is {rounded(axle, 3)}",
            _help(joint, shape_name, beside if kind == "wheel" else None),
            related=(Related(body.at.span, f"the {shape_name}"),),
        )


def _help(joint: Joint, shape: str, beside: Iterable[Joint] | None) -> str:
    """Whether the axis of the joint or the shape is wrong; ``beside`` is None for a propeller."""
    axis = rotate(joint.origin.rotation, direction(joint))
    if beside is not None and any(_is_along(axis, joint, other) for other in beside):
        return f"rotate the {shape} with its <origin>: the axis is across the robot"
    is_steered = beside is not None and abs(axis[2]) > _MIN_COSINE_ALONG
    help = f"write the axis of the {shape}, or rotate the shapes with their <origin>"
    return help + (_STEERED if is_steered else "")


def _is_along(axis: Vector, joint: Joint, other: Joint) -> bool:
    """True if a joint is beside another one in the direction of an axis."""
    shift = minus(other.origin.position, joint.origin.position)
    return any(shift) and abs(dot(axis, shift)) > _MIN_COSINE_ALONG * length(shift)


def _limited(joint: Joint, link: Link) -> Findings:
    ends = bounds(joint)
    if joint.kind != "revolute" or ends is None or ends[0] >= ends[1]:
        return
    names = f"{joint.name} {link.name}".lower()
    is_wheel = "wheel" in names and "steer" not in names and "wheelie" not in names
    if is_wheel and max(map(abs, ends)) < _MIN_UNLIMITED and _rolls(link, direction(joint)):
        yield Finding(
            joint.type or joint.at,
            f"joint '{joint.name}' of wheel '{link.name}' is revolute, with limits "
            f"[{ends[0]:g}, {ends[1]:g}] rad",
            'write type="continuous", without lower and upper',
        )


def _rolls(link: Link, axis: Vector) -> bool:
    """True if the joint turns a cylinder of the link about its own axis."""
    for body in (*link.collisions, *link.visuals):
        if body.shape and body.shape.kind == "cylinder":
            return abs(dot(rotate(body.origin.rotation, Z_AXIS), axis)) > _MIN_COSINE_ALONG
    return False


def _kind(joint: Joint, link: Link) -> str:
    """The flat thing that the joint turns about its axle; empty for any other."""
    names = f"{joint.name} {link.name}".lower()
    if any(word in names for word in _NOT_WHEELS):
        return ""
    return next((kind for kind, words in _FLAT_THINGS.items() if re.search(words, names)), "")


def _wheel_shape(
    link: Link, mesh_solid: Callable[[Body], MeshSolid | None]
) -> tuple[Body, Vector] | None:
    """The flat shape of a wheel around its joint, and the axis of that shape; None without one."""
    for bodies in (link.collisions, link.visuals):
        shape = bodies[0].shape if len(bodies) == 1 else None
        if shape and shape.kind == "cylinder" and shape.radius and shape.length:
            (body,) = bodies
            is_flat = shape.length < 1.5 * shape.radius
            is_centred = max(map(abs, body.origin.position)) < shape.radius
            axle = rotate(body.origin.rotation, Z_AXIS)
            return (body, axle) if is_flat and is_centred else None
        mesh = mesh_solid(bodies[0]) if len(bodies) == 1 else None
        axle_of_mesh = _axle(solid(bodies, mesh_solid)) if mesh else None
        if axle_of_mesh:
            return bodies[0], axle_of_mesh
    return None


def _axle(mesh: LinkSolid | None) -> Vector | None:
    """The direction in which a mesh is thin, if it is round about that axis and centred on it."""
    if mesh is None:
        return None
    box = mesh.bounds
    (thin, axis), (low, i), (high, j) = sorted(zip(box.edges, range(3), strict=True))
    is_centred = max(abs(box.center[i]), abs(box.center[j])) < high / 4
    if thin > _FLAT * low or low < _ROUND * high or not is_centred:
        return None
    return AXES[axis]
