"""Capsules that cover solids: closed forms, and coal as the oracle of distances."""

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

trimesh = pytest.importorskip("trimesh", reason="meshes need the extra meshes")

from urdfkit.mesh import solids
from urdfkit.mesh.capsule_fitting import Capsules, _radius_by_ends, fit
from urdfkit.mesh.cover_quality import measure
from urdfkit.mesh.geometry import Floats

ROD = solids.as_mesh(solids.box((0.04, 0.04, 0.4)))
#: Two rods at right angles: one capsule around both is far from either.
CORNER = np.concatenate(
    [ROD.vertices[ROD.faces], np.add(ROD.vertices[ROD.faces][:, :, [2, 0, 1]], (0.18, 0, 0.18))]
)


def covered(triangles: Floats, *, margin: float = 0.02, most: int = 9) -> Capsules:
    return fit([triangles], coverage=0.99, margin=margin, most=most)[0]


def lengths(capsules: Capsules) -> Floats:
    return np.linalg.norm(capsules.segments[:, 1] - capsules.segments[:, 0], axis=1)


def test_a_capsule_is_itself() -> None:
    mesh = trimesh.creation.capsule(height=0.3, radius=0.05, count=(64, 64))
    turned = trimesh.transformations.rotation_matrix(0.7, (1, 2, 3), (0.1, 0.2, 0.3))
    mesh.apply_transform(turned)
    found = covered(mesh.triangles.view(np.ndarray))
    assert found.radii == pytest.approx([0.05], abs=0.001)
    assert lengths(found) == pytest.approx([0.3], abs=0.005)
    offset = 0.15 * turned[:3, 2]
    expected = sorted((mesh.centroid + sign * offset).tolist() for sign in (-1, 1))
    ends = sorted(found.segments[0].tolist())
    assert np.array(ends) == pytest.approx(np.array(expected), abs=0.003)


def test_a_ball_is_a_capsule_of_hardly_any_length() -> None:
    mesh = solids.as_mesh(solids.ball(0.1))
    found = covered(mesh.vertices[mesh.faces])
    assert len(found.radii) == 1
    assert found.radii[0] + lengths(found)[0] / 2 == pytest.approx(0.1, abs=0.002)


def test_a_rod_is_one_capsule_that_is_no_larger_than_needed() -> None:
    """It passes at most through the edges of the rod; a margin of 20 mm permits that."""
    found = covered(ROD.vertices[ROD.faces])
    assert len(found.radii) == 1
    assert 0.02 < found.radii[0] < 0.02 * np.sqrt(2)
    assert 0.3 < lengths(found)[0] < 0.4


@pytest.mark.parametrize(("margin", "most", "number"), [(0.02, 9, 2), (0.02, 1, 1), (0.3, 9, 1)])
def test_a_corner_is_two_capsules_if_the_margin_demands_it(
    margin: float, most: int, number: int
) -> None:
    found = covered(CORNER, margin=margin, most=most)
    assert len(found.radii) == number
    assert measure(CORNER, found).coverage > 0.985
    if number == 2:
        assert measure(CORNER, found).protrusion_p95 < 0.02


@pytest.mark.usefixtures("rough_meshes")
def test_the_number_is_shared_and_each_solid_has_one() -> None:
    solid = ROD.vertices[ROD.faces]
    numbers = [
        len(one.radii) for one in fit([solid, CORNER, solid], coverage=0.99, margin=0.015, most=4)
    ]
    assert numbers == [1, 2, 1]
    assert [len(one.radii) for one in fit([solid] * 3, coverage=0.99, margin=0.001, most=1)] == [
        1,
        1,
        1,
    ]


@pytest.mark.usefixtures("rough_meshes")
def test_the_same_every_time() -> None:
    first, second = covered(CORNER), covered(CORNER)
    assert np.array_equal(first.segments, second.segments)
    assert np.array_equal(first.radii, second.radii)


def test_distances_are_those_of_coal() -> None:
    coal = pytest.importorskip("coal")
    random = np.random.default_rng(0)
    segments, radii = random.uniform(-1, 1, (3, 2, 3)), random.uniform(0.05, 0.2, 3)
    points = random.uniform(-2, 2, (200, 3))
    expected = np.full(len(points), np.inf)
    for segment, radius in zip(segments, radii, strict=True):
        along = segment[1] - segment[0]
        frame = trimesh.geometry.align_vectors((0, 0, 1), along)[:3, :3]
        pose = coal.Transform3s(frame, segment.mean(axis=0))
        capsule = coal.Capsule(radius, float(np.linalg.norm(along)))
        for number, point in enumerate(points):
            at = coal.Transform3s(np.eye(3), point)
            result = coal.DistanceResult()
            distance = coal.distance(
                capsule, pose, coal.Sphere(1e-9), at, coal.DistanceRequest(), result
            )
            expected[number] = min(expected[number], distance)
    found = Capsules(segments, radii).distances(points)
    assert found == pytest.approx(expected, abs=1e-6)


def test_points_are_on_the_surfaces_and_spread_evenly() -> None:
    """The cylinder of a capsule has the part length / (length + 2 radius) of its area."""
    capsules = Capsules(np.array([[(0, 0, 0), (0.3, 0, 0)], [(1, 1, 1)] * 2]), np.array([0.1, 0.2]))
    first, second = capsules.on_surfaces(np.random.default_rng(0))
    assert capsules.distances(first) == pytest.approx(0, abs=1e-9)
    assert np.linalg.norm(second - 1, axis=1) == pytest.approx(0.2)
    along = first[:, 0]
    assert ((along > 0) & (along < 0.3)).mean() == pytest.approx(0.3 / 0.5, abs=0.06)
    assert second.mean(axis=0) == pytest.approx(1, abs=0.02)


@settings(max_examples=settings().max_examples // 25)  # seconds each
@given(st.tuples(*[st.floats(0.01, 0.5)] * 3), st.floats(0.005, 0.05))
@example((0.5, 0.5, 0.01), 0.05)
@example((0.01, 0.3, 0.5), 0.02)
def test_boxes_are_covered_as_stated(size: tuple[float, float, float], margin: float) -> None:
    surface = (box := solids.as_mesh(solids.box(size))).vertices[box.faces]
    found = covered(surface, margin=margin)
    points = np.random.default_rng(0).uniform(-0.5, 0.5, (5000, 3)) * size
    assert (found.distances(points) <= 0).mean() > 0.98
    assert 1 <= len(found.radii) <= 9


def test_the_radius_by_the_ends_is_the_distance_of_a_point_from_the_axis() -> None:
    random = np.random.default_rng(0)
    points = random.normal((100, 0, 0), size=(500, 3))
    radius = _radius_by_ends(points, 400)
    axes = [random.normal((100, 0, 0), size=(2, 3)) for _ in range(20)]
    for axis in [*axes, np.repeat(points[:1], 2, axis=0)]:
        distances = np.sort(Capsules(axis[None], np.zeros(1)).distances(points))
        assert radius(axis.ravel()) == pytest.approx(distances[400], abs=1e-9)
