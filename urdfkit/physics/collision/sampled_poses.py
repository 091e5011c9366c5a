"""The bodies of a robot in a few poses: where it begins, and each joint at its limits.

No process is started: this is what a check can afford.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cached_property
from math import inf
from typing import NamedTuple

import numpy as np

from urdfkit.mesh.geometry import Floats
from urdfkit.physics.collision.batch_kinematics import Axis, chain
from urdfkit.physics.collision.collision_geometry import (
    TOUCH,
    CollisionGeometry,
    DistanceQuery,
    form,
)
from urdfkit.physics.collision.geometry_arrays import (
    NO_FACES,
    NO_VERTICES,
    THINNEST,
    CollisionArrays,
    solids,
)
from urdfkit.physics.collision.pair_queries import Examiner, Pair
from urdfkit.robot.adjacency import Adjacency
from urdfkit.robot.assets.triangles import Meshes
from urdfkit.robot.clearance import NEAR
from urdfkit.robot.model import RobotModel
from urdfkit.robot.tree import KinematicTree

#: Drawn poses that a pair which always collides must collide in, too.
_SAMPLES = 50
#: Colliding samples of a pair in which the other pairs are looked at.
_POSES = 20

#: Of the range of a joint: zero is 2 % from two limits of the Panda that MoveIt ships.
_NEAR_END = 0.05

_CORNERS = np.array(list(np.ndindex(2, 2, 2))) * 2.0 - 1
_POINT = form(CollisionArrays("", 0, np.eye(4), "sphere", (THINNEST,), NO_VERTICES, NO_FACES))


class Contact(NamedTuple):
    """Two links that overlap, or nearly touch, where the robot begins.

    Attributes:
        small: the smaller one of the two bodies that overlap most.
        large: the other one.
        distance: of these two, signed, in m.
        part: how deep they overlap, as a part of the thickness of the smaller one.
        is_solid: both bodies are convex, so that the depth is true.
        is_contained: all bodies of the smaller one's link are in the inside of the large one.
        is_out_of_reach: so are those of all links that fixed joints bind to it.
        is_adjacent: a joint holds the links together, or nothing with bodies lies between.
        is_rigid: only fixed joints lie between.
    """

    small: CollisionArrays
    large: CollisionArrays
    distance: float
    part: float
    is_solid: bool
    is_contained: bool
    is_out_of_reach: bool
    is_adjacent: bool
    is_rigid: bool

    @property
    def bodies(self) -> tuple[tuple[str, int], tuple[str, int]]:
        """Link and number of the small and of the large body."""
        return (self.small.link, self.small.number), (self.large.link, self.large.number)


class Collision(NamedTuple):
    """Two links that overlap: how deep, in m, and the joints between them."""

    depth: float
    pose: dict[str, float]


class SampledPoses:
    """A robot in a few poses.

    Args:
        model: the robot.
        tree: of it.
        meshes: of it.
        unit: apply the unit that a COLLADA file states.
    """

    def __init__(
        self, model: RobotModel, tree: KinematicTree, meshes: Meshes, *, unit: bool
    ) -> None:
        bodies, self.omitted = solids(model, meshes, unit=unit)
        self.chain = chain(tree)
        self._adjacency = Adjacency(tree)
        self._examiner = Examiner(self.chain, map(form, bodies))
        self._number = {name: index for index, name in enumerate(self.chain.links)}

    @property
    def beginning(self) -> str:
        """Where the joints begin, in words."""
        elsewhere = [f"{a.joint} {a.default:.3g}" for a in self.chain.axes if a.default]
        return "where all joints are at zero" + (
            f" ({', '.join(elsewhere)}: zero is beyond the limits)" if elsewhere else ""
        )

    @cached_property
    def meetings(self) -> tuple[Contact, ...]:
        """The pairs of links that overlap or nearly touch where the robot begins."""
        return tuple(self._meetings())

    def always(self, meeting: Contact) -> bool:
        """True if two links overlap with each joint at its limits, and in some drawn poses."""
        pair = self._pair(meeting.small.link, meeting.large.link)
        rows = np.concatenate([self.chain.extremes(), self.chain.samples(_SAMPLES, 0, 0)])
        (seen,) = self._examiner.look([pair]).at(rows, count=True)
        return seen.hits == len(rows)

    def is_at_zero(self, meeting: Contact) -> bool:
        """True if no joint above two links begins elsewhere than at zero, nor between them almost.

        A robot that cannot be at zero is never there: its users begin in a pose of their own. One
        that comes there shortly before the end of a range, but not at it, is hardly ever.
        """
        pair = self._pair(meeting.small.link, meeting.large.link)
        if any(_ends_near_zero(self.chain.axes[column]) for column in self.chain.between(*pair)):
            return False
        for link in (meeting.small.link, meeting.large.link):
            at = self._number[link]
            while step := self.chain.above.get(at):
                if step.column >= 0 and self.chain.axes[step.column].default:
                    return False
                at = step.parent
        return True

    def colliding(
        self,
        pairs: Sequence[tuple[str, str]],
        samples: int,
        is_checked: Callable[[frozenset[str]], bool],
    ) -> list[Collision | None]:
        """For each pair of links that move, a collision that no other one keeps the robot from.

        Args:
            pairs: of links.
            samples: configurations that are looked at.
            is_checked: of two links, whether their collisions are avoided; where two of these
                overlap, the robot never is.
        """
        known = [self._pair(*pair) for pair in pairs]
        bound = [pair for pair in known if self._is_bound(pair) and self.chain.between(*pair)]
        rows = self.chain.samples(samples, 0, 0)
        hits = self._examiner.look(bound).hits(rows)
        poses = {
            pair: self._poses(pair, rows[at[:_POSES]])
            for pair, at in zip(bound, hits, strict=True)
            if at
        }
        if not poses:
            return [None] * len(known)
        links = self._examiner.links
        checked = [
            pair for pair in self.chain.pairs(links) if is_checked(frozenset(self._names(pair)))
        ]
        every = np.concatenate(list(poses.values()))
        is_free = np.ones(len(every), dtype=bool)
        for at in self._examiner.look(checked).hits(every):
            is_free[at] = False
        found: dict[Pair, Collision] = {}
        ends = np.cumsum([len(some) for some in poses.values()])[:-1]
        for (pair, some), free in zip(poses.items(), np.split(is_free, ends), strict=True):
            if free.any():
                (seen,) = self._examiner.look([pair]).at(some[free], count=True)
                pose = self.chain.pose(some[free][seen.row], *pair)
                found[pair] = Collision(-seen.distance, pose)
        return [found.get(pair) for pair in known]

    def _poses(self, pair: Pair, rows: Floats) -> Floats:
        """Some configurations, and the same with all joints that do not move a pair at default."""
        columns = self.chain.between(*pair)
        return np.concatenate([rows, self.chain.default_with(columns, rows[:, columns])])

    def has_bodies(self, link: str) -> bool:
        """True if a link has bodies that can collide."""
        return self._number.get(link) in self._examiner.links

    def _pair(self, first: str, second: str) -> Pair:
        a, b = sorted((self._number[first], self._number[second]))
        return a, b

    def _names(self, pair: Pair) -> tuple[str, str]:
        return self.chain.links[pair[0]], self.chain.links[pair[1]]

    def _is_bound(self, pair: Pair) -> bool:
        """True if joints with limits say how two links stand to one another."""
        return self.chain.parts[pair[0]] == self.chain.parts[pair[1]]

    def _meetings(self) -> Iterator[Contact]:
        row = self.chain.default[None]
        frames = self._examiner.frames(row, self._examiner.links)
        for pair in self._close(frames):
            best = NEAR
            nearest: tuple[int, int, DistanceQuery] | None = None
            for gauged in self._examiner.gauges(pair):
                distance = _distance(gauged, frames, best)
                if distance < best:
                    best, nearest = distance, gauged
            if nearest is not None:
                yield self._meeting(pair, nearest, frames, best)

    def _meeting(
        self,
        pair: Pair,
        nearest: tuple[int, int, DistanceQuery],
        frames: dict[int, Floats],
        distance: float,
    ) -> Contact:
        first, second, gauge = nearest
        bodies = sorted(
            ((gauge.second, second), (gauge.first, first)), key=lambda one: one[0].radius
        )
        (small, _), (large, at) = bodies
        own = pair[0] if small is gauge.first else pair[1]
        names = self._names(pair)
        is_contained = self._is_inside(own, large, frames[at][0], frames)
        return Contact(
            small.solid,
            large.solid,
            distance,
            -distance / max(2 * float(small.half.min()), TOUCH),
            small.is_convex and large.is_convex,
            is_contained,
            is_contained
            and all(
                self._is_inside(link, large, frames[at][0], frames)
                for link in self._examiner.links
                if self._adjacency.is_rigid(self.chain.links[link], self.chain.links[own])
            ),
            self._adjacency.is_adjacent(*names),
            self._adjacency.is_rigid(*names),
        )

    def _is_inside(
        self, link: int, large: CollisionGeometry, at: Floats, frames: dict[int, Floats]
    ) -> bool:
        """True if all bodies of a link are in the inside of a body that is at a frame (4, 4)."""
        return all(
            _is_inside(self._examiner.form(body), frames[body][0], large, at)
            for body in self._examiner.bodies(link)
        )

    def _close(self, frames: dict[int, Floats]) -> list[Pair]:
        """The pairs of links with spheres around them that come near in one of some poses.

        Args:
            frames: (n, 4, 4), of each body in these poses.
        """
        links = self._examiner.links
        spheres = [self._sphere(link, frames) for link in links]
        centers = np.array([center for center, _ in spheres])
        reach = np.array([radius for _, radius in spheres])
        close = []
        for number, link in enumerate(links):
            way = np.linalg.norm(centers[number + 1 :] - centers[number], axis=2)
            gap = way.min(axis=1, initial=inf) - reach[number + 1 :] - reach[number]
            close += [(link, links[number + 1 + at]) for at in np.flatnonzero(gap < NEAR)]
        return list(filter(self._is_bound, close))

    def _sphere(self, link: int, frames: dict[int, Floats]) -> tuple[Floats, float]:
        """Centers (n, 3) and radius of a sphere that holds the bodies of a link."""
        bodies = self._examiner.bodies(link)
        forms = [self._examiner.form(body) for body in bodies]
        centers = [
            frames[body][:, :3, :3] @ one.center + frames[body][:, :3, 3]
            for body, one in zip(bodies, forms, strict=True)
        ]
        middle = np.mean(centers, axis=0)
        reach = max(
            float(np.linalg.norm(center[0] - middle[0])) + one.radius
            for center, one in zip(centers, forms, strict=True)
        )
        return middle, reach


def _ends_near_zero(axis: Axis) -> bool:
    """True if zero is next to an end of a joint's range, but not the end itself."""
    ends = min(abs(axis.lower), abs(axis.upper))
    return 0 < ends < _NEAR_END * (axis.upper - axis.lower)


def _distance(
    gauged: tuple[int, int, DistanceQuery], frames: dict[int, Floats], limit: float
) -> float:
    first, second, gauge = gauged
    way = np.linalg.inv(frames[first][0]) @ frames[second][0]
    return gauge.distance(way[:3, :3], way[:3, 3], limit)


def _is_inside(
    small: CollisionGeometry, at: Floats, large: CollisionGeometry, frame: Floats
) -> bool:
    """True if a body, or the box around a primitive, is in the inside of a convex body."""
    if not large.is_convex:
        return False
    corners = small.center + _CORNERS * small.half
    if small.solid.kind == "mesh":
        corners = small.solid.vertices
    way = np.linalg.inv(frame) @ at
    gauge = DistanceQuery(large, _POINT)
    return all(
        gauge.distance(np.eye(3), point, inf) < -2 * THINNEST
        for point in corners @ way[:3, :3].T + way[:3, 3]
    )
