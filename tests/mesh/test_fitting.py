"""Simple shapes around meshes: primitives are found again, errors are what they say."""

import pytest

pytest.importorskip("numpy")
pytest.importorskip("trimesh")

import numpy as np
import trimesh

from tests.mesh.shapes_made import as_mesh, as_part, as_trimesh
from urdfkit.core.spatial import Transform, from_rpy, rotate
from urdfkit.mesh import solids
from urdfkit.mesh.distance import directed_distance
from urdfkit.mesh.fitting import fit
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.solids import subtract_mesh
from urdfkit.mesh.transforms import moved

TURNED = Transform(from_rpy(0.4, -0.7, 1.1), (0.1, -0.2, 0.3))


def test_a_box_is_found_wherever_it_lies() -> None:
    mesh = moved(as_mesh(trimesh.creation.box((0.3, 0.2, 0.1))), TURNED)
    best = fit(mesh, 0.001).best
    assert best.kind == "box"
    assert sorted(best.size) == pytest.approx([0.1, 0.2, 0.3], rel=1e-4)
    assert best.frame.position == pytest.approx((0.1, -0.2, 0.3), abs=1e-6)
    assert best.error == pytest.approx(0, abs=1e-6)


def test_a_box_along_the_axes_is_not_turned() -> None:
    best = fit(as_mesh(trimesh.creation.box((0.3, 0.2, 0.1))), 0.001).best
    assert best.size == pytest.approx((0.3, 0.2, 0.1))
    assert best.frame.rotation == ((1, 0, 0), (0, 1, 0), (0, 0, 1))


def test_a_cylinder() -> None:
    mesh = as_mesh(trimesh.creation.cylinder(0.1, 0.5, sections=64))
    best = fit(mesh, 0.002).best
    assert best.kind == "cylinder"
    assert best.size[:2] == pytest.approx((0.1, 0.5), rel=1e-3)
    lying = moved(mesh, Transform(from_rpy(np.pi / 2, 0, 0)))
    axis = rotate(fit(lying, 0.002).best.frame.rotation, (0.0, 0.0, 1.0))
    assert np.abs(axis) == pytest.approx([0, 1, 0], abs=1e-3)


def test_a_ball() -> None:
    best = fit(as_mesh(trimesh.creation.icosphere(3, 0.2)), 0.005).best
    assert best.kind == "sphere"
    assert best.size[0] == pytest.approx(0.2, rel=1e-2)


def test_what_is_convex_and_no_primitive_gets_its_hull() -> None:
    cone = trimesh.creation.cone(0.2, 0.5)
    found = fit(as_mesh(cone), 0.005)
    assert found.within
    assert found.best.kind == "hull"
    assert [one.kind for one in found.tried] == ["box", "cylinder", "sphere", "hull"]
    assert as_trimesh(found.best.mesh).volume == pytest.approx(cone.volume, rel=1e-3)


def test_what_lies_inside_does_not_stick_out() -> None:
    """Pieces leave gaps where they meet; their faces there are deep in the mesh."""
    block = as_mesh(trimesh.creation.box((1, 1, 1)))
    halves = Mesh(
        tuple(
            as_part(trimesh.creation.box((0.49, 1, 1)).apply_translation((x, 0, 0)))
            for x in (-0.255, 0.255)
        )
    )
    outside = subtract_mesh(halves, block)
    assert len(outside.faces) == 0
    halves = halves._replace(
        parts=tuple(p._replace(vertices=p.vertices * 1.1) for p in halves.parts)
    )
    outside = subtract_mesh(halves, block)
    assert directed_distance(
        outside.vertices, outside.faces, block.vertices, block.faces
    ) == pytest.approx(0.05 * 3**0.5)


def test_what_is_not_convex_is_cut_into_no_more_pieces_than_it_takes() -> None:
    parts = [trimesh.creation.box((1, 0.2, 0.2)), trimesh.creation.box((0.2, 0.2, 1))]
    parts[1].apply_translation((-0.4, 0, 0.4))
    bracket = trimesh.boolean.union(parts, engine="manifold")
    found = fit(as_mesh(bracket), 0.06, most=8)
    assert found.best.kind == "pieces"
    assert found.within
    assert len(found.best.mesh.parts) == 2


def test_of_what_is_beyond_the_bound_the_simplest_is_taken_that_is_hardly_worse() -> None:
    dented = solids.box((1, 1, 1)) - solids.ball(0.3).translate((0, 0, 0.5))
    for away, kind in ((0.31, "box"), (0.45, "hull")):  # of the corner that is cut off below
        cut = dented.trim_by_plane((1, 1, 1), away - 3**0.5 / 2)
        found = fit(solids.as_mesh(cut), 1e-9, most=1)
        assert not found.within
        assert found.best.kind == kind
        errors = {one.kind: one.error for one in found.tried}
        assert errors["box"] == pytest.approx(away, rel=0.01)
        assert 0.25 < errors["hull"] < 0.3


def test_shapes_contain_the_mesh() -> None:
    rng = np.random.default_rng(4)
    cloud = trimesh.convex.convex_hull(rng.normal(size=(40, 3)) * (1, 0.5, 0.2))
    for one in fit(as_mesh(cloud), 1e-9, most=1).tried:
        x, y, z = one.size
        inverse = np.array(one.frame.rotation).T
        points = (cloud.vertices - one.frame.position) @ inverse.T
        if one.kind == "box":
            assert (np.abs(points) <= np.array([x, y, z]) / 2 + 1e-6).all()
        elif one.kind == "cylinder":
            assert np.hypot(points[:, 0], points[:, 1]).max() <= x + 1e-6
            assert np.abs(points[:, 2]).max() <= y / 2 + 1e-6
        elif one.kind == "sphere":
            assert np.linalg.norm(points, axis=1).max() <= x + 1e-6
