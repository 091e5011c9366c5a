from collections.abc import Callable
from math import pi

import pytest

pytest.importorskip("numpy")
pytest.importorskip("manifold3d")

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from urdfkit.mesh.components import split_pieces
from urdfkit.mesh.edges import Edges
from urdfkit.mesh.geometry import Mesh, MeshPart
from urdfkit.mesh.grouping import components, equal_numbers
from urdfkit.mesh.measures import OVERLAP, Measures, from_json, to_json
from urdfkit.mesh.measuring import measure
from urdfkit.mesh.overlap import most_overlap, overlap
from urdfkit.mesh.welding import weld

CORNERS = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
#: The triangles of a cube, seen from outside.
CUBE = np.array(
    [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1),
     (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3)]
)  # fmt: skip


def box(
    size: tuple[float, float, float] = (1, 1, 1), at: tuple[float, float, float] = (0, 0, 0)
) -> MeshPart:
    """A box with its lowest corner at a place."""
    return MeshPart(CORNERS * size + at, CUBE)


def inverted(part: MeshPart) -> MeshPart:
    return part._replace(faces=part.faces[:, ::-1])


def soup(part: MeshPart) -> MeshPart:
    """The same triangles with three vertices each, as in an STL."""
    return MeshPart(
        part.vertices[part.faces].reshape(-1, 3), np.arange(3 * len(part.faces)).reshape(-1, 3)
    )


def of(*parts: MeshPart) -> Measures:
    return measure(Mesh(parts))


def counts(found: Measures) -> tuple[int, ...]:
    """Open and flipped edges, degenerate triangles."""
    return (found.open_edges, found.flipped_edges, found.degenerate)


@pytest.mark.parametrize("shape", [box, lambda size, at: soup(box(size, at))])
def test_a_box(shape: Callable[..., MeshPart]) -> None:
    found = of(shape((2, 3, 4), (10, 20, 30)))
    assert (found.triangles, found.vertices, found.bodies) == (12, 8, 1)
    assert (found.low, found.high) == ((10.0, 20.0, 30.0), (12.0, 23.0, 34.0))
    assert found.edges == (2.0, 3.0, 4.0)
    assert found.area == pytest.approx(52)
    assert counts(found) == (0, 0, 0)
    assert found.is_closed
    assert not found.inside_out
    for solid in (found.solid, found.hull):
        assert solid is not None
        assert solid.volume == pytest.approx(24)
        assert solid.center == pytest.approx((11, 21.5, 32))
        # mass / 12 * (the squares of the two other edges)
        assert solid.tensor == pytest.approx((24 / 12 * 25, 0, 0, 24 / 12 * 20, 0, 24 / 12 * 13))
    assert sorted(found.points) == sorted(map(tuple, box((2, 3, 4), (10, 20, 30)).vertices))


def test_a_turned_prism_has_products_of_inertia() -> None:
    """A right triangle with legs of 1, of height 1: ixy = 1/24 - 1/2 * 1/3 * 1/3."""
    corners = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1)], float)
    faces = np.array(
        [(0, 2, 1), (3, 4, 5), (0, 1, 4), (0, 4, 3), (1, 2, 5), (1, 5, 4), (2, 0, 3), (2, 3, 5)]
    )
    solid = of(MeshPart(corners, faces)).solid
    assert solid is not None
    assert solid.volume == pytest.approx(1 / 2)
    assert solid.center == pytest.approx((1 / 3, 1 / 3, 1 / 2))
    about_x = 1 / 12 - 1 / 2 / 9 + 1 / 2 / 12
    assert solid.tensor == pytest.approx(
        (about_x, 1 / 2 / 9 - 1 / 24, 0, about_x, 0, 2 * (1 / 12 - 1 / 2 / 9))
    )


def test_a_ball_is_measured_as_finely_as_it_is_made() -> None:
    number = 64
    rings = [pi * i / number for i in range(1, number)]
    turns = [2 * pi * i / (2 * number) for i in range(2 * number)]
    grid = np.array(
        [(np.sin(a) * np.cos(b), np.sin(a) * np.sin(b), np.cos(a)) for a in rings for b in turns]
    )
    corners = np.concatenate([grid, [(0, 0, 1), (0, 0, -1)]])
    faces, width = [], 2 * number
    for i in range(width):
        k = (i + 1) % width
        faces += [
            (i, k, len(grid)),
            ((number - 2) * width + k, (number - 2) * width + i, len(grid) + 1),
        ]
        for ring in range(number - 2):
            a, b = ring * width + i, ring * width + k
            faces += [(a, a + width, b), (b, a + width, b + width)]
    found = of(MeshPart(corners, np.array(faces)))
    assert found.is_closed
    assert found.solid is not None
    assert found.solid.volume == pytest.approx(4 / 3 * pi, rel=3e-3)
    assert found.solid.tensor[0] == pytest.approx(8 / 15 * pi, rel=5e-3)
    reach = [max(np.dot(p, d) for p in found.points) for d in np.eye(3)]
    assert reach == pytest.approx([1, 1, 1], abs=1e-3)
    assert len(found.points) <= 200


