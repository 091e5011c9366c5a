"""Collision geometries of two links overlap.

- Overlap with all joints at zero, a warning: the links are neither adjacent nor rigidly connected,
  and other poses separate them, but MoveIt rejects a plan that starts at zero, and a simulator with
  self-collision pushes the parts apart in its first step. Links below a joint that cannot be at
  zero are not reported, nor an overlap below 1 mm (option `depth`, in m), such as of a closed
  gripper. The depth is stated for primitives and convex meshes; coal's depth for other meshes is
  not reliable.
- Overlap in every pose, an info: at zero, at all limits and in some dozens of poses between. MoveIt
  can plan only if the pair is disabled in the SRDF (`urdfkit collisions -o`). A warning if
  `<self_collide>` enables collisions of one of the two with its robot in Gazebo, which has no such
  list: it pushes them apart in every step, and the robot shakes or flies off. gz-sim reads the tag
  of the model, in a `<gazebo>` block without a reference, and not the tags of links.
  It is also a warning for a left and a right wheel: one has the width or the place of another one.
- A pair that the robot's SRDF disables is reported only with `<self_collide>`.
- Overlap of adjacent links, an info: most of the smaller body is inside the other one, such as a
  wheel deep in the box of the chassis. Gazebo, MuJoCo and MoveIt ignore collisions between adjacent
  links, but the outer geometry hits objects that the inner one should hit, such as a kerb. Only
  primitives and convex meshes are reported, since their penetration depth is exact.

- Overlap of convex hulls, for a target that collides the convex hulls of meshes (MuJoCo, Isaac Sim,
  PyBullet), a warning: the hulls overlap by more than 1 mm at the beginning, and the simulator
  pushes the links apart from the first step on; Isaac Sim and PyBullet only if self-collision is
  enabled. If the meshes themselves do not overlap, write convex pieces, each as a separate
  `<collision>`. MuJoCo welds the root link of a URDF to the world, and does not ignore the
  collisions between it and the link that its first joint moves.

Correct the origin of a joint or of a collision, or make the collision geometry smaller;
`urdfkit mesh collision` creates shapes that approximate a mesh.

Sources:
    MoveIt, check_start_state_collision.cpp: https://github.com/moveit/moveit2/blob/main/moveit_ros/planning/planning_request_adapter_plugins/src/check_start_state_collision.cpp
    MoveIt, compute_default_collisions.cpp: https://github.com/moveit/moveit2/blob/main/moveit_setup_assistant/moveit_setup_srdf_plugins/src/compute_default_collisions.cpp
    SDF, self_collide: http://sdformat.org/spec?ver=1.9&elem=link
    gz-sim, SdfEntityCreator.cc: https://github.com/gazebosim/gz-sim/blob/gz-sim8/src/SdfEntityCreator.cc
    MuJoCo, contact filtering: https://mujoco.readthedocs.io/en/stable/computation/index.html#selection
    MuJoCo, URDF: https://mujoco.readthedocs.io/en/stable/modeling.html#urdf-extensions
"""

from __future__ import annotations

from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.lint.rules import Context, Finding, Findings, Need, Related, Severity, rule
from urdfkit.robot.samples import collision_xml, joint_xml, link_xml, robot_xml
from urdfkit.ros.gazebo.values import is_true
from urdfkit.ros.targets import CLASSIC, GAZEBO, TargetFacts, facts_of

if TYPE_CHECKING:
    from urdfkit.physics.collision.bodies import CollisionBody
    from urdfkit.physics.collision.contacts import Contact, LinkPair
    from urdfkit.physics.collision.hull_overlaps import HullOverlap

_LIMIT = '<limit lower="-2" upper="2" effort="10" velocity="1"/>'
BAD = robot_xml(
    link_xml("base", collision_xml('<box size="0.2 0.2 0.2"/>')),
    link_xml("arm", collision_xml('<box size="0.05 0.05 0.4"/>', '<origin xyz="0 0 0.25"/>')),
    link_xml("tool", collision_xml('<sphere radius="0.05"/>', '<origin xyz="0 0 -0.4"/>')),
    joint_xml("revolute", '<origin xyz="0 0 0.1"/>', '<axis xyz="0 1 0"/>', _LIMIT),
    joint_xml(
        "revolute",
        '<origin xyz="0.06 0 0.4"/>',
        '<axis xyz="0 1 0"/>',
        _LIMIT,
        name="elbow",
        parent="arm",
        child="tool",
    ),
)
GOOD = BAD.replace("0 0 -0.4", "0 0 0.4")

