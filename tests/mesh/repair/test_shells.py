"""Sheets with two sides, and shells that overlap or are nested: reported, repaired on request."""

import pytest

pytest.importorskip("numpy")
pytest.importorskip("trimesh")

import numpy as np
import trimesh

from tests.mesh.shapes_made import as_mesh, as_part, as_trimesh
from urdfkit.mesh.geometry import Mesh, MeshMaterial
from urdfkit.mesh.health import examine_mesh
from urdfkit.mesh.repair import repair


def box(edge: float, x: float = 0.0, *, inwards: bool = False) -> trimesh.Trimesh:
    shape = trimesh.creation.box((edge, edge, edge)).apply_translation((x, 0, 0))
    if inwards:
        shape.invert()
    return shape


def mesh_of(*shapes: trimesh.Trimesh) -> Mesh:
    whole = trimesh.util.concatenate(shapes)
    assert isinstance(whole, trimesh.Trimesh)
    return as_mesh(whole)


def two_sided(shape: trimesh.Trimesh) -> Mesh:
    faces = np.concatenate([shape.faces, shape.faces[:, ::-1]])
    return as_mesh(trimesh.Trimesh(shape.vertices, faces, process=False))


OPEN = trimesh.Trimesh(box(1).vertices, box(1).faces[2:], process=False)
BALL = trimesh.creation.icosphere(2)

#: Boxes that overlap, nested ones, a cavity, and a body in a cavity: all with the true volume.
SHELLS = {
    "apart": (mesh_of(box(1), box(1, 2)), 2.0, True),
    "touching": (mesh_of(box(1), box(1, 1)), 2.0, True),
    "overlapping": (mesh_of(box(1), box(1, 0.5)), 1.5, False),
    "nested": (mesh_of(box(1), box(0.8)), 1.0, False),
    "cavity": (mesh_of(box(1), box(0.8, inwards=True)), 1 - 0.8**3, True),
    "in a cavity": (
        mesh_of(box(1), box(0.8, inwards=True), box(0.5)),
        1 - 0.8**3 + 0.5**3,
        True,
    ),
    "twice in a cavity": (
        mesh_of(box(1), box(0.8, inwards=True), box(0.5), box(0.5, 0.1)),
        1 - 0.8**3 + 0.5**3 + 0.1 * 0.5**2,
        False,
    ),
}


@pytest.mark.parametrize("name", SHELLS)
def test_what_counts_twice_is_no_solid_until_it_is_united(name: str) -> None:
    mesh, volume, is_solid = SHELLS[name]
    health = examine_mesh(mesh)
    assert health.is_solid == is_solid
    assert health.volume == pytest.approx(volume * (1 + health.overlap))
    plain = repair(mesh)
    assert not plain.changed
    assert plain.mesh is mesh
    done = repair(mesh, union=True)
    assert done.changed != is_solid
    assert done.after.is_solid
    assert done.after.volume == pytest.approx(volume)
    assert as_trimesh(done.mesh).is_volume or not done.changed  # bodies may touch


def test_united_bodies_keep_their_materials() -> None:
    red, blue = MeshMaterial("red", (1, 0, 0, 1)), MeshMaterial("blue", (0, 0, 1, 1))
    done = repair(Mesh((as_part(box(1), red), as_part(box(1, 0.5), blue))), union=True)
    colours = {part.material: part.vertices[:, 0] for part in done.mesh.parts}
    assert colours[red].min() == pytest.approx(-0.5)
    assert colours[blue].max() == pytest.approx(1.0)
    assert done.after.volume == pytest.approx(1.5)


def test_what_is_open_stays_beside_what_is_united() -> None:
    corners = [[0, 0, 3], [1, 0, 3], [0, 1, 3], [1, 1, 3]]
    sheet = trimesh.Trimesh(corners, [[0, 1, 2], [1, 3, 2]]).subdivide()
    done = repair(mesh_of(box(1), box(1, 0.5), sheet), holes=False, union=True)
    assert as_trimesh(done.mesh).bounds[1][2] == 3
    assert done.after.open_edges == 8


@pytest.mark.parametrize("shape", [OPEN, BALL], ids=["open", "closed"])
def test_two_sides_are_one_only_when_asked(shape: trimesh.Trimesh) -> None:
    mesh = two_sided(shape)
    health = examine_mesh(mesh)
    assert not health.is_solid
    assert health.doubled == len(mesh.faces)
    assert not repair(mesh).changed
    done = repair(mesh, one_sided=True)
    assert done.changed
    assert done.after.is_solid  # the hole of the box is closed
    assert done.after.volume == pytest.approx(1.0 if shape is OPEN else shape.volume)
    kept = repair(two_sided(OPEN), one_sided=True, holes=False)
    assert kept.changed
    assert kept.after.open_edges == 4


def test_a_wall_between_two_bodies_is_no_sheet() -> None:
    assert examine_mesh(mesh_of(box(1), box(1, 1))).doubled == 0
