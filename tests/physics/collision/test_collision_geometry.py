"""Distances: closed forms, touching bodies, surfaces, and the traps of coal."""

from math import inf
from pathlib import Path

import pytest

np = pytest.importorskip("numpy")
pytest.importorskip("coal")

from tests.physics.collision.robots import box, cube, cylinder, link, mesh, robot, sphere
from urdfkit.mesh.geometry import Floats
from urdfkit.mesh.samples import stl
from urdfkit.physics.collision.bodies import TOUCH
from urdfkit.physics.collision.bounds import distance_bounds
from urdfkit.physics.collision.collision_geometry import (
    CollisionGeometry,
    DistanceQuery,
    build_geometries,
    build_geometry,
    volume,
)
from urdfkit.physics.collision.geometry_arrays import collision_arrays

SAME = np.eye(3)


def geometries(*shapes: str) -> list[CollisionGeometry]:
    context = robot(link("a", *shapes))
    return [build_geometry(one) for one in collision_arrays(context.model, context.meshes)[0]]


def distance(first: str, second: str, *at: float, limit: float = inf) -> float:
    return DistanceQuery(*geometries(first, second)).distance(SAME, np.array(at), limit)


@pytest.mark.parametrize("gap", [0.5, 1e-3, -1e-3, -0.05])
def test_closed_forms(gap: float) -> None:
    assert distance(sphere(0.1), sphere(0.2), 0.3 + gap, 0, 0) == pytest.approx(gap, abs=1e-6)
    assert distance(box(1, 1, 1), sphere(0.2), 0.7 + gap, 0, 0) == pytest.approx(gap, abs=1e-6)
    assert distance(box(1, 1, 1), box(1, 1, 1), 0, 1 + gap, 0.2) == pytest.approx(gap, abs=1e-6)
    parallel = distance(cylinder(0.1, 1), cylinder(0.2, 1), 0.3 + gap, 0, 0)
    assert parallel == pytest.approx(gap, abs=1e-5)


def test_a_cube_of_triangles_is_a_box(tmp_path: Path) -> None:
    cubes = mesh(cube(tmp_path / "c.stl", 0.5))
    for gap in (0.5, 1e-3, -1e-3, -0.05):
        assert distance(cubes, cubes, 1 + gap, 0.3, 0.2) == pytest.approx(gap, abs=1e-6)
        assert distance(cubes, box(1, 1, 1), 1 + gap, 0, 0) == pytest.approx(gap, abs=1e-6)


def test_bodies_of_one_mesh_share_its_surface(tmp_path: Path) -> None:
    """A hexapod of 49 meshes in 6 files took 1.3 GB."""
    shell = cube(tmp_path / "o.stl", 0.5, 5)
    context = robot(link("a", mesh(shell), mesh(shell), mesh(shell, "1 1 2"), box(1, 1, 1)))
    bodies, _ = collision_arrays(context.model, context.meshes)
    first, second, scaled, cuboid = build_geometries(bodies)
    assert second.exact is first.exact
    assert [one.arrays.number for one in (first, second, scaled, cuboid)] == [0, 1, 2, 3]
    assert scaled.exact is not first.exact
    assert scaled.half[2] == 2 * first.half[2]
    assert DistanceQuery(first, second).distance(SAME, np.array([1.5, 0, 0]), inf) == pytest.approx(
        0.5
    )


def test_surfaces_that_overlap_are_seen_and_touching_ones_are_not(tmp_path: Path) -> None:
    shell = mesh(cube(tmp_path / "o.stl", 0.5, 5))  # open, so no convex body
    for other in (shell, box(1, 1, 1)):
        assert distance(shell, other, -1.001, 0.3, 0.2) == pytest.approx(1e-3, abs=1e-6)
        assert abs(distance(shell, other, -1, 0.3, 0.2)) <= TOUCH
        assert distance(shell, other, -0.999, 0.3, 0.2) == pytest.approx(-1e-3, abs=1e-6)


def test_surfaces_are_no_deeper_than_their_hulls(tmp_path: Path) -> None:
    """coal reports 0.9 m, along a triangle; walkman's leg was 46 cm deep in another for 8 mm."""
    shell = mesh(cube(tmp_path / "o.stl", 0.5, 5), "10 1 1")
    assert distance(shell, shell, 9.9, 0.1, 0.3) == pytest.approx(-0.1, abs=1e-6)


def test_touching_bodies_do_not_collide_however_they_are_turned() -> None:
    gauge = DistanceQuery(*geometries(box(1, 1, 1), box(1, 1, 1)))
    random = np.random.default_rng(0)
    for _ in range(100):
        shift = np.array([1, *random.uniform(-0.9, 0.9, 2)])
        assert abs(gauge.distance(SAME, shift, inf)) < TOUCH


def test_a_body_within_a_surface_does_not_overlap_it(tmp_path: Path) -> None:
    shell = mesh(cube(tmp_path / "o.stl", 0.5, 5))
    assert distance(shell, mesh(cube(tmp_path / "i.stl", 0.1, 5)), 0, 0, 0) > 0


def test_a_limit_saves_work_and_keeps_what_is_below_it(tmp_path: Path) -> None:
    shell = mesh(cube(tmp_path / "o.stl", 0.5, 5))
    for gap in (0.01, 0.2):
        found = distance(shell, shell, 1 + gap, 0, 0, limit=0.1)
        assert found == pytest.approx(gap) if gap < 0.1 else found >= 0.1
    assert distance(shell, shell, -0.99, 0.3, 0.2, limit=-1.0) == pytest.approx(-0.01, abs=1e-6)


