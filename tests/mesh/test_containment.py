"""Convex pieces contain the mesh: its surface, sampled, against their half-spaces."""

import pytest

pytest.importorskip("numpy")
pytest.importorskip("trimesh")

import numpy as np
import trimesh
from scipy.spatial import ConvexHull

from tests.mesh.shapes_made import as_mesh
from urdfkit.mesh.containment import _halved, grow_pieces, missing, protrusion
from urdfkit.mesh.convex_decomposition import decompose
from urdfkit.mesh.convex_hull import hull
from urdfkit.mesh.fitting import fit
from urdfkit.mesh.geometry import Floats, Mesh, MeshPart

TORUS = trimesh.creation.torus(0.1, 0.03, 24, 12)
#: Half of it, without its ends: no engine knows what is inside of an open surface.
GUTTER = TORUS.submesh([np.flatnonzero(TORUS.triangles_center[:, 2] > 0)], append=True)
BRACKET = trimesh.util.concatenate(
    [
        trimesh.creation.box((0.2, 0.1, 0.004)).apply_translation((0.1, 0, 0)),
        trimesh.creation.box((0.004, 0.1, 0.2)).apply_translation((0, 0, 0.1)),
    ]
)


def outside(pieces: Mesh, shape: trimesh.Trimesh) -> float:
    """How far the farthest of many points of a surface is beyond the nearest piece's faces."""
    points = np.concatenate([trimesh.sample.sample_surface(shape, 5000, seed=1)[0], shape.vertices])
    hulls = [ConvexHull(part.vertices).equations for part in pieces.parts]
    beyond = [(points @ planes[:, :3].T + planes[:, 3]).max(axis=1) for planes in hulls]
    return float(np.min(beyond, axis=0).max())


@pytest.mark.parametrize(
    ("shape", "scale"),
    [(TORUS, 1.0), (GUTTER, 1.0), (BRACKET, 1000.0)],
    ids=["torus", "gutter", "bracket"],
)
def test_pieces_contain_the_mesh(shape: trimesh.Trimesh, scale: float) -> None:
    shape = shape.copy().apply_scale(scale).apply_translation((5 * scale, 0, 0))
    found = decompose(as_mesh(shape), most=6)
    assert 1 < len(found.parts) <= 6
    assert outside(found, shape) < 1e-6 * scale  # manifold3d's hulls are a little rounded
    assert missing(found, as_mesh(shape)) < 1e-6 * scale
    whole = hull(as_mesh(shape))
    assert protrusion(found, as_mesh(shape)) < protrusion(whole, as_mesh(shape))


@pytest.mark.parametrize("seed", range(3))
def test_pieces_grow_around_any_surface(seed: int) -> None:
    random = np.random.default_rng(seed)
    shape = trimesh.Trimesh(random.random((30, 3)), random.integers(0, 30, (40, 3)))
    pieces = [0.2 * random.random((8, 3)) + random.random(3) for _ in range(3)]
    found = grow_pieces(pieces, np.asarray(shape.vertices), np.asarray(shape.faces, dtype=np.int64))
    parts = tuple(MeshPart(corners, np.arange(len(corners)).reshape(1, -1)) for corners in found)
    assert outside(Mesh(parts), shape) < 1e-8
    for before, after in zip(pieces, found, strict=True):
        planes = ConvexHull(after).equations
        assert (before @ planes[:, :3].T + planes[:, 3]).max() < 1e-12


def test_pieces_that_contain_it_do_not_grow() -> None:
    """Nor do they where a triangle lies in two of them, and in neither whole."""
    halves: list[Floats] = [
        np.asarray(trimesh.creation.box((1, 1, 1)).apply_translation((x, 0, 0)).vertices)
        for x in (-0.5, 0.5)
    ]
    shape = trimesh.creation.box((2, 1, 1))
    found = grow_pieces(halves, np.asarray(shape.vertices), np.asarray(shape.faces, dtype=np.int64))
    for before, after in zip(halves, found, strict=True):
        assert ConvexHull(after).volume == pytest.approx(ConvexHull(before).volume, rel=0.02)


def test_a_sliver_in_two_pieces_is_cut_where_they_meet() -> None:
    """As long as the longest edge is; its shortest one is below what is cut."""
    halves: list[Floats] = [
        np.asarray(trimesh.creation.box((1, 1, 1)).apply_translation((x, 0, 0)).vertices)
        for x in (-0.5, 0.5)
    ]
    sliver = np.array([(-0.9, 0, 0), (0.9, 0, 0), (0.9, 0.01, 0)])
    for before, after in zip(
        halves, grow_pieces(halves, sliver, np.array([(0, 1, 2)])), strict=True
    ):
        assert ConvexHull(after).volume == pytest.approx(ConvexHull(before).volume, rel=0.02)


def test_each_triangle_is_cut_into_four() -> None:
    triangles = np.array([[(0, 0, 0), (4, 0, 0), (0, 4, 0)], [(9, 0, 1), (9, 8, 1), (5, 0, 1)]])
    points, faces = _halved(triangles.astype(np.float64))
    areas = trimesh.triangles.area(points[faces])
    assert sorted(areas) == pytest.approx([2.0] * 4 + [4.0] * 4)
    assert len(points) == 12


def test_both_distances_are_reported() -> None:
    large, small = (as_mesh(trimesh.creation.box(size)) for size in ((2, 2, 3), (1.6, 1.6, 2.6)))
    assert protrusion(large, small) == pytest.approx(0.2 * 3**0.5)
    assert missing(large, small) == 0
    assert missing(small, large) == pytest.approx(0.2 * 3**0.5)


def test_a_convex_mesh_is_its_hull() -> None:
    shape = trimesh.creation.capsule(0.3, 0.05)
    found = decompose(as_mesh(shape), most=8)
    assert len(found.parts) == 1
    assert protrusion(found, as_mesh(shape)) < 1e-9


@pytest.mark.parametrize("shape", [TORUS, GUTTER, BRACKET], ids=["torus", "gutter", "bracket"])
def test_primitives_contain_the_mesh(shape: trimesh.Trimesh) -> None:
    for one in fit(as_mesh(shape), 1.0).tried:
        rotation, position = np.array(one.frame.rotation), np.array(one.frame.position)
        points = np.abs((shape.vertices - position) @ rotation)
        if one.kind == "box":
            assert (points <= np.array(one.size) / 2 + 1e-9).all()
        else:
            across = points if one.kind == "sphere" else points[:, :2]
            assert np.linalg.norm(across, axis=1).max() <= one.size[0] + 1e-9
        if one.kind == "cylinder":
            assert points[:, 2].max() <= one.size[1] / 2 + 1e-9
