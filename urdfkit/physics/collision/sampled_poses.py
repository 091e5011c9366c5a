"""Collisions of a robot in sampled poses, without worker processes, fast enough for a check."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from urdfkit.mesh.geometry import Floats
from urdfkit.physics.collision.batch_kinematics import tree_arrays
from urdfkit.physics.collision.collision_geometry import build_geometries
from urdfkit.physics.collision.geometry_arrays import collision_arrays
from urdfkit.physics.collision.pair_queries import CollisionModel, Pair
from urdfkit.robot.assets.triangles import Meshes
from urdfkit.robot.model import RobotModel
from urdfkit.robot.tree import KinematicTree

#: Triangles that are tested before the first collision of two bodies. Gears that mesh take 3 µs for
#: each, and never collide; separate links take a hundredth.
_EFFORT = 4e6

#: Colliding samples of a pair in which the other pairs are tested.
_POSES = 20


class Collision(NamedTuple):
    """An overlap of two links: its depth in m, and the positions of the joints between them."""

    depth: float
    pose: dict[str, float]


class SampledPoses:
    """A robot in sampled poses.

    Args:
        unit: apply the unit of COLLADA files.
    """

    def __init__(
        self, model: RobotModel, tree: KinematicTree, meshes: Meshes, *, unit: bool
    ) -> None:
        bodies, _ = collision_arrays(model, meshes, unit=unit)
        self.kinematics = tree_arrays(tree)
        self._collision_model = CollisionModel(self.kinematics, build_geometries(bodies))
        self._number = {name: index for index, name in enumerate(self.kinematics.links)}

    def colliding(
        self,
        pairs: Sequence[tuple[str, str]],
        samples: int,
        is_checked: Callable[[frozenset[str]], bool],
    ) -> list[Collision | None]:
        """Find for each pair of moving links a collision that no other collision prevents.

        Args:
            is_checked: True for two links whose collisions are avoided; the robot never reaches
                poses in which such links overlap.
        """
        # Limits of 0.0, because measuring the distance of separate meshes takes most of the time.
        numbers = [self._pair(*pair) for pair in pairs]
        # A matrix may list a pair several times; the query answers once for each.
        bound = [
            pair
            for pair in dict.fromkeys(numbers)
            if self._is_bound(pair) and self.kinematics.between(*pair)
        ]
        rows = self.kinematics.samples(samples, 0, 0)
        results = self._collision_model.query(bound, 0.0, effort=_EFFORT).at(rows, count=True)
        poses = {
            pair: self._poses(pair, rows[result.hits[:_POSES]])
            for pair, result in zip(bound, results, strict=True)
            if result.hits
        }
        collisions: dict[Pair, Collision] = {}
        for pair, free in self._reached(poses, is_checked):
            (nearest,) = self._collision_model.query([pair], 0.0).at(free, count=True)
            pose = self.kinematics.pose(free[nearest.row], *pair)
            collisions[pair] = Collision(-nearest.distance, pose)
        return [collisions.get(pair) for pair in numbers]

    def _reached(
        self, poses: Mapping[Pair, Floats], is_checked: Callable[[frozenset[str]], bool]
    ) -> Iterator[tuple[Pair, Floats]]:
        """The pairs with their poses in which no links whose collisions are avoided overlap."""
        if not poses:
            return
        pairs = self.kinematics.pairs(self._collision_model.links)
        checked = [pair for pair in pairs if is_checked(frozenset(self._names(pair)))]
        every = np.concatenate(list(poses.values()))
        is_free = np.ones(len(every), dtype=bool)
        for result in self._collision_model.query(checked, 0.0).at(every, count=True):
            is_free[result.hits] = False
        ends = np.cumsum([len(rows) for rows in poses.values()])[:-1]
        for (pair, rows), free in zip(poses.items(), np.split(is_free, ends), strict=True):
            if free.any():
                yield pair, rows[free]

    def _poses(self, pair: Pair, rows: Floats) -> Floats:
        """Configurations, also with defaults for all joints that do not move the pair."""
        columns = self.kinematics.between(*pair)
        return np.concatenate([rows, self.kinematics.default_with(columns, rows[:, columns])])

    def has_bodies(self, link: str) -> bool:
        """True if a link has collision bodies."""
        return self._number.get(link) in self._collision_model.links

    def _pair(self, first: str, second: str) -> Pair:
        a, b = sorted((self._number[first], self._number[second]))
        return a, b

    def _names(self, pair: Pair) -> tuple[str, str]:
        return self.kinematics.links[pair[0]], self.kinematics.links[pair[1]]

    def _is_bound(self, pair: Pair) -> bool:
        """True if two links are in the same part of the robot."""
        return self.kinematics.parts[pair[0]] == self.kinematics.parts[pair[1]]
