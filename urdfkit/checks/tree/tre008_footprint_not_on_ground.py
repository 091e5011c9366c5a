"""The link `base_footprint` is not on the ground, or the wheels do not reach it.

By convention (REP 120), `base_footprint` is the position of the robot on the floor, below
`base_link`: navigation uses it as the position of the robot, and simulators spawn the robot at it.
If the robot extends below it, the robot starts stuck in the floor and is thrown out; if the robot
ends above it, the robot drops. Give the joint between the two links the height of the lowest wheel
or foot. If a caster extends lower than the wheels, the caster is wrong: the wheels do not touch the
ground. So is a wheel that extends lower while others end on the ground. Without a `base_footprint`
this is reported if another link than a leg or arm extends at least 2 cm lower than all wheels.

Sources:
    REP 120, frames of humanoids: https://github.com/ros-infrastructure/rep/blob/master/rep-0120.rst
    REP 105, frames of mobile robots: http://www.ros.org/reps/rep-0105.html
"""

from urdfkit.core.spatial import Z_AXIS, Transform, Vector, dot, rotate, vector
from urdfkit.lint.rules import Context, Finding, Findings, Fix, Severity, rule
from urdfkit.robot.joint import Joint
from urdfkit.robot.kinematics import direction
from urdfkit.robot.link import Body
from urdfkit.robot.rotors import is_carried_by_rotors
from urdfkit.robot.samples import collision_xml, joint_xml, link_xml, robot_xml
from urdfkit.robot.shapes import primitive
from urdfkit.robot.tree import KinematicTree
from urdfkit.robot.values import number
from urdfkit.text.diagnostic import Edit
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import first_attribute, insert_before, replace_value

BAD = robot_xml(
    link_xml("base_footprint"),
    link_xml("base_link", collision_xml('<box size="0.4 0.3 0.2"/>')),
    joint_xml("fixed", name="base_footprint_joint", parent="base_footprint", child="base_link"),
)
FIXED = GOOD = BAD.replace('fixed">', 'fixed">\n  <origin xyz="0 0 0.1"/>')

#: Allowed distance from the ground, in m: tyres and rubber feet are soft.
TOLERANCE = 0.005
#: The same for meshes, which show the tread of a tyre before it is loaded.
_MESH_TOLERANCE = 0.02

#: Cosine of the angle to the vertical, below which an axis is horizontal.
_MAX_COSINE_LEVEL = 0.1
#: Cosine of the angle between two axes, above which they are parallel.
_MIN_COSINE_PARALLEL = 0.9

#: In m: a link that extends lower than the wheels by more is not a caster.
_MAX_CASTER_DEPTH = 0.1

#: In m: height of the wheels of a robot without a footprint, from which it is reported.
_MIN_HANGING = 0.02

#: In m: a robot that has to be raised by more has a wrong size, not a wrong height.
_MAX_RISE = 2.0

#: Wheels at one height of a robot that stands on no other link.
_STANDING_WHEELS = 4

#: Number of footprints of one model that are checked.
MAX_FOOTPRINTS = 10


@rule(Severity.WARNING, help="raise the robot by that height in the joint below base_footprint")
def check(context: Context) -> Findings:
    tree = context.tree
    if len(tree.roots) != 1:
        return  # TRE002 or TRE003 comes first
    footprints = [name for name in tree.frames if name.endswith("base_footprint")]
    if not footprints:
        root = tree.roots[0].name
        hanging = _hanging_wheels(context, root, list(tree.frames), _MIN_HANGING)
        if hanging and not is_carried_by_rotors(tree.model):
            yield _hanging(tree, *hanging)
    for name in footprints[:MAX_FOOTPRINTS]:
        # Some make the footprint a child of the base; the robot is then everything else.
        joints = tree.children[name] or tree.parents[name]
        robot = tree.below(name) if tree.children[name] else list(tree.frames)
        if joints and (lowest := _lowest(context, name, robot)):
            height, link, is_known = lowest
            gaps = _gaps(context, name, robot, height)
            if height > 0 and context.part is not None and not _are_four_level(gaps):
                continue  # the wheels may be in a package that is not found
            side = "below" if height < 0 else "above"
            lifted_wheels = _lifted_wheels(gaps, link)
            standing = _standing_wheels(gaps, link, height)
            rise = round(-height, 4)
            is_too_low = is_known and tree.children[name] == joints[:1]
            # If not all wheels reach the ground, it is unknown which wheel is wrong.
            is_level = max(gaps.values(), default=0.0) < TOLERANCE
            is_too_low = is_too_low and is_level and abs(rise) <= _MAX_RISE
            yield Finding(
                tree.parents[link][0].at if standing else joints[0].at,
                f"the lowest collision point (link '{link}') is {abs(height):.3g} m {side} "
                f"'{name}', which by convention lies on the ground{lifted_wheels}{standing}",
                f"raise '{link}' to the height of the other wheels"
                if standing
                else _help(name, link, height, bool(tree.children[name]), bool(lifted_wheels)),
                fix=Fix.of(
                    f"{'raise' if rise > 0 else 'lower'} the robot by {abs(rise):g} m",
                    _raised(joints[0].at, rise),
                )
                if is_too_low
                else None,
            )
        elif joints and (hanging := _hanging_wheels(context, name, robot)):
            yield _hanging(tree, *hanging)