def test_what_looks_inwards() -> None:
    found = of(inverted(box()))
    assert found.is_closed
    assert found.inside_out
    assert found.inverted_bodies == 1
    assert found.solid is not None
    assert found.solid.volume == pytest.approx(1)
    assert found.solid.tensor == pytest.approx((1 / 6, 0, 0, 1 / 6, 0, 1 / 6))


def test_a_cavity_is_not_inverted() -> None:
    found = of(box((3, 3, 3)), inverted(box((1, 1, 1), (1, 1, 1))))
    assert (found.bodies, found.inverted_bodies, found.inside_out) == (2, 0, False)
    assert found.solid is not None
    assert found.hull is not None
    assert found.solid.volume == pytest.approx(26)
    assert found.hull.volume == pytest.approx(27)


def test_one_of_two_bodies_is_inverted() -> None:
    found = of(box((3, 3, 3)), inverted(box((1, 1, 1), (5, 0, 0))))
    assert (found.bodies, found.inverted_bodies, found.inside_out) == (2, 1, False)


@pytest.mark.parametrize("seed", range(4))  # the volume of some is above zero by rounding
def test_a_surface_drawn_from_both_sides_looks_nowhere(seed: int) -> None:
    corners = np.random.default_rng(seed).normal(size=(8, 3)) * 0.1 + CORNERS
    found = of(MeshPart(corners, np.concatenate([CUBE, CUBE[:, ::-1]])))
    assert (found.bodies, found.inverted_bodies, found.inside_out) == (1, 0, False)


def test_a_trifle_that_looks_inwards_in_an_open_mesh() -> None:
    whole = box((3, 3, 3))
    bowl = MeshPart(whole.vertices, whole.faces[2:])
    assert of(bowl, inverted(box((0.1, 0.1, 0.1), (5, 0, 0)))).inverted_bodies == 0
    assert of(bowl, inverted(box((1, 1, 1), (5, 0, 0)))).inverted_bodies == 1


def test_bodies_that_touch_at_an_edge_enclose_a_volume() -> None:
    found = of(box(), box(at=(1, 1, 0)))
    assert counts(found) == (0, 0, 0)
    assert found.solid is not None
    assert found.solid.volume == pytest.approx(2)


def test_an_open_box() -> None:
    found = of(MeshPart(CORNERS, CUBE[2:]))
    assert counts(found) == (4, 0, 0)
    assert not found.is_closed
    assert found.solid is None
    assert found.hull is not None
    assert found.hull.volume == pytest.approx(1)


def test_one_flipped_triangle() -> None:
    faces = CUBE.copy()
    faces[0] = faces[0][::-1]
    found = of(MeshPart(CORNERS, faces))
    assert counts(found) == (0, 3, 0)
    assert found.solid is None


def test_degenerate_and_duplicate_triangles() -> None:
    faces = np.concatenate([CUBE, [(0, 0, 1), (5, 5, 5), CUBE[3][[1, 2, 0]]]])
    found = of(MeshPart(CORNERS, faces))
    assert counts(found) == (3, 0, 2)


def test_a_needle_keeps_a_surface_closed() -> None:
    """A vertex in the middle of an edge, filled with a triangle that has no area."""
    corners = np.concatenate([CORNERS, [(0, 0, 0.5)]])
    faces = np.concatenate([CUBE[1:], [(0, 8, 3), (8, 1, 3), (0, 1, 8)]])
    found = of(MeshPart(corners, faces))
    assert counts(found) == (0, 0, 1)
    assert found.is_closed


@pytest.mark.parametrize("noise", [0, 1e-9, 1e-7])
def test_rounding_does_not_open_a_surface(noise: float) -> None:
    random = np.random.default_rng(1)
    part = soup(box((0.1, 0.2, 0.3), (0.05, 0, 0)))
    found = of(part._replace(vertices=part.vertices + noise * random.uniform(-1, 1, (36, 3)) * 0.1))
    assert counts(found)[:2] == (0, 0)
    assert found.solid is not None
    assert found.solid.volume == pytest.approx(0.006, rel=1e-4)


def test_a_gap_is_no_rounding() -> None:
    part = soup(box())
    part.vertices[0] += 1e-4
    assert of(part).open_edges > 0


def test_flat_pieces() -> None:
    square = MeshPart(
        np.array([(0, 0, 0), (1, 0, 1), (1, 1, 1), (0, 1, 0)], float),
        np.array([(0, 1, 2), (0, 2, 3)]),
    )
    found = of(square)
    assert (found.solid, found.hull) == (None, None)
    assert (found.bodies, found.open_edges) == (1, 4)
    assert sorted(found.points) == sorted(map(tuple, square.vertices))


def test_one_point_and_one_line() -> None:
    point = of(MeshPart(np.zeros((1, 3)), np.zeros((1, 3), dtype=int)))
    assert (point.hull, point.bodies, point.degenerate) == (None, 0, 1)
    line = of(MeshPart(np.array([(0, 0, 0), (1, 0, 0), (2, 0, 0)], float), np.array([(0, 1, 2)])))
    assert (line.hull, line.degenerate, line.is_closed) == (None, 1, False)


