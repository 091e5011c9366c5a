"""Collisions of a robot in sampled poses, without a process: what a check can afford."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from urdfkit.mesh.geometry import Floats
from urdfkit.physics.collision.batch_kinematics import tree_arrays
from urdfkit.physics.collision.collision_geometry import build_geometry
from urdfkit.physics.collision.geometry_arrays import collision_arrays
from urdfkit.physics.collision.pair_queries import CollisionModel, Pair
from urdfkit.robot.assets.triangles import Meshes
from urdfkit.robot.model import RobotModel
from urdfkit.robot.tree import KinematicTree

#: Colliding samples of a pair in which the other pairs are looked at.
_POSES = 20


class Collision(NamedTuple):
    """Two links that overlap: how deep, in m, and the joints between them."""

    depth: float
    pose: dict[str, float]


class SampledPoses:
    """A robot in sampled poses.

    Args:
        unit: apply the unit that a COLLADA file states.
    """

    def __init__(
        self, model: RobotModel, tree: KinematicTree, meshes: Meshes, *, unit: bool
    ) -> None:
        bodies, _ = collision_arrays(model, meshes, unit=unit)
        self.kinematics = tree_arrays(tree)
        self._collision_model = CollisionModel(self.kinematics, map(build_geometry, bodies))
        self._number = {name: index for index, name in enumerate(self.kinematics.links)}

    def colliding(
        self,
        pairs: Sequence[tuple[str, str]],
        samples: int,
        is_checked: Callable[[frozenset[str]], bool],
    ) -> list[Collision | None]:
        """Find for each pair of moving links a collision that no other collision prevents.

        Args:
            is_checked: of two links, whether their collisions are avoided; where two of these
                overlap, the robot never is.
        """
        # Limits of 0.0: how far apart meshes are that do not overlap takes most of the time.
        known = [self._pair(*pair) for pair in pairs]
        bound = [pair for pair in known if self._is_bound(pair) and self.kinematics.between(*pair)]
        rows = self.kinematics.samples(samples, 0, 0)
        seen = self._collision_model.query(bound, 0.0).at(rows, count=True)
        poses = {
            pair: self._poses(pair, rows[one.hits[:_POSES]])
            for pair, one in zip(bound, seen, strict=True)
            if one.hits
        }
        if not poses:
            return [None] * len(known)
        links = self._collision_model.links
        checked = [
            pair
            for pair in self.kinematics.pairs(links)
            if is_checked(frozenset(self._names(pair)))
        ]
        every = np.concatenate(list(poses.values()))
        is_free = np.ones(len(every), dtype=bool)
        for one in self._collision_model.query(checked, 0.0).at(every, count=True):
            is_free[one.hits] = False
        found: dict[Pair, Collision] = {}
        ends = np.cumsum([len(some) for some in poses.values()])[:-1]
        for (pair, some), free in zip(poses.items(), np.split(is_free, ends), strict=True):
            if free.any():
                (nearest,) = self._collision_model.query([pair], 0.0).at(some[free], count=True)
                pose = self.kinematics.pose(some[free][nearest.row], *pair)
                found[pair] = Collision(-nearest.distance, pose)
        return [found.get(pair) for pair in known]

    def _poses(self, pair: Pair, rows: Floats) -> Floats:
        """Some configurations, and the same with all joints that do not move a pair at default."""
        columns = self.kinematics.between(*pair)
        return np.concatenate([rows, self.kinematics.default_with(columns, rows[:, columns])])

    def has_bodies(self, link: str) -> bool:
        """True if a link has bodies that can collide."""
        return self._number.get(link) in self._collision_model.links

    def _pair(self, first: str, second: str) -> Pair:
        a, b = sorted((self._number[first], self._number[second]))
        return a, b

    def _names(self, pair: Pair) -> tuple[str, str]:
        return self.kinematics.links[pair[0]], self.kinematics.links[pair[1]]

    def _is_bound(self, pair: Pair) -> bool:
        """True if joints with limits say how two links stand to one another."""
        return self.kinematics.parts[pair[0]] == self.kinematics.parts[pair[1]]
