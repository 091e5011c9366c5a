"""Coarse surfaces for the 3D view: few triangles, in the place of the many."""

import pytest

np = pytest.importorskip("numpy")
pytest.importorskip("PIL")

from urdfkit.render.coarse import CELLS, coarsened
from urdfkit.render.scene import SceneItem
from urdfkit.ros.surface_materials import PLAIN


def ball(radius: float, rings: int) -> SceneItem:
    """A sphere of 4 rings^2 triangles, as one finds it in an STL: no corner is shared."""
    polar, around = np.meshgrid(
        np.linspace(0, np.pi, rings + 1), np.linspace(0, 2 * np.pi, 2 * rings + 1), indexing="ij"
    )
    points = np.stack(
        (np.sin(polar) * np.cos(around), np.sin(polar) * np.sin(around), np.cos(polar)), axis=-1
    )
    a, b, c, d = points[:-1, :-1], points[1:, :-1], points[1:, 1:], points[:-1, 1:]
    corners = np.concatenate((np.stack((a, b, c), 2), np.stack((a, c, d), 2))).reshape(-1, 3)
    faces = np.arange(len(corners), dtype=np.int32).reshape(-1, 3)
    return SceneItem("a", "visual", "ball", PLAIN, (radius * corners).astype(np.float32), faces)


def test_few_triangles_are_left_where_many_were() -> None:
    many = ball(0.5, 200)
    (few,) = coarsened([many], 20_000)
    assert len(many.faces) == 160_000
    assert 2_000 < len(few.faces) <= 20_000
    away = np.abs(np.linalg.norm(few.vertices, axis=1) - 0.5)
    assert away.max() < 1e-5  # vertices are some of the old ones
    assert np.abs(few.vertices).max() == pytest.approx(0.5, abs=1 / 32)
    a, b, c = (few.vertices[few.faces[:, corner]] for corner in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2
    assert area == pytest.approx(np.pi, rel=0.05)  # of the sphere


def test_small_surfaces_and_small_robots_stay_as_they_are() -> None:
    small, large = ball(0.1, 16), ball(0.5, 100)
    assert coarsened([small, large], 1_000_000) == [small, large]
    kept, coarse = coarsened([small, large], 10_000)
    assert kept is small
    assert len(coarse.faces) < len(large.faces)


def test_what_cannot_be_coarse_enough_ends() -> None:
    found = coarsened([ball(0.5, 100), ball(0.1, 100)], 1)
    assert all(len(item.faces) <= 6 * CELLS[-1] ** 2 * 2 for item in found)
