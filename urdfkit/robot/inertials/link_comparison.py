"""Comparison of a link's mass and inertia tensor with its shapes."""

from collections.abc import Callable, Iterable
from functools import cached_property
from math import inf

from urdfkit.core.grouping import by_key
from urdfkit.core.spatial import Vector, dot, length, minus, rotate, transposed
from urdfkit.robot import inertia
from urdfkit.robot.link import Body, Inertial, Link, Tensor
from urdfkit.robot.rigid_bodies import RigidBody
from urdfkit.robot.shapes import BoundingBox, LinkSolid, MeshSolid, Primitive, solid

#: Upper bound of the size of robot parts, in m; sizes in millimetres exceed it.
LARGEST_PART = 10.0

#: Errors of a link below this part of its rigid body's mass or inertia are negligible.
SIGNIFICANT_PART = 0.01

#: Moments up to this, in kg·m², are noise; a ball of 1 mg and a radius of 1 mm has 4e-13.
NOISE = 1e-13

#: Rounding error of a tensor, relative to its largest moment.
ROUNDING = 0.01

#: Relative tolerance for moments that were computed from a solid.
MOMENT_TOLERANCE = 0.03

#: Three moments that agree up to this factor with another formula do not agree by chance.
EXACT_RATIO = 1.03

#: The factor for moments about x, y and z of a solid in its orientation.
_OF_SOLID = 1.2

#: The factor for moments about the origin of the link, and that of the largest of them to the one
#: about the centre of mass.
_SHIFTED, _FAR_FROM_CENTER = 1.35, 3.0
#: Largest distance of the centre of mass from that of the solid, as a part of its length.
_CENTERED = 0.08

#: Change of a tensor entry by a significant rotation, as a part of the largest moment.
TURNED = 0.25

#: Range of a tensor relative to that of the uniform solid: a mass in the middle has less, and the
#: thinnest shell twice as much. Tensors with many digits were computed and may be larger.
MIN_FACTOR, MAX_FACTOR, MAX_COMPUTED_FACTOR = 0.3, 2.0, 3.5

#: Of a long body such as a rod: the largest moment by the smallest, and the least part of the
#: largest that the middle one has.
LONG, LONG_MIDDLE = 4.0, 0.6
#: Of a flat body such as a wheel: the largest moment by the middle one, and the least part of the
#: middle one that the smallest has.
FLAT, FLAT_LEAST = 1.5, 0.85
#: Cosine of the angle below which two axes are different, not rotated a little.
OTHER_AXIS = 0.5

#: Values that are written as placeholders, in kg·m².
PLACEHOLDERS = (1.0, 0.1, 0.01, 0.001)

#: Shapes without an edge over this, in m, are markers, not the body of the link.
MARKER = 0.005