def _hanging(tree: KinematicTree, gap: float, wheels: list[str], standing: str) -> Finding:
    return Finding(
        tree.parents[wheels[0]][0].at,
        f"the wheels {', '.join(wheels)} do not reach the ground: they are {gap:.3g} m above it, "
        f"and the robot stands on '{standing}'",
        f"lower the wheels by {gap:.3g} m, or raise '{standing}'",
    )


def _help(footprint: str, link: str, height: float, is_below: bool, is_lifted: bool) -> str:
    """The help of a finding."""
    if is_lifted and height < 0:  # else the robot may stand on tracks
        return f"raise '{link}', or make it smaller, until the wheels touch the ground"
    if is_below:
        verb = "raise" if height < 0 else "lower"
        return f"{verb} the robot by that height in the joint below base_footprint"
    verb = "lower" if height < 0 else "raise"
    return f"{verb} '{footprint}' by {abs(height):.3g} m in its joint"


def _raised(joint: Element, height: float) -> tuple[Edit, ...] | None:
    """Edits that raise the joint below the footprint by a height in m; None if impossible."""
    origin = joint.child("origin")
    if origin is None:
        line = f'<origin xyz="0 0 {height:.6g}"/>'
        return insert_before(joint.children[0], (line,)) if joint.children else None
    written = origin.attributes.get("xyz")
    if written is None:
        return first_attribute(origin, "xyz", f"0 0 {height:.6g}")
    parts = written.value.split()
    z = number(parts[2]) if len(parts) == 3 else None
    return None if z is None else replace_value(written, f"{parts[0]} {parts[1]} {z + height:.6g}")


def _lowest(context: Context, footprint: str, robot: list[str]) -> tuple[float, str, bool] | None:
    """Height in m and link of the lowest point, and whether all shapes were measured.

    None if the lowest point may be on the ground, or is on a leg or arm: all joints are at zero,
    which is not the pose in which such a robot stands. Links with a visual but without collision,
    and meshes that cannot be measured, may extend lower, unless there are four wheels.
    """
    heights, unknown = _heights(context, footprint, robot)
    lowest = min(heights, default=(0.0, ""))
    if not heights or lowest[1] in _limbs(context.tree):
        return None
    bodies = context.model.links_by_name[lowest[1]].collisions
    allowed = _MESH_TOLERANCE if any(body.is_mesh for body in bodies) else TOLERANCE
    if lowest[0] < 0 and _extends_lower(context, footprint, robot, lowest[0]):
        return None  # it is unknown by how much
    is_above = lowest[0] > allowed
    if is_above and unknown:
        is_above = _are_four_level(_gaps(context, footprint, robot, lowest[0]))
    return (*lowest, not unknown) if is_above or lowest[0] < -allowed else None


def _are_four_level(gaps: dict[str, float]) -> bool:
    """True for four or more wheels on which a robot stands, whatever else it has."""
    return sum(gap < TOLERANCE for gap in gaps.values()) >= _STANDING_WHEELS


def _extends_lower(context: Context, footprint: str, robot: list[str], height: float) -> bool:
    """True if a link with a shape that cannot be measured has its frame below a height in m."""
    ground = context.tree.frames[footprint]
    up = rotate(ground.rotation, Z_AXIS)
    level = dot(up, ground.position) + height
    for name in robot:
        frame = context.tree.frames[name]
        bodies = context.model.links_by_name[name].collisions
        is_open = any(_bottom(context, body, frame, up) is None for body in bodies)
        if is_open and dot(up, frame.position) < level:
            return True
    return False


def _heights(
    context: Context, footprint: str, robot: list[str]
) -> tuple[list[tuple[float, str]], bool]:
    """Heights above the footprint in m, with their links, and whether a shape was not measured."""
    tree = context.tree
    ground = tree.frames[footprint]
    up = rotate(ground.rotation, Z_AXIS)
    heights: list[tuple[float, str]] = []
    unknown = False
    for name in robot:
        link = tree.model.links_by_name[name]
        unknown |= bool(link.visuals) and not link.collisions and name != footprint
        for body in link.collisions:
            bottom = _bottom(context, body, tree.frames[name], up)
            if bottom is None:
                unknown = True
            else:
                heights.append((bottom - dot(up, ground.position), name))
    return heights, unknown


