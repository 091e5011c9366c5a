"""An origin, a prismatic limit or a shape looks like millimetres.

Lengths are metres in URDF.

- An `<origin>` of a joint of 10 m or more is reported if the rest of the model contradicts it: the
  other joints are less than 1 m and less than a hundredth of that distance apart, or the meshes are
  scaled by 0.001, or no shape has a hundredth of that size.
- Limits of a prismatic joint are reported if they are whole numbers of 5 m or more, and 20 times
  the longest part of the robot; next to meshes that cannot be measured, 100 times the farthest
  origin. A gripper that opens by 30 m instead of 30 mm flies apart in the simulator.
- A shape is reported if it is 5 m or more, fifty times as long as the rest of the robot, and
  thicker than the rest is long: in RViz it is a wall, and everything collides with it. If most
  links are so large, or no joint moves, they are the walls of a scene and are not reported.

Divide by 1000.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
"""

from math import isclose

from urdfkit.core.grouping import by_key
from urdfkit.core.spatial import length
from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Fix, Related, Severity, rule
from urdfkit.robot.joint import Joint
from urdfkit.robot.joint_limits import bounds, related, several
from urdfkit.robot.link import Body
from urdfkit.robot.model import RobotModel
from urdfkit.robot.samples import joint_xml, link_xml, robot_xml, visual_xml
from urdfkit.text.editing.edits import scale_limits

BAD = robot_xml(
    link_xml("base", visual_xml('<box size="0.1 0.1 0.05"/>')),
    link_xml("arm"),
    joint_xml("prismatic", '<limit lower="0" upper="30" effort="10" velocity="0.1"/>'),
)
FIXED = GOOD = BAD.replace('"30"', '"0.03"')

#: In m; few robots have such a distance between two joints, but most do in mm.
_MIN_DISTANCE = 10.0
#: In m; shorter origins are rounding.
_ROUNDING = 1e-4
#: Least ratio to the distances and sizes of the rest of the model.
_MIN_RATIO = 100.0

#: Least travel that is reported: times the longest part of the robot, and in m.
_MIN_RELATIVE_TRAVEL = 20.0
_MIN_TRAVEL = 5.0

#: Least size of a shape that is reported: times the size of the other links, and in m.
_TIMES_THE_REST = 50.0
_MIN_SIZE = 5.0
#: Words in the names of links of an environment.
_GROUNDS = ("ground", "floor", "world", "plane", "room", "map", "terrain", "field")


@rule(Severity.WARNING, confidence=Confidence.INFERRED, help="divide by 1000: lengths are metres")
def check(context: Context) -> Findings:
    yield from _origins(context.model)
    yield from _limits(context)
    yield from _shapes(context.model)


def _origins(model: RobotModel) -> Findings:
    # A robot can be anywhere in the world.
    placed = (joint for joint in model.joints if joint.parent_name != "world")
    reaches = [(joint, length(joint.origin.position)) for joint in placed]
    far = [(joint, reach) for joint, reach in reaches if reach >= _MIN_DISTANCE]
    if not far:
        return
    near = sorted(reach for _, reach in reaches if _ROUNDING < reach < _MIN_DISTANCE)
    least = min(reach for _, reach in far)
    if evidence := _evidence(model, least, near, len(far)):
        joints = [joint for joint, _ in far]
        places = [(joint, joint.at.child_or_self("origin").span) for joint in joints]
        first, reach = far[0]
        yield Finding(
            first.at.child_or_self("origin"),
            f"{several(joints)}: the origin is {reach:g} m away, but {evidence}; that looks like "
            "millimetres",
            related=related(places),
        )


