"""Spheres that cover solids: closed forms, and what holds for all."""

from functools import cache

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

pytest.importorskip("trimesh", reason="meshes need the extra meshes")

from urdfkit.mesh import solids
from urdfkit.mesh.cover_quality import measure, total
from urdfkit.mesh.geometry import Floats, Mesh, MeshPart
from urdfkit.mesh.inside import are_inside, closed, points_inside
from urdfkit.mesh.sphere_fitting import Covering, Spheres, fit


def triangles(mesh: Mesh) -> Floats:
    return mesh.vertices[mesh.faces]


BALL = triangles(solids.as_mesh(solids.ball(0.1)))
ROD = triangles(solids.as_mesh(solids.box((0.04, 0.04, 0.4))))


@cache
def of_rod() -> Covering:
    return Covering(ROD, 0.99)


def spheres_of(covering: Covering, *, margin: float = 0.01, most: int = 100) -> Spheres:
    return fit([covering], margin, most)[0]


def test_a_ball_is_one_sphere() -> None:
    moved = np.add(BALL, (0.3, 0, 0))
    spheres = spheres_of(Covering(moved, 0.99))
    quality = measure(moved, spheres)
    assert spheres.centers == pytest.approx(np.array([[0.3, 0, 0]]), abs=0.002)
    assert spheres.radii == pytest.approx([0.1], abs=0.002)
    assert quality.volume == pytest.approx(4 / 3 * np.pi * 0.1**3, rel=0.02)
    assert quality.area == pytest.approx(4 * np.pi * 0.1**2, rel=0.01)
    assert quality.coverage > 0.98


def test_a_small_cube_is_one_sphere_through_its_corners_at_most() -> None:
    """It sticks out by (sqrt(3) - 1) / 2 of an edge, here 7.3 mm, or less for 99 % of the cube."""
    cube = triangles(solids.as_mesh(solids.box((0.02, 0.02, 0.02))))
    spheres = spheres_of(Covering(cube, 0.99))
    quality = measure(cube, spheres)
    assert len(spheres.radii) == 1
    assert 0.01 < spheres.radii[0] < 0.01 * np.sqrt(3)
    assert quality.protrusion_max < 0.0074


def test_a_rod_is_a_row_of_spheres() -> None:
    """A sphere that sticks out by 10 mm covers no more than 20 mm to both sides of its center."""
    spheres = spheres_of(of_rod())
    quality = measure(ROD, spheres)
    reach = np.sqrt(0.03**2 - 0.02**2)  # where it leaves the faces of the rod
    assert 0.4 / (2 * reach) - 1 <= len(spheres.radii) <= 0.4 / 0.02
    assert np.abs(spheres.centers[:, :2]).max() < 0.02
    assert quality.protrusion_max < 0.0115
    assert quality.coverage > 0.98


def test_fewer_spheres_stick_out_by_more() -> None:
    few, many = (measure(ROD, spheres_of(of_rod(), most=most)) for most in (4, 100))
    assert few.number <= 4 < many.number
    assert few.protrusion_p95 > many.protrusion_p95


def test_a_budget_is_used_as_well_as_an_even_row() -> None:
    """Nine spheres in a row that cover the rod to its edges stick out by 16 mm."""
    quality = measure(ROD, spheres_of(of_rod(), margin=0.001, most=9))
    even = np.sqrt(2 * 0.02**2 + (0.4 / 18) ** 2) - 0.02
    assert quality.number == 9
    assert quality.protrusion_max < even
    assert quality.coverage > 0.985


@pytest.mark.usefixtures("rough_meshes")
def test_the_budget_is_shared_and_each_solid_has_a_sphere() -> None:
    coverings = [Covering(surface, 0.99) for surface in (BALL, ROD, ROD)]
    counts = [len(one.radii) for one in fit(coverings, 0.001, 9)]
    assert counts[0] == 1
    assert sum(counts) == 9
    assert [len(one.radii) for one in fit(coverings, 0.001, 1)] == [1, 1, 1]


