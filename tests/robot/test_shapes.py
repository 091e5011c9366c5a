import random
from itertools import product
from math import hypot, pi, sqrt
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.massive import BALL, BOX, MESH, WHEEL, context, link, shape
from urdfkit.core.spatial import IDENTITY, Transform, Vector, from_rpy
from urdfkit.robot import inertia
from urdfkit.robot.shapes import BoundingBox, LinkSolid, Primitive, shaped, sizes, solid

angles = st.floats(-pi, pi)
frames = st.builds(
    Transform, st.builds(from_rpy, angles, angles, angles), st.tuples(*[st.floats(-5, 5)] * 3)
)
lengths = st.floats(0.01, 5)
boxes = st.builds(
    lambda size, origin: Primitive("box", size, 0, 0, origin),
    st.tuples(lengths, lengths, lengths),
    frames,
)
rounds = st.builds(
    lambda kind, radius, length, origin: Primitive(
        kind, (0, 0, 0), radius, 0 if kind == "sphere" else length, origin
    ),
    st.sampled_from(["cylinder", "capsule", "sphere"]),
    lengths,
    lengths,
    frames,
)
primitives = boxes | rounds
points = st.tuples(*[st.floats(-5, 5)] * 3)


AT_ORIGIN = Transform()


def primitive(kind: str, *numbers: float, origin: Transform = AT_ORIGIN) -> Primitive:
    if kind == "box":
        return Primitive(kind, (numbers[0], numbers[1], numbers[2]), 0, 0, origin)
    return Primitive(kind, (0, 0, 0), numbers[0], numbers[1] if len(numbers) > 1 else 0, origin)


def samples(part: Primitive) -> list[Vector]:
    """Points on the rim of a primitive, in the frame of the link; all extremes are near one."""
    if part.kind == "box":
        x, y, z = (edge / 2 for edge in part.size)
        local: list[Vector] = [(a * x, b * y, c * z) for a, b, c in product((-1, 1), repeat=3)]
        return [part.origin.apply(point) for point in local]
    generator = random.Random(1)
    local = []
    for _ in range(4000):
        x, y, z = (generator.gauss(0, 1) for _ in range(3))
        end = part.length / 2 * (1 if z > 0 else -1)
        size = hypot(x, y) if part.kind == "cylinder" else sqrt(x * x + y * y + z * z)
        scale = part.radius / size
        local.append((x * scale, y * scale, end + (0 if part.kind == "cylinder" else z * scale)))
    return [part.origin.apply(point) for point in local]


@given(primitives, points)
def test_the_farthest_point_is_on_the_rim(part: Primitive, point: Vector) -> None:
    farthest = max(
        sqrt(sum((a - b) ** 2 for a, b in zip(sample, point, strict=True)))
        for sample in samples(part)
    )
    assert farthest <= part.farthest(point) * (1 + 1e-9) <= farthest * 1.02


@given(primitives, st.tuples(*[st.floats(-1, 1)] * 3).filter(lambda v: hypot(*v) > 0.1))
def test_the_reach_is_that_of_the_outermost_point(part: Primitive, direction: Vector) -> None:
    x, y, z = (value / hypot(*direction) for value in direction)
    outermost = max(x * a + y * b + z * c for a, b, c in samples(part))
    size = part.farthest(part.origin.position)
    assert outermost - 1e-9 <= part.reach((x, y, z)) <= outermost + 0.02 * size


@pytest.mark.parametrize(
    ("part", "volume"),
    [
        (primitive("box", 1, 2, 3), 6),
        (primitive("cylinder", 2, 3), 12 * pi),
        (primitive("sphere", 2), 32 * pi / 3),
        (primitive("capsule", 2, 3), 12 * pi + 32 * pi / 3),
    ],
)
def test_volumes(part: Primitive, volume: float) -> None:
    assert part.volume == pytest.approx(volume)
    assert LinkSolid((part, part)).volume == pytest.approx(2 * volume)


@pytest.mark.parametrize(
    ("part", "longest"),
    [
        (primitive("box", 1, 3, 2), 3),
        (primitive("cylinder", 2, 3), 4),
        (primitive("cylinder", 1, 3), 3),
        (primitive("sphere", 2), 4),
        (primitive("capsule", 2, 3), 7),
    ],
)
def test_the_longest_extent(part: Primitive, longest: float) -> None:
    assert part.longest == longest
    assert max(LinkSolid((part,)).bounds.edges) == longest