def _evidence(model: RobotModel, least: float, near: list[float], count: int) -> str:
    """The evidence against origins of ``least`` metres and more; empty if there is none."""
    if len(near) > max(2, count):
        median = near[len(near) // 2]
        if median < 1 and least > _MIN_RATIO * median:
            return f"half of the other {len(near)} joints are less than {median:.2g} m apart"
        return ""
    shapes = model.shapes
    if any(shape.filename and max(map(abs, shape.scale)) == 0.001 for shape in shapes):
        return "meshes are scaled by 0.001"
    sizes = [max(half) * 2 for shape in shapes if (half := shape.half_extents)]
    if sizes and least > _MIN_RATIO * max(sizes) and not any(shape.filename for shape in shapes):
        return f"no shape is larger than {max(sizes):g} m"
    return ""


def _limits(context: Context) -> Findings:
    """Prismatic joints that move many times the length of the robot."""
    model = context.model
    suspects = [
        (joint, ends)
        for joint in model.joints
        if joint.is_prismatic
        and (ends := bounds(joint))
        and _MIN_TRAVEL <= max(map(abs, ends)) <= 10_000
        and all(end == int(end) for end in ends)
    ]
    if not suspects:
        return
    meshes = [body for link in model.links for body in link.bodies if body.is_mesh]
    solids = [solid for body in meshes if (solid := context.mesh_solid(body))]
    is_measured = len(solids) == len(meshes)
    sizes = [2 * max(half) for shape in model.shapes if (half := shape.half_extents)]
    sizes += [solid.longest for solid in solids]
    origins = [max(map(abs, joint.origin.position)) for joint in model.joints]
    longest = max((*sizes, *origins), default=0.0)
    ratio = _MIN_RELATIVE_TRAVEL if is_measured else _MIN_RATIO
    known = f"no part of the robot is longer than {longest:.3g} m"
    if not is_measured:
        known = f"no origin is further away than {longest:.3g} m"
    for joint, (lower, upper) in suspects:
        is_part = _is_of_a_part(joint, (lower, upper), model, without_meshes=not meshes)
        if longest and max(-lower, upper) > ratio * longest and is_part and joint.limit:
            yield Finding(
                joint.limit.at,
                f"joint '{joint.name}' has limits [{lower:g}, {upper:g}] m, but {known}",
                fix=Fix.of("write the limits in metres", scale_limits(joint.limit.at, 1e-3)),
            )


def _is_of_a_part(
    joint: Joint, ends: tuple[float, float], model: RobotModel, *, without_meshes: bool
) -> bool:
    """False for a joint that lets a robot, or an object, move in the plane of the world."""
    parent = model.links_by_name.get(joint.parent_name)
    has_body = bool(parent and parent.bodies)
    return has_body or without_meshes if ends[0] != -ends[1] else has_body and without_meshes


def _shapes(model: RobotModel) -> Findings:
    sizes = _sizes(model)
    usual = [size for bodies in sizes.values() for size, _, _ in bodies if size < _MIN_SIZE]
    longest = max(usual, default=0.0)
    suspects: dict[str, list[tuple[float, Body]]] = {}
    for name, bodies in sizes.items() if usual else ():
        # A rail is long but thin; a shape in millimetres is thick as well.
        least = max(_MIN_SIZE, _TIMES_THE_REST * longest)
        large = [(size, body) for size, thick, body in bodies if size >= least and thick > longest]
        if large and not any(word in name.lower() for word in _GROUNDS):
            suspects[name] = large
    usual_links = sum(any(size < _MIN_SIZE for size, _, _ in bodies) for bodies in sizes.values())
    is_scene = bool(model.joints) and all(joint.kind == "fixed" for joint in model.joints)
    if is_scene or len(suspects) > usual_links:
        return  # a plane, or the walls of a scene
    for name, ((size, body), *others) in suspects.items():
        in_cm = any(isclose(size, 100 * other, rel_tol=0.01) for other, _, _ in sizes[name])
        yield Finding(
            body.shape.at if body.shape else body.at,
            f"link '{name}': the {body.at.tag} is {size:g} m long, the rest of the robot at most "
            f"{longest:.3g} m",
            f"divide by {100 if in_cm else 1000}: lengths are metres",
            related=tuple(Related(other.at.span, f"{edge:g} m, too") for edge, other in others),
        )


def _sizes(model: RobotModel) -> dict[str, list[tuple[float, float, Body]]]:
    """The longest and the shortest edge of each shape, in m, by link name."""
    return by_key(
        (link.name, (2 * max(half), 2 * min(half), body))
        for link in model.links
        for body in link.bodies
        if body.shape and (half := body.shape.half_extents)
    )