def test_the_same_every_time() -> None:
    first, second = spheres_of(of_rod()), spheres_of(Covering(ROD, 0.99))
    assert np.array_equal(first.centers, second.centers)
    assert np.array_equal(first.radii, second.radii)


def test_a_measure_of_known_spheres() -> None:
    """One sphere of half the radius: an eighth of the ball; one of twice the radius sticks out."""
    small = measure(BALL, Spheres(np.zeros((1, 3)), np.array([0.05])))
    assert small.coverage == pytest.approx(1 / 8, abs=0.01)
    assert (small.surface_coverage, small.protrusion_max) == (0, 0)
    assert small.max_uncovered_gap == pytest.approx(0.05, abs=0.001)
    large = measure(BALL, Spheres(np.zeros((1, 3)), np.array([0.2])))
    assert (large.coverage, large.surface_coverage, large.max_uncovered_gap) == (1, 1, 0)
    assert large.protrusion_mean == pytest.approx(0.1, abs=0.001)
    both = total([small, large])
    assert both.number == 2
    assert both.coverage == pytest.approx((small.coverage + 1) / 2)


def test_inside_of_overlapping_solids() -> None:
    both = np.concatenate([BALL, np.add(BALL, (0.1, 0, 0))])
    points = np.array([[0, 0, 0], [0.05, 0.01, 0.01], [0.15, 0, 0.02], [0.25, 0, 0]])
    assert are_inside(both, points + 0.0013).tolist() == [True, True, True, False]
    _, volume = points_inside(both, 2000, 1)
    ball = 4 / 3 * np.pi * 0.1**3
    assert volume == pytest.approx(2 * ball - np.pi * (4 * 0.1 + 0.1) * 0.1**2 / 12, rel=0.02)


def test_an_open_mesh_becomes_its_hull() -> None:
    box = solids.as_mesh(solids.box((1, 1, 1)))
    part = box.parts[0]
    open_box = Mesh((MeshPart(part.vertices, part.faces[2:]),))
    assert closed(box) is box
    assert len(closed(open_box).faces) == 12


@settings(max_examples=settings().max_examples // 25)  # seconds each
@given(
    st.tuples(*[st.floats(0.01, 0.5)] * 3),
    st.floats(0.005, 0.05),
    st.sampled_from([3, 20, 100]),
)
@example((0.5, 0.5, 0.01), 0.05, 20)
@example((0.01, 0.3, 0.5), 0.02, 100)
def test_boxes_are_covered_as_stated(
    size: tuple[float, float, float], margin: float, most: int
) -> None:
    surface = triangles(solids.as_mesh(solids.box(size)))
    spheres = spheres_of(Covering(surface, 0.99), margin=margin, most=most)
    quality = measure(surface, spheres)
    assert 1 <= len(spheres.radii) <= most
    assert quality.coverage > 0.95
    assert (spheres.radii > 0).all()
    low, high = surface.min(axis=(0, 1)), surface.max(axis=(0, 1))
    assert ((spheres.centers > low - 1e-9) & (spheres.centers < high + 1e-9)).all()


def test_points_are_inside_of_one_of_two_solids_that_overlap() -> None:
    moved = ROD + np.array((0.01, 0.02, 0.1))
    points = np.random.default_rng(0).uniform((-0.04, -0.04, -0.3), (0.04, 0.05, 0.4), (2000, 3))
    half = np.array((0.02, 0.02, 0.2))
    expected = [
        (np.abs(points - place) < half).all(axis=1) for place in ((0, 0, 0), (0.01, 0.02, 0.1))
    ]
    found = are_inside(np.concatenate([ROD, moved]), points)
    assert (found == (expected[0] | expected[1])).all()
    assert are_inside(ROD, np.empty((0, 3))).shape == (0,)
