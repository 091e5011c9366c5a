"""The links that overlap in the initial pose of a robot, fast enough for a check.

Bounding boxes show which pairs may overlap and how deep at most; closed forms measure most
primitives. coal is only loaded for the rest: meshes and inclined cylinders. Lengths in m.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import cached_property

from urdfkit.core.grouping import by_key
from urdfkit.core.record import Record
from urdfkit.core.spatial import Transform, minus
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.errors import Unavailable
from urdfkit.physics.collision.bodies import THINNEST, TOUCH, CollisionBody, collision_bodies
from urdfkit.physics.collision.broad_phase import lower_bound, nearby, relative
from urdfkit.physics.collision.closed_forms import point_distance, signed_distance
from urdfkit.robot.adjacency import Adjacency
from urdfkit.robot.joint_limits import span, start_of
from urdfkit.robot.kinematics import LOCKED, frames, laws, motion

if TYPE_CHECKING:
    from urdfkit.physics.collision.exact import ExactDistances
    from urdfkit.robot import Robot
    from urdfkit.robot.joint import Joint

#: Random poses in which a pair must overlap to overlap always.
_SAMPLES = 50

#: Most pairs of bodies whose spheres overlap; 111 real robots have at most 103.
MAX_NEAR = 20_000

#: Distance of zero from a limit that is near, as a part of the range; in MoveIt's Panda, zero is
#: 2 % from two limits.
_NEAR_END = 0.05

#: Two bodies whose bounding boxes overlap, and a lower bound of their signed distance.
BoundedPair = tuple[CollisionBody, CollisionBody, float]


class Contact(Record):
    """The two bodies of a pair of links that overlap most in the initial pose."""

    small: CollisionBody  # the smaller body
    large: CollisionBody  # the larger body
    depth: float  # depth of the overlap
    is_solid: bool  # True if both are convex, so that the depth is exact

    @property
    def relative_depth(self) -> float:
        """The depth as a part of the thickness of the smaller body."""
        return self.depth / max(self.small.thickness, TOUCH)


class LinkPair:
    """Two links with bodies whose bounding boxes overlap in the initial pose."""

    def __init__(
        self, contacts: Contacts, names: tuple[str, str], bounds: list[BoundedPair]
    ) -> None:
        self.names = names  # of the links
        #: True if a joint connects the links, or no link between them has bodies.
        self.is_adjacent = contacts.adjacency.is_adjacent(*names)
        #: True if only fixed joints are between them.
        self.is_rigid = contacts.adjacency.is_rigid(*names)
        self._contacts = contacts
        self.bounds = bounds  # of their bodies

    @property
    def max_relative_depth(self) -> float:
        """An upper bound of `Contact.relative_depth` for convex bodies, by bounding boxes."""
        return max(
            (
                -bound / max(_by_size(first, second)[0].thickness, TOUCH)
                for first, second, bound in self.bounds
                if first.may_be_convex and second.may_be_convex
            ),
            default=0.0,
        )

    @cached_property
    def contact(self) -> Contact | None:
        """The bodies that overlap most; None without an overlap."""
        contacts, best = self._contacts, -TOUCH
        nearest: tuple[CollisionBody, CollisionBody] | None = None
        for first, second, bound in self.bounds:
            if bound < best:
                at = relative(first, second, contacts.frames)
                distance = contacts.distance(first, second, at)
                if distance < best:
                    best, nearest = distance, (first, second)
        if nearest is None:
            return None
        return Contact(*_by_size(*nearest), -best, all(map(contacts.is_convex, nearest)))

    def is_deeper(self, depth: float) -> bool:
        """True if the two bodies of the contact overlap by more than a depth, in m."""
        if self.contact is None or self.contact.is_solid:
            return self.contact is not None and self.contact.depth > depth
        return self._contacts.is_deeper(self.contact.small, self.contact.large, depth)

    @cached_property
    def is_contained(self) -> bool:
        """True if all bodies of the small body's link are inside the large body."""
        if not self._may_be_contained or self.contact is None:
            return False
        return self._contacts.contains(self.contact.large, self.contact.small.link)

    @property
    def is_enclosed(self) -> bool:
        """True if also the bodies of all links that are fixed to this link are inside."""
        if not self.is_contained or self.contact is None:
            return False
        contacts, own = self._contacts, self.contact.small.link
        return all(
            contacts.contains(self.contact.large, link)
            for link in contacts.bodies
            if contacts.adjacency.is_rigid(link, own)
        )

    @cached_property
    def is_permanent(self) -> bool:
        """True if the links overlap with each joint at its limits, and in random poses."""
        return all(self._contacts.overlap(self.names, pose) for pose in self._poses())

    @property
    def starts_at_zero(self) -> bool:
        """True if all joints above the links begin at zero, and none between ends near zero.

        A robot that cannot be at zero is never there: its users begin in another pose. The same
        applies if zero is near the end of a range, but not the end itself.
        """
        between = self._contacts.between(self.names)
        if any(map(_ends_near_zero, self._contacts.leaders(between))):
            return False
        joints = [joint for name in self.names for joint in self._contacts.tree.path(name)]
        return not any(map(start_of, self._contacts.leaders(joints)))

    @property
    def _may_be_contained(self) -> bool:
        """False if bounding boxes show that no body of one link can contain the other link."""
        first, second = self.names
        return any(
            self._contacts.may_contain(large, own)
            for own, other in ((first, second), (second, first))
            for large in self._contacts.bodies[other]
        )

    def _poses(self) -> Iterator[dict[str, float]]:
        """The initial pose, each joint between the links at its limits, and random poses."""
        yield {}
        joints = self._contacts.between(self.names)
        spans = {joint.name: span(joint) for joint in self._contacts.leaders(joints)}
        for name, ends in spans.items():
            yield from ({name: end} for end in ends)
        from random import Random  # takes 2 ms to import

        random = Random(0)
        for _ in range(_SAMPLES):
            yield {name: random.uniform(*ends) for name, ends in spans.items()}