def test_volumes_and_tensors_as_coal_has_them() -> None:
    coal: Any = pytest.importorskip("coal")
    theirs = {
        primitive("box", 1, 2, 3): coal.Box(1, 2, 3),
        primitive("cylinder", 2, 3): coal.Cylinder(2, 3),
        primitive("sphere", 2): coal.Sphere(2),
        primitive("capsule", 2, 3): coal.Capsule(2, 3),
    }
    for part, other in theirs.items():
        assert part.volume == pytest.approx(other.computeVolume())
        tensor, rows = part.properties(part.volume).tensor, other.computeMomentofInertia()
        assert (tensor.ixx, tensor.iyy, tensor.izz) == pytest.approx(tuple(rows.diagonal()))


def test_mass_properties_are_in_the_frame_of_the_link() -> None:
    turned = Transform(from_rpy(pi / 2, 0, 0), (1, 2, 3))
    properties = primitive("cylinder", 1, 2, origin=turned).properties(12)
    assert (properties.mass, properties.center) == (12, (1, 2, 3))
    assert properties.tensor == pytest.approx((7, 0, 0, 6, 0, 7), abs=1e-12)


def test_two_boxes_make_one() -> None:
    parts = tuple(
        primitive("box", 1, 2, 3, origin=Transform(IDENTITY, (x, 0, 0))) for x in (-0.5, 0.5)
    )
    whole = LinkSolid(parts)
    assert whole.properties(6).tensor == pytest.approx(inertia.box(6, (2, 2, 3)))
    assert whole.bounds == BoundingBox((-1, -1, -1.5), (1, 1, 1.5))
    assert whole.farthest((0, 0, 0)) == pytest.approx(sqrt(1 + 1 + 1.5**2))
    assert str(whole) == "union of 2 primitives"


def test_mass_is_shared_by_volume() -> None:
    large = primitive("box", 3, 1, 1)
    small = primitive("box", 1, 1, 1, origin=Transform(IDENTITY, (4, 0, 0)))
    assert LinkSolid((large, small)).properties(8).center == pytest.approx((1, 0, 0))


def test_boxes_in_common() -> None:
    one, other = BoundingBox((0, 0, 0), (2, 2, 2)), BoundingBox((1, 1, 1), (3, 3, 2))
    assert one.common_volume(other) == other.common_volume(one) == 1
    assert (one.volume, other.volume) == (8, 4)
    assert (other.edges, other.center) == ((2, 2, 1), (2, 2, 1.5))
    assert one.common_volume(BoundingBox((2, 0, 0), (3, 1, 1))) == 0


@pytest.mark.parametrize(
    ("geometry", "text"),
    [
        (BOX, "box of 0.2 x 0.3 x 0.1 m"),
        (BALL, "sphere of radius 0.1 m"),
        (WHEEL, "cylinder of radius 0.06 m and length 0.05 m"),
        ('<capsule radius="1" length="2"/>', "capsule of radius 1 m and length 2 m"),
        ('<box size="1 1 1" radius="9" length="9"/>', "box of 1 x 1 x 1 m"),
        ('<sphere radius="1" size="9 9 9" length="9"/>', "sphere of radius 1 m"),
        (MESH, None),
        ('<box size="1 0 1"/>', None),
        ('<box size="1 -1 1"/>', None),
        ('<box size="1 1"/>', None),
        ('<box size="1 1 1e9"/>', None),
        ('<sphere radius="1e-12"/>', None),
        ('<sphere radius="x"/>', None),
        ('<sphere radius="nan"/>', None),
        ('<cylinder radius="1"/>', None),
        ('<capsule radius="2" length="-1"/>', None),
        ("<torus/>", None),
        ("", None),
    ],
)
def test_what_is_a_solid(geometry: str, text: str | None) -> None:
    (one,) = context(link("a", shape("collision", geometry))).model.links
    found = solid(one.collisions)
    assert (found and str(found)) == text


def test_one_mesh_makes_it_no_solid() -> None:
    (one,) = context(link("a", shape("visual", BOX), shape("visual", MESH))).model.links
    assert solid(one.visuals) is None
    assert solid(one.collisions) is None


def test_the_shapes_of_a_model_and_their_sizes() -> None:
    model = context(
        link("a", shape("visual", WHEEL), shape("collision", '<box size="1 2"/>')) + link("b")
    ).model
    found = [(link.name, body.at.tag, shape) for link, body, shape in shaped(model)]
    assert [(name, tag, shape.kind) for name, tag, shape in found] == [
        ("a", "visual", "cylinder"),
        ("a", "collision", "box"),
    ]
    wheel, box = (shape for *_, shape in found)
    assert [(a.name, values) for a, values in sizes(wheel)] == [
        ("radius", (0.06,)),
        ("length", (0.05,)),
    ]
    assert list(sizes(box)) == []