@pytest.mark.parametrize("scale", [1e-6, 1, 1e6])
@pytest.mark.parametrize("shift", [0, 100])
def test_size_and_place_do_not_matter(scale: float, shift: float) -> None:
    found = of(box((scale, scale, scale), (shift * scale, 0, 0)))
    for solid in (found.solid, found.hull):
        assert solid is not None
        assert solid.volume == pytest.approx(scale**3, rel=1e-6)
        assert solid.center[0] == pytest.approx((shift + 0.5) * scale)
        assert solid.tensor[0] == pytest.approx(scale**5 / 6, rel=1e-5)


@given(st.lists(st.tuples(st.integers(0, 30), st.integers(0, 30)), max_size=60))
def test_components_are_those_of_a_search(edges: list[tuple[int, int]]) -> None:
    expected = list(range(31))
    for _ in range(31):
        for a, b in edges:
            expected[a] = expected[b] = min(expected[a], expected[b])
    ends = np.array(edges, dtype=np.int64).reshape(-1, 2)
    assert components(31, ends).tolist() == expected


def test_a_long_chain_takes_few_rounds() -> None:
    random = np.random.default_rng(1)
    order = random.permutation(200_000)
    ends = np.stack([order[:-1], order[1:]], axis=1)
    assert not components(200_000, ends).any()


@given(st.lists(st.integers(-5, 5), max_size=60))
def test_equal_numbers_are_those_of_numpy(numbers: list[int]) -> None:
    found = equal_numbers(np.array(numbers, dtype=np.int64))
    expected = np.unique(
        np.array(numbers, dtype=np.int64),
        return_index=True,
        return_inverse=True,
        return_counts=True,
    )[1:]
    assert [array.tolist() for array in found] == [array.tolist() for array in expected]


def test_measures_survive_json() -> None:
    import json

    for part in (box(), MeshPart(CORNERS, CUBE[:1])):
        found = measure(Mesh((part,), 0.1, "Y_UP", losses=("a",), textures=("b.png",)))
        assert from_json(json.loads(json.dumps(to_json(found)))) == found


@pytest.mark.parametrize("size", [1e-150, 1e-60, 1e60, 1e150])
def test_a_box_beyond_all_numbers(size: float) -> None:
    """Its inertia is smaller or larger than any number is."""
    found = measure(Mesh((box((size, size, size)),)))
    assert found.triangles == 12
    assert found.hull is None or found.hull.volume == pytest.approx(size * size * size)
    if size in (1e-150, 1e150):
        assert found.solid is None


@pytest.mark.parametrize("scale", [1e-3, 1.0, 1e4])
@pytest.mark.parametrize("shared", [0.0, 0.25, 1.0])
def test_what_pieces_share_counts_twice(shared: float, scale: float) -> None:
    """Three cubes, of which two share a part of their volume."""
    places = [(0.0, 0.0, 0.0), (0.0, 0.1, 1 - shared), (9.0, 9.0, 9.0)]
    parts = [box(at=place) for place in places]
    mesh = Mesh(tuple(part._replace(vertices=part.vertices * scale) for part in parts))
    measures = measure(mesh)
    twice = 0.9 * shared
    assert measures.solid is not None
    assert measures.bodies == 3
    assert measures.overlap == pytest.approx(twice / (3 - twice), abs=1e-6)
    assert measures.solid.volume == pytest.approx(3 * scale**3)


@given(
    st.lists(st.tuples(*[st.floats(0, 2)] * 3), min_size=2, max_size=4),
    st.lists(st.tuples(*[st.floats(0, 2)] * 3), max_size=2),
)
def test_bounding_boxes_limit_the_overlap(
    cubes: list[tuple[float, float, float]], cavities: list[tuple[float, float, float]]
) -> None:
    parts = [box(at=place) for place in cubes]
    parts += [inverted(box((0.3, 0.3, 0.3), place)) for place in cavities]
    mesh = Mesh(tuple(parts))
    places, faces = weld(mesh.vertices, mesh.faces)
    edges = Edges(faces)
    pieces = split_pieces(places, edges)
    found, is_drawn_twice = overlap(places, faces, pieces), edges.is_non_manifold.any()
    assert most_overlap(pieces) >= found - 1e-6 or is_drawn_twice
    is_measured = most_overlap(pieces) > OVERLAP or is_drawn_twice
    assert measure(mesh).overlap == pytest.approx(found if is_measured else 0)


def test_a_cavity_is_no_overlap() -> None:
    hole = inverted(box((0.5, 0.5, 0.5), (0.25, 0.25, 0.25)))
    assert measure(Mesh((box(), hole))).overlap == 0


def test_what_looks_inwards_as_a_whole_is_reported_differently() -> None:
    cubes = Mesh((inverted(box()), inverted(box(at=(0.5, 0, 0)))))
    assert measure(cubes).overlap == 0
