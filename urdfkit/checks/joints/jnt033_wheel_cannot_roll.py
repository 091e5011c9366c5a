"""A wheel cannot roll: its joint turns about another axis than its shape, or has position limits.

- The axis of the joint is not the axis of the wheel: it tumbles, and the robot jumps or does not
  move. Either the axis is wrong, or the shape is not rotated: a cylinder of URDF stands on its z
  axis, and a wheel whose axle is y needs rpy="1.5707963 0 0". The axle of a mesh is taken to be the
  short edge of its bounding box, where the other two are equal.
- The joint is revolute: the wheel stops after half a turn or so, while the motor pushes on. A wheel
  needs type="continuous".

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
"""

from collections.abc import Callable

from urdfkit.core.spatial import Vector, dot, rotate
from urdfkit.core.words import rounded
from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Related, Severity, rule
from urdfkit.robot.joints import bounds
from urdfkit.robot.kinematics import direction
from urdfkit.robot.model import Body, Joint, Link
from urdfkit.robot.samples import collision_xml, joint_xml, link_xml, robot_xml
from urdfkit.robot.shapes import AXES, LinkSolid, MeshSolid, solid

BAD = robot_xml(
    link_xml("base"),
    link_xml("wheel", collision_xml('<cylinder radius="0.1" length="0.04"/>')),
    joint_xml("continuous", '<axis xyz="0 1 0"/>', name="wheel_joint", child="wheel"),
)
GOOD = BAD.replace("<geometry>", '<origin rpy="1.5707963 0 0"/>\n    <geometry>', 1)

#: Names of links whose cylinder need not roll.
_OTHERS = ("caster", "castor", "swivel", "steer", "mount", "support", "bracket", "hub", "fork")

#: Cosine of the angle of two axes: below, another axis; above, the same.
_ACROSS, _ALONG = 0.5, 0.9

#: Some write a wheel with such limits, in rad.
_UNLIMITED = 100.0

#: A mesh is a wheel if two of its edges are as long as one another, and the third is shorter.
_ROUND, _FLAT = 0.94, 0.75


@rule(Severity.WARNING)
def check(context: Context) -> Findings:
    links = context.model.links_by_name
    for joint in context.model.joints:
        if link := links.get(joint.child_name):
            yield from _across(joint, link, context.mesh_solid)
            yield from _limited(joint, link)


def _across(joint: Joint, link: Link, mesh_solid: Callable[[Body], MeshSolid | None]) -> Findings:
    """A wheel whose joint turns about another axis than its shape."""
    if joint.kind != "continuous" or not _is_wheel(joint, link):
        return
    wheel = _wheel_shape(link, mesh_solid)
    if wheel is None:
        return
    (body, axle), axis = wheel, direction(joint)
    shape = "cylinder" if body.shape and body.shape.kind == "cylinder" else "mesh"
    what = f"{'collision' if body in link.collisions else 'visual'} {shape}"
    if abs(dot(axis, axle)) < _ACROSS:
        yield Finding(
            joint.at.child("axis") or joint.at,
            f"joint '{joint.name}' turns wheel '{link.name}' about {rounded(axis, 3)}, but the "
            f"axis of its {what} is {rounded(axle, 3)}",
            f"write the axis of the {what}, or rotate the shapes with their <origin>",
            related=(Related(body.at.span, f"the {what}"),),
            confidence=Confidence.INFERRED,
        )


def _limited(joint: Joint, link: Link) -> Findings:
    ends = bounds(joint)
    if joint.kind != "revolute" or ends is None or ends[0] >= ends[1]:
        return
    names = f"{joint.name} {link.name}".lower()
    is_wheel = "wheel" in names and "steer" not in names and "wheelie" not in names
    if is_wheel and max(map(abs, ends)) < _UNLIMITED and _rolls(link, direction(joint)):
        yield Finding(
            joint.type or joint.at,
            f"joint '{joint.name}' of wheel '{link.name}' is revolute, with limits "
            f"[{ends[0]:g}, {ends[1]:g}] rad",
            'write type="continuous", without lower and upper',
            confidence=Confidence.INFERRED,
        )


def _rolls(link: Link, axis: Vector) -> bool:
    """True if the joint turns a cylinder of the link about its own axis."""
    for body in (*link.collisions, *link.visuals):
        if body.shape and body.shape.kind == "cylinder":
            return abs(dot(rotate(body.origin.rotation, (0.0, 0.0, 1.0)), axis)) > _ALONG
    return False


def _is_wheel(joint: Joint, link: Link) -> bool:
    names = f"{joint.name} {link.name}".lower()
    return "wheel" in names and not any(word in names for word in _OTHERS)


def _wheel_shape(
    link: Link, mesh_solid: Callable[[Body], MeshSolid | None]
) -> tuple[Body, Vector] | None:
    """The flat shape of a wheel about its joint, and the axis of it; None if it has none."""
    for bodies in (link.collisions, link.visuals):
        shape = bodies[0].shape if len(bodies) == 1 else None
        if shape and shape.kind == "cylinder" and shape.radius and shape.length:
            (body,) = bodies
            is_flat = shape.length < 1.5 * shape.radius
            is_centred = max(map(abs, body.origin.position)) < shape.radius
            axle = rotate(body.origin.rotation, (0.0, 0.0, 1.0))
            return (body, axle) if is_flat and is_centred else None
        found = mesh_solid(bodies[0]) if len(bodies) == 1 else None
        axle_of_mesh = _axle(solid(bodies, mesh_solid)) if found else None
        if axle_of_mesh:
            return bodies[0], axle_of_mesh
    return None


def _axle(mesh: LinkSolid | None) -> Vector | None:
    """The direction in which a mesh is thin, if it is round about it and about its link."""
    if mesh is None:
        return None
    box = mesh.bounds
    (thin, axis), (low, i), (high, j) = sorted(zip(box.edges, range(3), strict=True))
    is_centred = max(abs(box.center[i]), abs(box.center[j])) < high / 4
    if thin > _FLAT * low or low < _ROUND * high or not is_centred:
        return None
    return AXES[axis]
