"""Overlapping links in a configuration, computed by coal."""

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from urdfkit.core.installation import needing
from urdfkit.lint.context import Context
from urdfkit.lint.requirements import need_coal
from urdfkit.robot.adjacency import Adjacency


class Overlap(NamedTuple):
    """Two links whose collision shapes overlap."""

    first: str  # name of the first link
    second: str  # name of the second link
    depth: float  # in m
    is_adjacent: bool  # True if the links are adjacent, so that programs ignore the overlap


def overlaps(context: Context, pose: Mapping[str, float]) -> Iterator[Overlap]:
    """The pairs of links that overlap.

    Args:
        pose: positions of joints, in rad or m; the others are at 0.

    Raises:
        MissingLibrary: coal is not installed.
        Unavailable: coal is too old.
    """
    with needing("the layer of contacts", "dynamics"):
        import coal  # noqa: F401 - for the message if it is missing

        need_coal()
        from urdfkit.physics.collision.batch_kinematics import tree_arrays
        from urdfkit.physics.collision.collision_geometry import build_geometries
        from urdfkit.physics.collision.geometry_arrays import collision_arrays
        from urdfkit.physics.collision.pair_queries import CollisionModel
    moving = tree_arrays(context.tree)
    bodies, _ = collision_arrays(context.model, context.meshes)
    links = set(moving.links)
    collision_model = CollisionModel(
        moving, build_geometries(body for body in bodies if body.link in links)
    )
    adjacency = Adjacency(context.tree)
    pairs = list(moving.pairs(collision_model.links))
    row = moving.row({axis.joint: pose.get(axis.joint, 0.0) for axis in moving.axes})
    samples = collision_model.query(pairs, 0.0).at(row[None], count=True)
    for (first, second), sample in zip(pairs, samples, strict=True):
        if sample.hits:
            names = moving.links[first], moving.links[second]
            is_adjacent = adjacency.is_adjacent(*names) or adjacency.is_rigid(*names)
            yield Overlap(*names, -sample.distance, is_adjacent)
