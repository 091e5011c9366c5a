"""Hulls and convex pieces, against trimesh."""

import re
import sys

import pytest

pytest.importorskip("numpy")
pytest.importorskip("trimesh")

import numpy as np
import trimesh

from tests.mesh.shapes_made import as_mesh, as_part, as_trimesh
from urdfkit.core.installation import install_command
from urdfkit.errors import MissingLibrary
from urdfkit.mesh.convex_decomposition import ENGINES, decompose
from urdfkit.mesh.convex_hull import NoHull, hull, with_few_corners
from urdfkit.mesh.geometry import Mesh, MeshPart
from urdfkit.mesh.health import examine

RING = trimesh.creation.annulus(0.5, 1.0, 0.5)


def test_the_hull_is_that_of_trimesh() -> None:
    found = as_trimesh(hull(as_mesh(RING)))
    assert found.is_convex
    assert found.is_volume
    assert found.volume == pytest.approx(RING.convex_hull.volume, rel=1e-6)


def test_all_parts_have_one_hull() -> None:
    boxes = [trimesh.creation.box().apply_translation((x, 0, 0)) for x in (0, 3)]
    found = hull(Mesh(tuple(map(as_part, boxes))))
    assert len(found.parts) == 1
    assert as_trimesh(found).volume == pytest.approx(4)


@pytest.mark.parametrize("make", [hull, decompose])
def test_what_is_flat_has_none(make: object) -> None:
    flat = MeshPart(np.eye(3), np.array([[0, 1, 2]]))
    with pytest.raises(NoHull, match="in a plane"):
        make(Mesh((flat,)))  # type: ignore[operator]


@pytest.mark.parametrize("engine", ENGINES)
def test_pieces_are_convex_and_nearly_the_mesh(engine: str) -> None:
    if engine == "coacd":
        pytest.importorskip("coacd")
    found = decompose(as_mesh(RING), most=8, engine=engine)
    assert 3 <= len(found.parts) <= 8
    pieces = [as_trimesh(Mesh((part,))) for part in found.parts]
    assert all(piece.is_volume and piece.is_convex for piece in pieces)
    assert all(len(piece.vertices) <= 64 for piece in pieces)
    together = trimesh.boolean.union(pieces, engine="manifold").volume
    assert RING.volume * 0.95 < together < 0.5 * (RING.volume + RING.convex_hull.volume)


def test_pieces_of_sheet_metal_are_solids() -> None:
    sheets = [trimesh.creation.box(edges) for edges in ((1, 1, 1e-5), (1e-5, 1, 1))]
    found = decompose(Mesh(tuple(map(as_part, sheets))), most=8)
    assert len(found.parts) > 1
    assert all(examine(part.vertices, part.faces).is_solid for part in found.parts)


def test_a_convex_mesh_is_one_piece() -> None:
    found = decompose(as_mesh(trimesh.creation.box()))
    assert as_trimesh(found).volume == pytest.approx(1, rel=0.05)
    assert len(found.parts) == 1


def test_a_missing_engine_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "coacd", None)
    with pytest.raises(MissingLibrary, match=re.escape(install_command("decompose"))):
        decompose(as_mesh(RING), engine="coacd")


@pytest.mark.parametrize("scale", [1e-4, 1.0, 1e3])
@pytest.mark.parametrize(
    "shape", [trimesh.creation.icosphere(4), trimesh.creation.cylinder(1, 3, sections=300)]
)
def test_a_hull_with_few_corners_is_around_all_and_close(
    shape: trimesh.Trimesh, scale: float
) -> None:
    shape = shape.copy().apply_scale(scale).apply_translation((scale, 0, 7 * scale))
    shell = hull(as_mesh(shape))
    lean = as_trimesh(with_few_corners(shell))
    assert len(shell.vertices) > 64
    assert len(lean.vertices) <= 64
    assert lean.is_volume
    beyond = (
        lean.face_normals @ (shape.vertices.T)
        - np.einsum("ij,ij->i", lean.face_normals, lean.triangles[:, 0])[:, None]
    )
    assert beyond.max() < 1e-6 * scale
    assert shape.volume < lean.volume < 1.2 * shape.volume


def test_a_hull_of_few_corners_stays_as_it_is() -> None:
    shell = hull(as_mesh(trimesh.creation.box((1, 2, 3))))
    assert with_few_corners(shell) is shell