def test_the_hull_holds_the_mesh_and_never_replaces_it(tmp_path: Path) -> None:
    """Two open boxes, one's edge in the other's opening: the hulls overlap, the meshes do not."""
    shell = mesh(cube(tmp_path / "o.stl", 0.5, 5))
    (one, two) = geometries(shell, sphere(0.1))
    assert not one.is_convex
    at = np.array([0.0, 0, 0.45])
    assert DistanceQuery(one, two).distance(SAME, at, inf) > 0
    assert DistanceQuery(one, two).distance(SAME, at, 0.0) == 0  # measures nothing in vain


def test_vertices_within_the_hull_are_not_needed(tmp_path: Path) -> None:
    """A hand of Unitree: 23,000 vertices of a finger, each against the hull of the palm."""
    corners = np.array([(0, 0), (4, 0), (0, 4)])
    ends = [np.column_stack((corners, np.full(3, z))) for z in (0, 4)]
    inner = np.array([(1, 1, 1), (1.5, 1, 1), (1, 1.5, 1)])
    path = tmp_path / "prism.stl"
    path.write_bytes(stl([triangle.tolist() for triangle in (*ends, inner)]))
    (prism,) = geometries(mesh(path))
    assert {*map(tuple, prism.outermost)} == {*map(tuple, np.vstack(ends))}
    (flat,) = geometries(mesh(path, "1 1 0.000000001"))
    assert len(flat.outermost) == 9


def test_the_volume_of_a_cube(tmp_path: Path) -> None:
    (one,) = geometries(mesh(cube(tmp_path / "c.stl", 0.5)))
    assert volume(one.arrays.vertices, one.arrays.faces) == pytest.approx(1)


def rotations(count: int, seed: int) -> Floats:
    """Random rotations (n, 3, 3)."""
    matrices = np.linalg.qr(np.random.default_rng(seed).normal(size=(count, 3, 3)))[0]
    matrices[:, :, 0] *= np.linalg.det(matrices)[:, None]
    return matrices


def test_boxes_bound_the_distance_from_below_and_tell_parted_ones_apart() -> None:
    first, second = geometries(box(1, 0.4, 0.2), box(0.3, 0.3, 0.8))
    turns = rotations(400, 0)
    offsets = np.random.default_rng(1).normal(size=(400, 3)) * 0.6
    reach = first.radius + second.radius
    bound = distance_bounds(first.half, second.half, reach, turns, offsets, inf)
    gauge = DistanceQuery(first, second)
    true = np.array([gauge.distance(*pose, inf) for pose in zip(turns, offsets, strict=True)])
    assert (bound <= np.maximum(true, 0) + 1e-9).all()
    near = np.abs(true) > 1e-6
    assert ((bound > 0) <= (true > 0))[near].all()
    assert (bound[true > 1e-6] > 0).mean() == 1  # fifteen axes leave no doubt


def test_a_vertex_with_more_edges_than_coal_can_count(tmp_path: Path) -> None:
    turn = np.linspace(0, 2 * np.pi, 300, endpoint=False)
    rim = np.stack([0.1 * np.cos(turn), 0.1 * np.sin(turn), 0 * turn], axis=1)
    faces = [[rim[i], rim[i - 1], (0, 0, end)] for i in range(300) for end in (-0.1, 0.1)]
    (tmp_path / "spindle.stl").write_bytes(stl(faces))
    spindle = mesh(tmp_path / "spindle.stl")
    for gap in (0.3, 1e-3):
        assert distance(spindle, sphere(0.05), 0, 0, 0.15 + gap) == pytest.approx(gap, abs=1e-6)
        assert distance(spindle, sphere(0.05), 0.15 + gap, 0, 0) == pytest.approx(gap, abs=1e-4)
    assert distance(spindle, sphere(0.05), 0, 0, 0.14) < 0


def test_flanges_that_lie_on_one_another_need_no_triangles(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """cubemars: coal takes seconds for each pose of two discs that overlap by 15 micrometres."""
    shells = mesh(cube(tmp_path / "o.stl", 0.5, 5)), mesh(cube(tmp_path / "o.stl", 0.5, 5))
    query = DistanceQuery(*geometries(*shells))
    query.is_exact = False  # as of a flange with holes
    deep = np.array([0.3, 0.2, 0.9])
    assert query.distance(SAME, deep, 0.0) < -TOUCH
    monkeypatch.setattr(query, "_depth", None)
    assert query.distance(SAME, np.array([0, 0, 1 - 1.5e-5]), 0.0) == pytest.approx(
        -1.5e-5, abs=1e-6
    )
    with pytest.raises(TypeError):
        query.distance(SAME, deep, 0.0)


def test_meshes_that_are_apart_are_not_tested_for_a_collision(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A hand of 313,000 triangles: excluding a collision takes coal longer than the distance."""
    shells = mesh(cube(tmp_path / "o.stl", 0.5, 5)), mesh(cube(tmp_path / "i.stl", 0.1, 5))
    query = DistanceQuery(*geometries(*shells))
    monkeypatch.setattr(query, "_depth", None)
    assert query.distance(SAME, np.zeros(3), inf) == pytest.approx(0.4)
    assert query.distance(SAME, np.zeros(3), 0.1) == pytest.approx(0.1)
    assert query.distance(SAME, np.zeros(3), 0.0) == 0