#: Part of the volume of its hull from which a mesh counts as convex: rounded edges are missing.
_FILLED = 0.95

#: Least reported part of the smaller body's thickness: wheels are often half inside the chassis.
_LEAST_DEPTH = 0.6


@rule(
    Severity.WARNING,
    needs=(Need.MODEL, Need.COLLISIONS),
    options={"depth": 1e-3},  # in m; closed fingers of real grippers overlap by 0.3 mm
)
def check(context: Context) -> Findings:
    contacts = context.collisions.contacts
    depth = check.option(context, "depth")
    colliding = _self_colliding(context)
    reported = set()
    for pair in contacts.pairs:
        finding = None if pair.is_rigid else _overlap(context, pair, depth, colliding)
        if finding:
            yield finding
            if not pair.is_adjacent:
                reported.add(pair.names)
    simulators = [facts for facts in map(facts_of, context.given_targets) if facts.collides_hulls]
    if simulators:
        from urdfkit.physics.collision.hull_overlaps import hull_overlaps  # for few targets

        for overlap in hull_overlaps(contacts, depth):
            if (overlap.first.link, overlap.second.link) not in reported:
                yield from _hull_overlap(context, overlap, simulators, depth)


def _overlap(context: Context, pair: LinkPair, depth: float, colliding: set[str]) -> Finding | None:
    initial_pose = context.collisions.contacts.initial_pose
    found = _adjacent(pair) if pair.is_adjacent else _apart(pair, initial_pose, depth)
    if found is None:
        return None
    contact, message, help, severity = found
    if severity is Severity.INFO and _are_opposite_wheels(context, pair.names):
        help, severity = "make the wheels narrower, or move them apart", Severity.WARNING
    is_disabled = not pair.is_adjacent and _is_disabled(context, pair.names)
    is_info = is_disabled or (severity is Severity.INFO and not pair.is_adjacent)
    if is_info and _collide_in_gazebo(context, pair.names, colliding):
        message += ", and <self_collide> makes Gazebo push them apart"
        help, severity = "turn <self_collide> off, or make one smaller", Severity.WARNING
    elif is_disabled:
        return None
    small, large = contact.small, contact.large
    other = context.model.collision(large.link, large.number)
    return Finding(
        context.model.collision(small.link, small.number),
        message,
        help,
        related=(Related(other.span, f"link '{large.link}'"),),
        weight=contact.depth,
        group_key="overlap",
        severity=severity,
    )


def _are_opposite_wheels(context: Context, names: tuple[str, str]) -> bool:
    """True for a left and a right wheel; wheels of one side may be a track."""
    return any(
        {left.child_name, right.child_name} == {*names} and left.kind == "continuous" == right.kind
        for left, right in context.symmetric_joints
    )


def _is_disabled(context: Context, names: tuple[str, str]) -> bool:
    """True if the SRDF of the robot, or of a variant, states that two links may overlap."""
    pair = frozenset(names)
    return any(srdf.disables(pair) for srdf in context.possible_srdfs)


def _self_colliding(context: Context) -> set[str]:
    """Links that collide with other links of their robot in Gazebo, unless a joint connects them.

    gz-sim reads only the tag of the model, Gazebo Classic the tag of each link.
    """
    simulators = context.targets.among(GAZEBO)
    of_model_alone = bool(simulators) and not context.targets.any_of(CLASSIC)
    names: set[str] = set()
    for block in context.model.gazebo:
        flags = (flag for flag in block.children if flag.tag in ("selfCollide", "self_collide"))
        reference = block.get("reference")
        if not (reference and of_model_alone) and any(map(is_true, flags)):
            names.update([reference] if reference else context.model.links_by_name)
    return names


def _collide_in_gazebo(context: Context, names: tuple[str, str], colliding: set[str]) -> bool:
    """True if Gazebo pushes two links apart: after merging links, no joint connects them."""
    if colliding.isdisjoint(names):
        return False
    first, second = (context.gazebo.survivor.get(name, "") for name in names)
    joined = {frozenset((joint.parent, joint.child)) for joint in context.gazebo.joints}
    return bool(first and second) and first != second and {first, second} not in joined