class LinkInertia:
    """A link with a mass and an inertia tensor."""

    def __init__(
        self,
        link: Link,
        inertial: Inertial,
        tensor: Tensor,
        body: RigidBody,
        mesh_solid: Callable[[Body], MeshSolid | None] | None = None,
    ) -> None:
        at = inertial.at.child("inertia")
        assert at is not None
        self.link = link  # the link
        self.inertial = inertial  # the element with mass and tensor
        self.mass = link.mass  # in kg, more than 0
        #: The tensor as written: about the centre of mass, along the axes of the ``<inertial>``.
        self.tensor = tensor
        self.at = at  # the ``<inertia>``
        self.body = body  # the rigid body of the link
        self._mesh_solid = mesh_solid

    @property
    def name(self) -> str:
        return self.link.name

    @cached_property
    def moments(self) -> Vector:
        """The principal moments, smallest first, in kg·m²."""
        return inertia.principal_moments(self.tensor)

    @property
    def diagonal(self) -> Vector:
        """``ixx``, ``iyy`` and ``izz``."""
        return (self.tensor.ixx, self.tensor.iyy, self.tensor.izz)

    @property
    def is_negligible(self) -> bool:
        """True if the tensor is practically zero."""
        return max(map(abs, self.moments)) <= NOISE

    @property
    def is_indefinite(self) -> bool:
        """True if a principal moment is negative beyond rounding."""
        low, _, high = self.moments
        return not self.is_negligible and low < -ROUNDING * abs(high)

    @property
    def breaks_triangle(self) -> bool:
        """True if a principal moment exceeds the sum of the others beyond rounding."""
        low, middle, high = self.moments
        return not self.is_negligible and high > (low + middle) * (1 + ROUNDING)

    @property
    def is_diagonal(self) -> bool:
        """True without products of inertia, which people omit and CAD programs do not."""
        return not (self.tensor.ixy or self.tensor.ixz or self.tensor.iyz)

    @property
    def has_round_numbers(self) -> bool:
        """True if no value has more than two significant digits."""
        return all(float(f"{value:.1e}") == value for value in self.tensor)

    @property
    def is_placeholder(self) -> bool:
        """True for a tensor such as 0.1, 0.1, 0.1."""
        return self.is_diagonal and len({*self.diagonal}) == 1 and self.diagonal[0] in PLACEHOLDERS

    @property
    def radius_of_gyration(self) -> float:
        """The largest radius of gyration in m."""
        return float((max(self.moments[2], 0.0) / self.mass) ** 0.5)

    @cached_property
    def solid(self) -> LinkSolid | None:
        """The solid of the collisions, or else of the visuals; None unless all are measured."""
        if self.link.collisions and self.link.visuals:
            return solid(self.link.collisions, self._mesh_solid)
        return self.solids[0] if self.solids else None

    @cached_property
    def is_measured(self) -> bool:
        """True if the link has shapes and all are primitives or measured meshes."""
        kinds = bool(self.link.collisions) + bool(self.link.visuals)
        return 0 < kinds == len(self.solids)

    @cached_property
    def expected(self) -> Tensor | None:
        """The tensor of the uniform solid, along the axes of the ``<inertial>``."""
        return self._uniform(self.solid) if self.solid else None

    def _uniform(self, solid: LinkSolid | Primitive) -> Tensor:
        tensor = solid.properties(self.mass).tensor
        return inertia.rotated(tensor, transposed(self.inertial.origin.rotation))

    @property
    def expected_of_twice(self) -> Tensor | None:
        """The tensor of a single primitive of twice the edges or radius; None for other solids."""
        if (part := self._primitive) is None:
            return None
        x, y, z = part.size
        larger = part._replace(size=(2 * x, 2 * y, 2 * z), radius=2 * part.radius)
        return self._uniform(larger)

    @property
    def expected_of_swapped(self) -> Tensor | None:
        """The tensor of a single cylinder with radius and length exchanged."""
        part = self._primitive
        if part is None or part.kind != "cylinder":
            return None
        return self._uniform(part._replace(radius=part.length, length=part.radius))

    @property
    def _primitive(self) -> Primitive | None:
        """The only shape of the solid, if it is a primitive."""
        parts = self.solid.parts if self.solid else ()
        return parts[0] if len(parts) == 1 and isinstance(parts[0], Primitive) else None

    @cached_property
    def solids(self) -> tuple[LinkSolid, ...]:
        """The solids of the collisions and of the visuals, without unmeasured ones."""
        shapes = (self.link.collisions, self.link.visuals)
        return tuple(each for bodies in shapes if (each := solid(bodies, self._mesh_solid)))

    def lengths_differ(self, ratio: float) -> bool:
        """True if the lengths of its shapes differ by a larger ratio, as in metres and in mm."""
        lengths = [max(part.longest for part in solid.parts) for solid in self.solids]
        return bool(lengths) and max(lengths) > ratio * min(lengths)

    @cached_property
    def bounds(self) -> BoundingBox:
        """The bounding box of the shapes along the axes of the link."""
        return BoundingBox.around(solid.bounds for solid in self.solids)

    @cached_property
    def reach(self) -> float:
        """Distance in m from the centre of mass to the farthest point of the shapes."""
        return max(solid.farthest(self.inertial.origin.position) for solid in self.solids)

    @property
    def largest_possible(self) -> float:
        """The largest moment of inertia of the mass within the shapes, in kg·m².

        The whole mass is at the farthest point from the centre of mass: the distance from an axis
        through the centre is not larger than the distance from the centre.
        """
        return self.mass * self.reach * self.reach

    def ratios(self, expected: Tensor) -> list[float]:
        """Ratios of ``ixx``, ``iyy`` and ``izz`` to those of another tensor."""
        others = (expected.ixx, expected.iyy, expected.izz)
        return [a / b if b > 0 else inf for a, b in zip(self.diagonal, others, strict=True)]

    def fits(self, expected: Tensor, factor: float) -> bool:
        """True if the moments about x, y and z differ by a factor at most."""
        return inertia.agree(self.tensor, expected, factor)

    def is_of(self, solid: LinkSolid) -> bool:
        """True if the moments about x, y and z are those of a uniform solid in its orientation."""
        return self.fits(self._uniform(solid), _OF_SOLID)

    @property
    def differs(self) -> bool:
        """True if a tensor without products is not near that of the uniform solid."""
        if self.expected is None or not self.is_diagonal:
            return False
        ratios = self.ratios(self.expected)
        most = MAX_FACTOR if self.has_round_numbers else MAX_COMPUTED_FACTOR
        return min(ratios) < MIN_FACTOR or max(ratios) > most

    @property
    def is_of_shape(self) -> bool:
        """True if the tensor is that of the uniform solid."""
        return self.expected is not None and self.fits(self.expected, EXACT_RATIO)

    @property
    def is_at_wrong_axes(self) -> bool:
        """True if the principal moments are those of the uniform solid, but about other axes.

        A tensor that fits the visual is correct; the collision may be rotated (GEO004).
        """
        if self.expected is None:
            return False
        if self.is_diagonal and any(map(self.is_of, self.solids)):
            return False
        difference = max(abs(a - b) for a, b in zip(self.tensor, self.expected, strict=True))
        if not self.is_diagonal and difference < TURNED * self.moments[2]:
            return False  # slightly rotated
        pairs = zip(self.moments, inertia.principal_moments(self.expected), strict=True)
        return all(abs(a - b) <= MOMENT_TOLERANCE * b for a, b in pairs)

    @cached_property
    def about_center(self) -> Tensor:
        """The tensor about the centre of mass, if the written one is about the link's origin."""
        origin = self.inertial.origin
        offset = rotate(transposed(origin.rotation), origin.position)
        return inertia.shifted(self.tensor, -self.mass, offset)

    @property
    def is_about_origin(self) -> bool:
        """True if the tensor is that of the uniform solid about the link's origin, not its centre.

        The difference between the two must be large, and the centre of mass that of the solid: a
        motor next to an outline has a tensor of its own. Few digits fit by chance.
        """
        if self.expected is None or self.solid is None or self.has_round_numbers:
            return False
        shift = minus(self.solid.properties(1.0).center, self.inertial.origin.position)
        if length(shift) > _CENTERED * max(self.bounds.edges):
            return False
        is_shifted = max(self.ratios(self.expected)) > _FAR_FROM_CENTER
        return is_shifted and inertia.agree(self.about_center, self.expected, _SHIFTED)

    @cached_property
    def turned_axis(self) -> tuple[Vector, Vector] | None:
        """The axes of tensor and shape if both are of long or of flat bodies, and differ.

        How the mass is distributed changes the moments, but not where a rod or a wheel points.
        """
        if (own := _elongation(self.tensor)) is None:
            return None
        axes = []
        for shape in self.solids:
            other = _elongation(self._uniform(shape))
            if other is None or other[0] != own[0] or abs(dot(other[1], own[1])) >= OTHER_AXIS:
                return None
            axes.append(other[1])
        return (own[1], axes[0]) if axes else None

    @property
    def is_marker(self) -> bool:
        """True if the collision or the visual is a marker, not the body of the link."""
        return any(all(part.longest <= MARKER for part in solid.parts) for solid in self.solids)

    @cached_property
    def densities(self) -> tuple[float, float] | None:
        """The mass by the larger and by the smaller volume of collision and visual, in kg/m³.

        None without a collision, except for visuals too large for a part, and if a shape is not
        measured or only a marker. The larger volume of a mesh is that of its convex hull: a hollow
        mesh may contain motors.
        """
        if not self.is_measured:
            return None
        if not self.link.collisions and max(self.bounds.edges) <= LARGEST_PART:
            return None
        if self.is_marker:
            return None
        least = min(solid.minimum_volume for solid in self.solids)
        most = max(solid.maximum_volume for solid in self.solids)
        return self.mass / most, self.mass / least if least else inf


def _elongation(tensor: Tensor) -> tuple[str, Vector] | None:
    """Whether a body is ``long`` or ``flat``, and its axis; None if neither."""
    low, middle, high = inertia.principal_moments(tensor)
    is_long = high >= LONG * low and middle >= LONG_MIDDLE * high
    is_flat = high >= FLAT * middle and low >= FLAT_LEAST * middle
    if low <= 0 or not (is_long or is_flat):
        return None
    _, rotation = inertia.principal_axes(tensor)
    axes = transposed(rotation)
    return ("long", axes[0]) if is_long else ("flat", axes[2])


def by_tensor(inertias: Iterable[LinkInertia]) -> Iterable[list[LinkInertia]]:
    """Groups of links with the same tensor, in the order of the first link of each."""
    return by_key((link.tensor, link) for link in inertias).values()
