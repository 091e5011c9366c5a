"""The collisions that Pinocchio's own loop finds, with its own reading of robot and meshes."""

from itertools import combinations
from pathlib import Path
from typing import Any

import pytest

np = pytest.importorskip("numpy")
pytest.importorskip("coal")

from urdfkit.lint.loading import read
from urdfkit.mesh.geometry import Floats, Integers
from urdfkit.physics.collision.batch_kinematics import tree_arrays
from urdfkit.physics.collision.collision_geometry import MARGIN, build_geometry
from urdfkit.physics.collision.geometry_arrays import collision_arrays
from urdfkit.physics.collision.pair_queries import CollisionModel
from urdfkit.robot.adjacency import Adjacency


@pytest.mark.parametrize("name", ["panda", "fanuc"])
def test_the_same_pairs_collide_in_the_same_samples(
    corpus: Path, tmp_path: Path, name: str
) -> None:
    """But for bodies within others: to Pinocchio, a convex mesh is a surface without an inside."""
    pin: Any = pytest.importorskip("pinocchio")
    package = corpus / "moveit_resources" / f"{name}_description"
    (tmp_path / f"moveit_resources_{name}_description").symlink_to(package)
    path = package / "urdf" / f"{name}.urdf"
    robot = read(path)
    arrays = tree_arrays(robot.tree)
    rows = arrays.samples(150, 5, 0)

    model = pin.buildModelFromUrdf(str(path))
    geometry = pin.buildGeomFromUrdf(
        model, str(path), pin.GeometryType.COLLISION, package_dirs=[str(tmp_path)]
    )
    links = [model.frames[one.parentFrame].name for one in geometry.geometryObjects]
    adjacency = Adjacency(robot.tree)
    pairs = [
        (a, b)
        for a, b in combinations(range(len(links)), 2)
        if not adjacency.is_adjacent(links[a], links[b])
    ]
    for pair in pairs:
        geometry.addCollisionPair(pin.CollisionPair(*pair))
    columns = {axis.joint: column for column, axis in enumerate(arrays.axes)}
    theirs: list[list[bool]] = []
    data, results = model.createData(), geometry.createData()
    for request in results.collisionRequests:
        request.security_margin = MARGIN
    for row in rows:
        at = np.zeros(model.nq)
        for joint in robot.model.joints:
            leader = joint.mimic.joint.value if joint.mimic and joint.mimic.joint else joint.name
            if leader in columns:
                at[model.joints[model.getJointId(joint.name)].idx_q] = row[columns[leader]]
        pin.computeCollisions(model, data, geometry, results, at, False)
        theirs.append([result.isCollision() for result in results.collisionResults])

    collision_model = CollisionModel(
        arrays, map(build_geometry, collision_arrays(robot.model, robot.meshes)[0])
    )
    number = {link: index for index, link in enumerate(arrays.links)}
    known = [(number[links[a]], number[links[b]]) for a, b in pairs]
    mine = [
        [bool(seen.hits) for seen in collision_model.query(known).at(row[None], count=True)]
        for row in rows
    ]
    assert np.sum(theirs) > 20
    contained = 0
    for row, one, other in zip(rows, mine, theirs, strict=True):
        for pair, hit, hit_by_surface in zip(known, one, other, strict=True):
            assert hit >= hit_by_surface
            if hit > hit_by_surface:
                assert is_inside(collision_model, pair, row)
                contained += 1
    assert bool(contained) is (name == "fanuc")


def is_inside(collision_model: CollisionModel, pair: tuple[int, int], row: Floats) -> bool:
    """True if one of two convex bodies is in the other, by the planes of its triangles."""
    bodies = [collision_model.bodies(link)[0] for link in pair]
    frames = collision_model.frames(row[None], pair)
    first, second = (
        (
            collision_model.geometry(body).arrays.vertices @ frames[body][0][:3, :3].T
            + frames[body][0][:3, 3],
            collision_model.geometry(body).arrays.faces,
        )
        for body in bodies
    )
    return any(
        all((_heights(outer, inner[0]) * _heights(outer, outer[0].mean(axis=0)[None]) > 0).flat)
        for outer, inner in ((first, second), (second, first))
    )


def _heights(body: tuple[Floats, Integers], points: Floats) -> Floats:
    """(m, n): on which side of each of m triangles n points are."""
    a, b, c = (body[0][body[1][:, corner]] for corner in range(3))
    normals = np.cross(b - a, c - a)
    return np.asarray(normals @ points.T - np.einsum("ij,ij->i", normals, a)[:, None])
