"""What is counted in a mesh, against trimesh and by hand."""

import pytest

pytest.importorskip("numpy")
pytest.importorskip("trimesh")

import numpy as np
import trimesh

from tests.mesh.defects import shapes
from tests.mesh.shapes_made import as_part
from urdfkit.mesh.components import contains, split_pieces
from urdfkit.mesh.edges import Edges
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.health import Health, _examine, examine, examine_mesh
from urdfkit.mesh.welding import weld


@pytest.mark.parametrize("name", shapes())
def test_solids_as_trimesh_sees_them(name: str) -> None:
    shape = shapes()[name]
    health = examine(shape.vertices, shape.faces)
    assert health.is_solid
    assert health.defects == 0
    assert health.volume == pytest.approx(shape.volume)
    assert health.bodies == shape.body_count


def test_every_defect_is_counted() -> None:
    box = trimesh.creation.box()
    points, faces = np.array(box.vertices), np.array(box.faces)
    assert examine(points, faces[1:]).open_edges == 3
    assert examine(points, faces[:, ::-1]).inverted == 1
    turned = faces.copy()
    turned[0] = turned[0][::-1]
    assert examine(points, turned).inconsistent_edges == 3
    assert examine(points, np.vstack([faces, faces[:2]])).repeated == 2
    assert examine(points, np.vstack([faces, faces[:1]])).non_manifold_edges == 3
    assert examine(points, np.vstack([faces, [[0, 0, 1]]])).collapsed == 1
    bad = np.vstack([points, [[np.nan, 0, 0]]])
    assert examine(bad, np.vstack([faces, [[0, 1, 8]]])).non_finite == 1
    assert examine(points, faces[:0]).defects == 0
    assert not examine(points, faces[:0]).is_closed


def test_touching_parts_are_solids_of_their_own_and_colours_are_not() -> None:
    box = trimesh.creation.box()
    other = box.copy().apply_translation((1, 0, 0))
    assembly = Mesh((as_part(box), as_part(other)))
    assert Edges(weld(assembly.vertices, assembly.faces)[1]).is_non_manifold.sum() == 4
    assert examine(assembly.vertices, assembly.faces).is_solid
    assert examine_mesh(assembly).is_solid
    assert examine_mesh(assembly).volume == pytest.approx(2)
    halves = [
        as_part(box)._replace(faces=np.array(faces)) for faces in (box.faces[:5], box.faces[5:])
    ]
    assert examine_mesh(Mesh(tuple(halves))).is_solid


def test_edges() -> None:
    edges = Edges(np.array([[0, 1, 2], [2, 1, 3], [4, 5, 6]]))
    assert edges.count[edges.of_face[0]].tolist() == [1, 2, 1]
    assert edges.pairs.tolist() == [[0, 1]]
    assert edges.bodies.tolist() == [0, 0, 1]
    assert not edges.is_inconsistent.any()


def test_a_point_is_inside_or_outside() -> None:
    pytest.importorskip("rtree", reason="trimesh needs it to tell what is inside")
    ball = trimesh.creation.torus(1.0, 0.3)
    points, faces = np.array(ball.vertices), np.array(ball.faces)
    rng = np.random.default_rng(1)
    for point in rng.uniform(-1.4, 1.4, (60, 3)) * (1, 1, 0.25):
        assert contains(points, faces, point) == bool(ball.contains([point])[0])


def test_welding_and_volumes() -> None:
    box = trimesh.creation.box((1, 2, 3))
    loose = box.vertices[box.faces].reshape(-1, 3)
    points, faces = weld(loose, np.arange(36).reshape(-1, 3))
    assert len(points) == 8
    assert split_pieces(points, Edges(faces)).volumes == pytest.approx([6])


def test_parts_are_examined_separately() -> None:
    """A cavity in one part, and a part that faces inwards inside of another."""
    box, cavity = trimesh.creation.box((3, 3, 3)), trimesh.creation.box()
    cavity.invert()
    gap = trimesh.creation.box((5, 5, 5))
    gap.update_faces(np.arange(11))
    both = trimesh.util.concatenate([box, cavity])
    assert isinstance(both, trimesh.Trimesh)
    hollow = as_part(both)
    for parts, inverted in (((hollow, as_part(gap)), 0), ((as_part(cavity), as_part(gap)), 1)):
        separate = [examine(part.vertices, part.faces) for part in parts]
        assert [health.inverted for health in separate] == [inverted, 0]
        assert _examine([(part.vertices, part.faces) for part in parts]) == Health(
            *(sum(values) for values in zip(*separate, strict=True))
        )
