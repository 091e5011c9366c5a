"""Rays against closed forms: what a wall hides of the sky, and of the sun."""

from __future__ import annotations

import pytest

pytest.importorskip("PIL")
pytest.importorskip("numpy")
pytest.importorskip("embreex")

import numpy as np

from urdfkit.render.primitives import box
from urdfkit.render.rays import RayTracer


def wall() -> RayTracer:
    """A wall at x = 0 that is far larger than anything here."""
    shape = box(0.001, 200, 200)
    return RayTracer(shape.vertices, shape.faces, 1.0)


def floor_points(*distances: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Points beside the wall, their normals upwards, and pixels of one lattice square each."""
    x = np.repeat(np.array(distances, dtype=np.float32), 16)
    points = np.stack((x, 0 * x, 0 * x), axis=1)
    normals = np.tile(np.array((0, 0, 1), dtype=np.float32), (len(x), 1))
    return points, normals, np.arange(len(x)) % 16 // 4 * 64 + np.arange(len(x)) % 4


def test_a_wall_hides_half_of_the_sky() -> None:
    seen = wall().sky(*floor_points(0.01), 64, 50.0, 32)
    assert seen.mean() == pytest.approx(0.5, abs=0.02)


def test_what_is_out_of_reach_hides_nothing() -> None:
    assert wall().sky(*floor_points(2.0), 64, 1.0, 8) == pytest.approx(1)


@pytest.mark.parametrize(("side", "seen"), [(1, 1.0), (-1, 0.0)])
def test_the_sun_is_hidden_behind_the_wall(side: int, seen: float) -> None:
    sun = np.array((side, 0, 1), dtype=np.float32) / np.float32(np.sqrt(2))
    assert wall().sun(*floor_points(0.5), 64, sun, 8) == pytest.approx(seen)


def test_the_edge_of_a_shadow_is_half_lit() -> None:
    shape = box(2, 20, 0.001)  # a roof one metre above, from x = -1 to 1
    roof = RayTracer(shape.vertices + np.array((0, 0, 1), dtype=np.float32), shape.faces, 1.0)
    up = np.array((0, 0, 1), dtype=np.float32)
    inside, edge, outside = roof.sun(*floor_points(0.9, 1.0, 1.1), 64, up, 16).reshape(3, 16)
    assert inside == pytest.approx(0)
    assert outside == pytest.approx(1)
    assert edge.mean() == pytest.approx(0.5, abs=0.05)