def _hull_overlap(
    context: Context, overlap: HullOverlap, simulators: list[TargetFacts], depth: float
) -> Findings:
    colliding = [
        simulator
        for simulator in simulators
        if not overlap.joint or (overlap.is_welded and simulator.collides_with_welded)
    ]
    if not colliding:
        return
    names = " and ".join(simulator.title for simulator in colliding)
    first, second = (
        context.model.collision(body.link, body.number) for body in (overlap.first, overlap.second)
    )
    yield Finding(
        second,
        f"the convex hulls of links '{overlap.first.link}' and '{overlap.second.link}', which "
        f"collide in {names}, overlap by {1000 * overlap.depth:.3g} mm",
        _hull_help(context, overlap, depth),
        related=(Related(first.span, f"link '{overlap.first.link}'"),),
        weight=overlap.depth,
        group_key="hulls",
        targets=tuple(simulator.name for simulator in colliding),
    )


def _hull_help(context: Context, overlap: HullOverlap, depth: float) -> str:
    """Help: replace a non-convex mesh by convex pieces, unless they would overlap as well."""
    contacts = context.collisions.contacts
    bodies = (overlap.first, overlap.second)
    hollow = [f"'{body.link}'" for body in bodies if _is_hollow(context, body)]
    if not hollow or contacts.is_deeper(*bodies, depth):
        return "the shapes overlap: correct an origin, or make one of the two smaller"
    links = f"link{'s' * (len(hollow) > 1)} {' and '.join(hollow)}"
    return (
        f"replace the mesh of {links} by convex pieces, each a <collision> of its own: "
        "urdfkit mesh decompose MESH --split -o OUT"
    )


def _is_hollow(context: Context, body: CollisionBody) -> bool:
    """True for a mesh whose hull is clearly larger, so that convex pieces differ from the hull."""
    shape = context.model.links_by_name[body.link].collisions[body.number].shape
    measures = context.measured.measures(shape) if shape and shape.kind == "mesh" else ""
    if isinstance(measures, str) or measures.hull is None:
        return False
    return measures.solid is None or measures.solid.volume < _FILLED * measures.hull.volume


def _adjacent(pair: LinkPair) -> tuple[Contact, str, str, Severity] | None:
    """Contact, message, help and severity of adjacent links; None if the overlap is small."""
    if pair.max_relative_depth <= _LEAST_DEPTH or (contact := pair.contact) is None:
        return None
    if not contact.is_solid or contact.relative_depth <= _LEAST_DEPTH or pair.is_contained:
        return None
    # The depth of a body that is moved out sideways exceeds its thickness.
    part = "all" if contact.relative_depth >= 1 else f"{contact.relative_depth:.0%}"
    message = f"link '{contact.small.link}' overlaps adjacent link '{contact.large.link}' by "
    message += f"{_depth(contact)}, {part} of its thickness"
    return contact, message, "make one of the two smaller, or move it", Severity.INFO


def _apart(
    pair: LinkPair, initial_pose: str, depth: float
) -> tuple[Contact, str, str, Severity] | None:
    """Contact, message, help and severity of links that are not adjacent; None if not reported."""
    contact = pair.contact
    if contact is None:
        return None
    links = f"links '{contact.small.link}' and '{contact.large.link}' overlap"
    if pair.is_permanent:
        if pair.is_contained:
            return None  # COL004
        message = f"{links} in every pose"
        if by := _by(contact):
            message += f",{by} {initial_pose}"
        help = "make the collision geometry smaller, or disable the pair in the SRDF"
        return contact, message, help, Severity.INFO
    if contact.depth > depth and pair.starts_at_zero and pair.is_deeper(depth):
        message = f"{links}{_by(contact)} where all joints are at zero"
        help = "correct an origin or the collision geometry, or begin in another pose"
        return contact, message, help, Severity.WARNING
    return None


def _by(contact: Contact) -> str:
    """The depth of an overlap; empty for triangles, whose depth is not reliable."""
    return f" by {_depth(contact)}" if contact.is_solid else ""


def _depth(contact: Contact) -> str:
    return f"{1000 * contact.depth:.3g} mm"
