"""Distances between surfaces: closed forms, and trimesh's proximity queries."""

import pytest

pytest.importorskip("numpy")
pytest.importorskip("trimesh")

import numpy as np
import trimesh

from urdfkit.mesh import distance as module
from urdfkit.mesh.distance import directed_distance, distance


def apart(one: trimesh.Trimesh, other: trimesh.Trimesh) -> float:
    return distance(one.vertices, one.faces, other.vertices, other.faces)


def from_to(one: trimesh.Trimesh, other: trimesh.Trimesh) -> float:
    return directed_distance(one.vertices, one.faces, other.vertices, other.faces)


BALL = trimesh.creation.icosphere(4, 1.0)


@pytest.mark.usefixtures("rough_meshes")
@pytest.mark.parametrize(("scale", "away"), [(1e-6, 0.0), (1e-6, 0.1), (1e5, 0.0)])
def test_concentric_balls(scale: float, away: float) -> None:
    small, large = BALL.copy(), BALL.copy()
    small.apply_scale(scale).apply_translation((away, 0, 0))
    large.apply_scale(1.25 * scale).apply_translation((away, 0, 0))
    assert apart(small, large) == pytest.approx(0.25 * scale, rel=2e-3)


def test_a_surface_and_itself_cut_finer() -> None:
    box = trimesh.creation.box((1, 2, 3))
    assert apart(box, box.subdivide().subdivide()) == pytest.approx(0, abs=1e-12)
    assert apart(BALL, BALL) == pytest.approx(0, abs=1e-12)


def test_each_way_for_itself() -> None:
    """A box and the same with a spike: nothing of the box is far from the spiked one."""
    box = trimesh.creation.box((1, 1, 1))
    spike = trimesh.creation.cone(0.1, 0.5, sections=8).apply_translation((0, 0, 0.5))
    both = trimesh.util.concatenate([box, spike])
    assert isinstance(both, trimesh.Trimesh)
    assert from_to(box, both) == pytest.approx(0, abs=1e-12)
    assert from_to(both, box) == pytest.approx(0.5)


def test_points_within_faces_alone_may_count() -> None:
    corners = np.array([(1.0, 1, 0), (1, -1, 0), (-1, -1, 0), (-1, 1, 0)])
    faces = np.array([(0, 1, 2), (0, 2, 3)])

    def are_inner(points: np.ndarray) -> np.ndarray:
        return np.abs(points).max(axis=1) < 0.9

    assert directed_distance(
        corners, faces, np.add(corners, (0, 0, 3)), faces, are_inner
    ) == pytest.approx(3)


def test_points_far_and_near_against_trimesh() -> None:
    pytest.importorskip("rtree")
    random = np.random.default_rng(3)
    bumpy = trimesh.creation.icosphere(3, 1.0)
    bumpy.vertices *= random.uniform(0.7, 1.3, (len(bumpy.vertices), 1))
    long_ones = trimesh.creation.cylinder(0.5, 6, sections=30)
    points = random.normal(0, 2, (40, 3))
    for mesh in (bumpy, long_ones):
        expected = trimesh.proximity.closest_point(mesh, points)[1]
        triangles = np.asarray(mesh.triangles)
        found = [module._Surface(triangles).farthest(point[None]) for point in points]
        assert found == pytest.approx(expected, abs=1e-9)
        assert module._Surface(triangles).farthest(points) == pytest.approx(
            expected.max(), abs=1e-9
        )


def test_triangles_without_area() -> None:
    line = np.array([[[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[5, 5, 5]] * 3], dtype=float)
    assert module._Surface(line).farthest(np.array([[0.0, 3, 4]])) == pytest.approx(5)
    assert directed_distance(line.reshape(-1, 3), np.arange(6).reshape(2, 3), *cube()) < 10


def cube() -> tuple[np.ndarray, np.ndarray]:
    box = trimesh.creation.box((1, 1, 1))
    return np.asarray(box.vertices), np.asarray(box.faces)


def test_a_dense_mesh() -> None:
    dense = trimesh.creation.icosphere(6, 1.0)  # 82 000 triangles
    box = trimesh.creation.box((2, 2, 2))
    assert from_to(box, dense) == pytest.approx(3**0.5 - 1, rel=1e-3)


@pytest.mark.parametrize(("subdivisions", "part"), [(5, 1e-3), (6, 3e-4)])
def test_a_dent_in_a_thousandth_of_a_ball(subdivisions: int, part: float) -> None:
    """A cap of that part of the surface of a ball becomes a hollow cone."""
    ball = trimesh.creation.icosphere(subdivisions, 1.0)
    axis = np.array([2.0, -1, 3]) / 14**0.5
    rim = np.arccos(1 - 2 * part)
    away = np.arccos(np.clip(ball.vertices @ axis, -1, 1))
    deep = 0.3 * np.clip(rim - away, 0, None)
    dented = ball.copy()
    dented.vertices *= 1 - deep[:, None]
    assert 0.7 * deep.max() < from_to(ball, dented) <= deep.max()
    assert 0.7 * deep.max() < from_to(dented, ball) <= deep.max()
