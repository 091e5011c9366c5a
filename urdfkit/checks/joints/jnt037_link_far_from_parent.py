"""A link is far away from its parent link, or has the parent of the link before it in a chain.

- The gap between the shapes of the two links is four times as long as either shape, and no link
  that fixed joints connect to one of them is in between. Usually a decimal point is misplaced, 2.45
  for 0.245, or the origin is measured from the root of the robot instead of the parent link. The
  second of two arms on one base may stand far away, and so may a camera that is fixed to `world`
  with the base of an arm.
- A link with a collision that is fixed to the end of a limb, such as a foot, does not touch it: the
  gap is 0.6 times as long as either shape. Tools that are only frames or markers may be anywhere.
- The links or joints of an arm are numbered, but `link_3` and `link_4` are both children of
  `link_2`, `link_3` has no child, and `link_5` follows `link_4`: the parent of `link_4` was not
  corrected in a copy.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    measured: none of 1092 public robots skips a link
"""

import re
from collections.abc import Iterator, Mapping
from itertools import islice

from urdfkit.core.spatial import Transform
from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Related, Severity, rule
from urdfkit.robot.joint import Joint
from urdfkit.robot.link import Link
from urdfkit.robot.rigid_bodies import RigidBody, rigid_bodies
from urdfkit.robot.samples import joint_xml, link_xml, robot_xml, visual_xml
from urdfkit.robot.shapes import LinkSolid, solid

_SHAPE = visual_xml('<box size="0.05 0.05 0.24"/>', '<origin xyz="0 0 0.12"/>')
BAD = robot_xml(
    link_xml("base", _SHAPE), link_xml("arm", _SHAPE), joint_xml("fixed", '<origin xyz="0 0 2.4"/>')
)
GOOD = BAD.replace("2.4", "0.24")

#: Least gap: times the longest shape, and in m.
_MIN_RELATIVE_GAP = 4.0
_MIN_GAP = 0.3

#: Least number of links of an arm.
_MIN_ARM = 4
#: Most joints of the base of two arms.
_MAX_SIBLINGS = 20

#: The same for a foot.
_FOOT_GAPS = 0.6, 0.08

_NUMBER = r"\d{1,9}"
#: Most numbers of a name that are tried: of the robot, an arm, a finger, a link.
_MAX_NUMBERS = 8

#: Types of joints whose links stay together; prismatic and free links may be anywhere.
_JOINTS_WITHOUT_GAP = ("fixed", "revolute", "continuous")


@rule(
    Severity.WARNING,
    confidence=Confidence.INFERRED,
    help="check the decimal point; the origin is measured from the parent link, in m",
)
def check(context: Context) -> Findings:
    far = list(_far(context))
    bodies = rigid_bodies(context.tree) if far else ()
    body_of = {name: body for body in bodies for name in body.names}
    for joint, parent, child, (gap, longest) in far:
        is_near = _is_bridged(context, parent, child, body_of, _least_gaps(context, joint, child))
        # What stands in the world with a robot, such as a camera above it, stands anywhere.
        body = body_of.get(parent.name)  # none in a loop
        is_in_world = joint.kind == "fixed" and body is not None and body.is_ground
        if not (is_near or is_in_world or _is_second_arm(context, joint)):
            yield Finding(
                joint.at.child_or_self("origin"),
                f"joint '{joint.name}': '{child.name}' is {gap:.3g} m away from '{parent.name}'; "
                f"neither is longer than {longest:.3g} m",
            )
    yield from _skipped(context)


def _skipped(context: Context) -> Findings:
    """Numbered links, or links of numbered joints, whose parent is not the one before, a leaf."""
    moving = [joint for joint in context.model.joints if joint.is_single_dof]
    parents = {joint.parent_name for joint in context.model.joints}
    reported: set[str] = set()
    for named in (
        {joint.child_name: joint for joint in moving},
        {joint.name: joint for joint in moving},
    ):
        for name, joint in named.items():
            for match in islice(re.finditer(_NUMBER, name), _MAX_NUMBERS):
                previous, following = (named.get(_numbered(name, match, step)) for step in (-1, 1))
                if previous is None or following is None or joint.name in reported:
                    continue
                is_followed = following.parent_name == joint.child_name
                before = previous.child_name
                is_sibling = previous.parent_name == joint.parent_name and before not in parents
                if is_followed and is_sibling:
                    reported.add(joint.name)
                    yield _skipping(joint, previous)