def _hanging_wheels(
    context: Context, footprint: str, robot: list[str], least_gap: float = 0.0
) -> tuple[float, list[str], str] | None:
    """Wheels at one height above the ground on which another link stands: gap, wheels and link.

    Args:
        least_gap: in m, where the ground is at the lowest link; 0 if it is at the footprint.
    """
    heights, _ = _heights(context, footprint, robot)
    height, standing = min(heights, default=(TOLERANCE, ""))
    limbs = _limbs(context.tree)  # with fingers, which also turn about level axes
    gaps = _gaps(context, footprint, [name for name in robot if name not in limbs], height)
    least = min(gaps.values(), default=0.0)
    is_on_ground = not _is_wheel(standing) if least_gap else abs(height) < TOLERANCE
    is_standing = is_on_ground and standing not in limbs
    if not is_standing or standing in gaps or len(gaps) < 2:
        return None
    if any(standing in context.tree.below(name) for name in gaps):
        return None  # feet, whose legs turn without limits
    is_level = max(gaps.values()) - least < TOLERANCE
    is_hanging = least > max(TOLERANCE, least_gap)
    return (least, sorted(gaps), standing) if is_level and is_hanging else None


def _is_wheel(name: str) -> bool:
    """True for the name of a wheel other than a caster: its joint may have another type."""
    words = name.lower()
    return any(word in words for word in ("wheel", "tire", "tyre", "track")) and "cast" not in words


def _gaps(context: Context, footprint: str, robot: list[str], height: float) -> dict[str, float]:
    """Height of each wheel above the lowest point, in m, by link name.

    Wheels are links of continuous joints with a horizontal axis, with the rollers of their rims.

    Args:
        robot: names of the links of the robot.
        height: height of the lowest point above the footprint, in m.
    """
    tree = context.tree
    ground = tree.frames[footprint]
    up = rotate(ground.rotation, Z_AXIS)
    wheels = _wheels(tree, up)
    gaps: dict[str, float] = {}
    for name in filter(wheels.__contains__, robot):
        wheel = wheels[name]
        for body in tree.model.links_by_name[name].collisions:
            bottom = _bottom(context, body, tree.frames[name], up)
            if bottom is not None and not _lies_flat(body, tree.parents[name]):
                gap = bottom - dot(up, ground.position) - height
                gaps[wheel] = min(gap, gaps.get(wheel, gap))
    return gaps


def _lies_flat(body: Body, joints: list[Joint]) -> bool:
    """True for a cylinder across the axle, which JNT033 reports: its height is another one."""
    axis = rotate(body.origin.rotation, Z_AXIS)
    is_cylinder = body.shape is not None and body.shape.kind == "cylinder"
    return is_cylinder and any(
        joint.kind == "continuous" and abs(dot(axis, direction(joint))) <= _MAX_COSINE_LEVEL
        for joint in joints
    )


def _wheels(tree: KinematicTree, up: Vector) -> dict[str, str]:
    """The wheels by link: themselves, and the wheel that carries a roller, whose axis differs."""
    wheels: dict[str, str] = {}
    carriers: dict[str, tuple[str, Vector]] = {}  # and their axes
    for joint in tree.spanning:
        name = joint.child_name
        carrier = carriers.get(joint.parent_name)
        axis = rotate(tree.frames[name].rotation, direction(joint))
        if _may_roll(joint, tree) and abs(dot(up, axis)) <= _MAX_COSINE_LEVEL:
            if not carrier or abs(dot(carrier[1], axis)) > _MIN_COSINE_PARALLEL:
                carrier = (name, axis)
            wheels[name] = carrier[0]
        if carrier:
            carriers[name] = carrier
    return wheels


def _may_roll(joint: Joint, tree: KinematicTree) -> bool:
    """True for a joint without limits that does not follow one with limits, as pistons do."""
    leader = tree.model.joints_by_name.get(joint.leader, joint)
    return joint.kind == leader.kind == "continuous"


def _lifted_wheels(gaps: dict[str, float], lowest: str) -> str:
    """Text about two or more wheels at one height, if another link extends lower; else empty."""
    least = min(gaps.values(), default=0.0)
    wheels = [name for name, gap in gaps.items() if gap - least < TOLERANCE]
    if lowest in wheels or len(wheels) < 2 or not TOLERANCE < least < _MAX_CASTER_DEPTH:
        return ""
    return f"; the wheels {', '.join(wheels)} are {least:.3g} m higher"


def _standing_wheels(gaps: dict[str, float], lowest: str, height: float) -> str:
    """Text about wheels on the ground, if another wheel extends lower; else empty."""
    wheels = [name for name, gap in gaps.items() if abs(gap + height) < 2 * TOLERANCE]
    if lowest not in gaps or lowest in wheels or not wheels:
        return ""
    return f"; the wheels {', '.join(wheels)} end there"


def _limbs(tree: KinematicTree) -> set[str]:
    """The links below two or more revolute joints, such as links of legs."""
    counts = dict.fromkeys(tree.frames, 0)
    for joint in tree.spanning:
        counts[joint.child_name] = counts[joint.parent_name] + (joint.kind == "revolute")
    return {name for name, count in counts.items() if count > 1}


def _bottom(context: Context, body: Body, link: Transform, up: Vector) -> float | None:
    """Height of the lowest point of a shape, in m; None for one that cannot be measured."""
    down = vector(-part for part in up)
    if shape := primitive(body._replace(origin=link @ body.origin)):
        return -shape.reach(down)
    mesh = context.mesh_solid(body)
    if mesh is None:
        return None
    return dot(up, link.position) - mesh.reach(rotate(link.inverse.rotation, down))