class Contacts:
    """The links of a robot that may overlap in the initial pose.

    Attributes:
        tree: kinematic tree of the robot.
        bodies: bodies by link name.
        frames: frames of the links in the initial pose, in the frame of their root.
        adjacency: of the links.

    Args:
        load: creates the distance queries by coal; called on first use.
        unit: apply the unit of COLLADA files.
    """

    def __init__(self, robot: Robot, load: Callable[[], ExactDistances], *, unit: bool) -> None:
        tree = self.tree = robot.tree
        self._load = load
        self._joints = tree.model.joints_by_name
        self._laws = laws(self._joints)
        self._start = {name: start_of(joint) for name, joint in self._joints.items()}
        self.adjacency = Adjacency(tree)
        self.frames = frames(tree, self._start)
        bodies = collision_bodies(robot, unit=unit)
        self.bodies = by_key((body.link, body) for body in bodies if body.link in self.frames)

    @cached_property
    def pairs(self) -> tuple[LinkPair, ...]:
        """The pairs of links whose bounding boxes overlap, in the order of the document.

        Raises:
            Unavailable: more than MAX_NEAR pairs of bodies are near each other.
        """
        order = {name: number for number, name in enumerate(self.bodies)}
        found: dict[tuple[str, str], list[BoundedPair]] = {}
        for number, near in enumerate(nearby(self._all_bodies, self.frames)):
            if number == MAX_NEAR:
                raise Unavailable(f"more than {MAX_NEAR} pairs of collision bodies may overlap")
            first, second = sorted(near, key=lambda body: order[body.link])
            names = (first.link, second.link)
            bound = lower_bound(first, second, relative(first, second, self.frames))
            if bound < -TOUCH and self._tops[names[0]] == self._tops[names[1]]:
                found.setdefault(names, []).append((first, second, bound))
        pairs = sorted(found.items(), key=lambda pair: [order[name] for name in pair[0]])
        return tuple(LinkPair(self, names, bounds) for names, bounds in pairs)

    @property
    def initial_pose(self) -> str:
        """The initial pose in words."""
        elsewhere = ", ".join(
            f"{joint.name} {start:.3g}"
            for joint in self.leaders(self._joints.values())
            if (start := start_of(joint))
        )
        return "where all joints are at zero" + (
            f" ({elsewhere}: zero is beyond the limits)" if elsewhere else ""
        )

    def distance(self, first: CollisionBody, second: CollisionBody, at: Transform) -> float:
        """The signed distance of two bodies: exact if they overlap, otherwise any value above 0.

        Args:
            at: frame of the second body in the first.
        """
        distance = signed_distance(first.kind, first.size, second.kind, second.size, at)
        return self._exact.distance(first, second, at) if distance is None else distance

    def hull_distance(self, first: CollisionBody, second: CollisionBody) -> float:
        """The signed distance of the convex hulls of two bodies in the initial pose, in m."""
        at = relative(first, second, self.frames)
        distance = signed_distance(first.kind, first.size, second.kind, second.size, at)
        return self._exact.hull_distance(first, second, at) if distance is None else distance

    def is_deeper(self, first: CollisionBody, second: CollisionBody, depth: float) -> bool:
        """True if two bodies, one of them not convex, overlap by more than a depth, in m."""
        return self._exact.is_deeper(first, second, relative(first, second, self.frames), depth)

    def is_convex(self, body: CollisionBody) -> bool:
        """True for primitives, and meshes that fill their hull."""
        return body.may_be_convex and (body.kind != "mesh" or self._exact.is_convex(body))

    def overlap(self, names: tuple[str, str], pose: Mapping[str, float]) -> bool:
        """True if two links overlap.

        Args:
            pose: positions of joints between the links; the default is the initial pose.
        """
        placed = {
            name: self._end_frame(path, pose)
            for name, path in zip(names, self.tree.branches(*names), strict=True)
        }
        for first in self.bodies[names[0]]:
            for second in self.bodies[names[1]]:
                at = relative(first, second, placed)
                if (
                    lower_bound(first, second, at) < -TOUCH
                    and self.distance(first, second, at) < -TOUCH
                ):
                    return True
        return False

    def contains(self, large: CollisionBody, link: str) -> bool:
        """True if all bodies of a link are inside a convex body."""
        return (
            self.may_contain(large, link)
            and self.is_convex(large)
            and all(self._is_inside(body, large) for body in self.bodies[link])
        )

    def may_contain(self, large: CollisionBody, link: str) -> bool:
        """False if a body is not convex, or bounding boxes show that the link protrudes from it."""
        box = (2 * large.half[0], 2 * large.half[1], 2 * large.half[2])
        return large.may_be_convex and all(
            point_distance("box", box, minus(at.apply(point), large.center)) < 0
            for body in self.bodies[link]
            for at in (relative(large, body, self.frames),)
            for point in body.points
        )

    def _is_inside(self, body: CollisionBody, large: CollisionBody) -> bool:
        """True if a mesh, or the bounding box of a primitive, is inside a convex body."""
        at = relative(large, body, self.frames)
        if large.kind == "mesh":
            return self._exact.is_inside(body, large, at)
        points = self._exact.vertices(body) if body.kind == "mesh" else body.points
        return all(
            point_distance(large.kind, large.size, at.apply(point)) < -THINNEST for point in points
        )

    def between(self, names: tuple[str, str]) -> list[Joint]:
        """The joints between two links."""
        first, second = self.tree.branches(*names)
        return [*first, *second]

    def leaders(self, joints: Iterable[Joint]) -> list[Joint]:
        """The independent joints that move the given joints: themselves, or the mimicked ones."""
        names = dict.fromkeys(
            self._laws[joint.name].leader
            for joint in joints
            if joint.is_single_dof and joint.name in self._laws
        )
        return [self._joints[name] for name in names if name in self._joints]

    @cached_property
    def _exact(self) -> ExactDistances:
        return self._load()

    @property
    def _all_bodies(self) -> list[CollisionBody]:
        return [body for bodies in self.bodies.values() for body in bodies]

    @cached_property
    def _tops(self) -> dict[str, str]:
        """For each link, the topmost link that no planar or floating joint separates from it."""
        tops = {root.name: root.name for root in self.tree.roots}
        for joint in self.tree.spanning:
            child = joint.child_name
            is_free = joint.kind in ("planar", "floating")
            tops[child] = child if is_free else tops[joint.parent_name]
        return tops

    def _end_frame(self, path: Iterable[Joint], pose: Mapping[str, float]) -> Transform:
        """The frame at the end of a path of joints, in the frame of its start."""
        frame = Transform()
        for joint in path:
            leader, factor, shift = self._laws.get(joint.name, LOCKED)
            position = factor * pose.get(leader, self._start.get(leader, 0.0)) + shift
            frame = frame @ joint.origin @ motion(joint, position)
        return frame


def _by_size(first: CollisionBody, second: CollisionBody) -> tuple[CollisionBody, CollisionBody]:
    """The smaller and the larger of two bodies."""
    return (first, second) if first.radius < second.radius else (second, first)


def _ends_near_zero(joint: Joint) -> bool:
    """True if zero is near an end of a joint's range, but not the end itself."""
    lower, upper = span(joint)
    return 0 < min(abs(lower), abs(upper)) < _NEAR_END * (upper - lower)