def _skipping(joint: Joint, previous: Joint) -> Finding:
    return Finding(
        joint.at.child_or_self("parent"),
        f"joint '{joint.name}': '{joint.child_name}' has the same parent '{joint.parent_name}' as "
        f"'{previous.child_name}', which has no child",
        f"name '{previous.child_name}' as its parent, if the links are a chain",
        related=(Related(previous.at.span, f"joint '{previous.name}'"),),
    )


def _numbered(name: str, number: re.Match[str], step: int) -> str:
    """A name with another number of as many digits, if that begins with 0."""
    digits = number.group()
    width = len(digits) if digits.startswith("0") else 0
    return f"{name[: number.start()]}{int(digits) + step:0{width}d}{name[number.end() :]}"


def _far(context: Context) -> Iterator[tuple[Joint, Link, Link, tuple[float, float]]]:
    """The joints whose links are far from each other, with parent, child, gap and longest edge."""
    links = context.model.links_by_name
    for joint in context.model.joints:
        ends = (joint.parent, joint.child)
        parent, child = (links.get(end.value) if end else None for end in ends)
        if parent is None or child is None or joint.kind not in _JOINTS_WITHOUT_GAP:
            continue
        least = _least_gaps(context, joint, child)
        if max(map(abs, joint.origin.position)) < least[1]:
            continue
        if gap := _gap(context, parent, child, joint.origin, least):
            yield joint, parent, child, gap


def _least_gaps(context: Context, joint: Joint, child: Link) -> tuple[float, float]:
    """The least gap that is reported: times the longest shape, and in m."""
    above = context.tree.parents.get(joint.parent_name, [])
    is_foot = joint.kind == "fixed" and child.collisions and not context.tree.children[child.name]
    if is_foot and above and above[0].is_single_dof:
        return _FOOT_GAPS
    return _MIN_RELATIVE_GAP, _MIN_GAP


def _gap(
    context: Context, here: Link, there: Link, frame: Transform, least: tuple[float, float]
) -> tuple[float, float] | None:
    """The gap between two links and the length of the longer one, in m; None if there is none.

    Args:
        frame: frame of the second link in that of the first.
        least: of `_least_gaps`.
    """
    first, second = (_solid(context, link) for link in (here, there))
    if first is None or second is None:
        return None
    one, other = first.bounds, second.bounds.moved(frame)
    gap = one.gap(other)
    longest = max(*one.edges, *other.edges)
    times_longest, metres = least
    return (gap, longest) if gap > max(times_longest * longest, metres) else None


def _is_second_arm(context: Context, joint: Joint) -> bool:
    """True for one of two arms of as many links on one link, which stand apart from each other."""
    tree = context.tree
    siblings = tree.children[joint.parent_name]
    if not 2 <= len(siblings) <= _MAX_SIBLINGS:
        return False
    sizes = [len(tree.below(each.child_name)) for each in siblings]
    size = len(tree.below(joint.child_name))
    return size >= _MIN_ARM and sizes.count(size) == 2


def _is_bridged(
    context: Context,
    parent: Link,
    child: Link,
    body_of: Mapping[str, RigidBody],
    least: tuple[float, float],
) -> bool:
    """True if a link that is merged with one of two links is near the other, or may be.

    Args:
        body_of: the rigid body that contains each link, by link name.
        least: of `_least_gaps`.
    """
    frames = context.tree.frames
    if not {parent.name, child.name} <= frames.keys():
        return False
    below = set(context.tree.below(child.name))
    for end, other in ((parent, child), (child, parent)):
        for link, _ in body_of[end.name].links:
            is_on_this_side = (link.name in below) == (end is child)
            if (
                link.name == end.name
                or not is_on_this_side
                or not (link.visuals or link.collisions)
            ):
                continue
            frame = frames[link.name].inverse @ frames[other.name]
            if _gap(context, link, other, frame, least) is None:
                return True
    return False


def _solid(context: Context, link: Link) -> LinkSolid | None:
    return solid(link.visuals, context.mesh_solid) or solid(link.collisions, context.mesh_solid)
