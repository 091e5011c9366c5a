"""The collisions of a link compared with its visuals.

The collision may be simpler, a little larger, or without some parts. What is compared is the
bounding box of each along the axes of the link, in m.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from enum import Enum
from functools import cached_property
from itertools import permutations, product
from math import hypot, log

from urdfkit.core.record import Record
from urdfkit.core.spatial import Rotation, Transform, Vector, cross, length, minus, to_rpy
from urdfkit.robot.model import Body, Link, RobotModel, Shape
from urdfkit.robot.shapes import OTHER_UNIT, BoundingBox, LinkSolid, MeshSolid, solid

#: Common volume by the volume of both bounding boxes together, below which they are apart. A body
#: that stands on its origin in one and lies about it in the other has 1/3, and a little more where
#: the half of its height was rounded.
LEAST_OVERLAP = 0.34

#: A box with this part of its volume within the other one is intentionally larger or smaller.
NESTED = 0.9

#: Shapes with no edge over this, in m, mark a place.
MARKER = 0.005

#: Corners that are no farther apart than this, in m, differ by a tolerance, or a sheet's thickness.
NEAR = 0.002

#: Edges of a cube differ by less; and how many times as large as what is too small by a thousand a
#: part may be, being only similar.
CUBE, THOUSAND = 1.1, (600.0, 1600.0)

#: `OTHER_UNIT` for two meshes that differ by one factor in every direction: one part, two scales.
LARGER_ALIKE, ALIKE = 1.5, 1.02

#: Boxes in one place that would have this much in common are those of one part; those of a motor
#: and of a cylinder in the place of its neighbour have 0.66.
SAME = 0.72

#: What a turn must add to the common volume.
GAIN = 0.3

#: Two meshes that a turn lays over one another like this are one part; above the other, they lie
#: as they should.
SAME_MESH, ALIGNED = 0.97, 0.85


class Mismatch(Enum):
    """How collision and visual of a link differ."""

    SIZE = "size"
    ROTATION = "rotation"
    APART = "apart"


class QuarterTurn(Record):
    """A rotation by which one of the two coincides with the other."""

    body: Body  # the visual or collision to rotate
    rpy: Vector  # of its ``<origin>`` after that, in rad
    overlap: float  # common volume by that of both together, after that


class VisualCollisionPair:
    """The collisions and the visuals of a link."""

    def __init__(self, link: Link, collision: LinkSolid, visual: LinkSolid) -> None:
        self.link = link  # the link
        #: collision and visual: all its collisions, and all its visuals, as solids.
        self.collision = collision
        self.visual = visual

    @property
    def is_marker(self) -> bool:
        """True if one of the two only marks a place."""
        return any(
            max(one.bounds.edges) <= MARKER and not _is_mesh(one)
            for one in (self.collision, self.visual)
        )

    @cached_property
    def is_shrunk(self) -> bool:
        """True if one of the two is a thousand times too small, and marks no place.

        A marker is a cube or a ball; a shrunk shape has the proportions of its link.
        """
        small, large = sorted((self.collision.bounds.edges, self.visual.bounds.edges), key=max)
        ratios = [a / b if b > 0 else 0.0 for a, b in zip(large, small, strict=True)]
        is_cube = max(small) < CUBE * min(small)
        return not is_cube and all(THOUSAND[0] <= ratio <= THOUSAND[1] for ratio in ratios)

    @cached_property
    def overlap(self) -> float:
        """The common volume by that of both together."""
        return _overlap(self.collision.bounds, self.visual.bounds)

    @property
    def is_nested(self) -> bool:
        """True if one of the two is larger about the same place, or replaces a part."""
        one, other = self.collision.bounds, self.visual.bounds
        return one.common_volume(other) >= NESTED * min(one.volume, other.volume)

    @cached_property
    def factor(self) -> float | None:
        """How many times as large as the collision the visual is; None if that may be intended."""
        edges = zip(self.visual.bounds.edges, self.collision.bounds.edges, strict=True)
        low, middle, high = sorted(a / b if b > 0 else 0.0 for a, b in edges)
        if low <= 0:
            return None
        least = LARGER_ALIKE if self._has_meshes and high < ALIKE * low else OTHER_UNIT
        return middle if low >= least or high <= 1 / least else None

    @cached_property
    def turn(self) -> QuarterTurn | None:
        """The quarter turns that lay one over the other; None if they hardly help."""
        turns = [*self._turns(self.link.visuals, self.visual, self.collision)]
        turns += self._turns(self.link.collisions, self.collision, self.visual)
        best = max(turns, key=lambda turn: round(turn.overlap, 3), default=None)
        least = max(SAME, self.overlap + GAIN)
        if self._has_meshes:
            least = min(least, SAME_MESH)
        return best if best and best.overlap >= least else None

    @property
    def _has_meshes(self) -> bool:
        """True if collision and visual are meshes: drawn from one part, with one outline."""
        return _is_mesh(self.collision) and _is_mesh(self.visual)

    @staticmethod
    def _turns(bodies: tuple[Body, ...], one: LinkSolid, other: LinkSolid) -> Iterator[QuarterTurn]:
        for body in bodies if len(bodies) == 1 else ():
            frame = body.origin
            for quarter in QUARTERS:
                turned = frame @ Transform(quarter)
                box = one.bounds.moved(turned @ frame.inverse)
                yield QuarterTurn(body, to_rpy(turned.rotation), _overlap(box, other.bounds))

    @property
    def is_apart(self) -> bool:
        """True if they have little in common, and are not merely simplified.

        Legs often give a hip the cylinder of the motor next to it, intentionally. The same shape at
        another place is a mistake, and so are shapes that are farther apart than they are long.
        """
        if self.overlap >= LEAST_OVERLAP or self.is_nested or self._is_near:
            return False
        if not (_is_mesh(self.collision) or _is_mesh(self.visual)) or self.has_one_shape:
            return True
        one, other = self.collision.bounds, self.visual.bounds
        concentric = other.moved(Transform(position=minus(one.center, other.center)))
        if _overlap(one, concentric) >= SAME:
            return True
        return one.gap(other) > max(*one.edges, *other.edges)

    @property
    def _is_near(self) -> bool:
        """True if one box lies where the other does, as two sheets on one another."""
        corners = zip(self.visual.bounds, self.collision.bounds, strict=True)
        return all(length(minus(one, other)) <= NEAR for one, other in corners)

    @property
    def has_one_shape(self) -> bool:
        """True if collision and visual are one shape, wherever they are."""
        if len(self.link.collisions) != 1 or len(self.link.visuals) != 1:
            return False
        one, other = self.link.collisions[0].shape, self.link.visuals[0].shape
        return one is not None and other is not None and _form(one) == _form(other)

    def unusual(self, span: float) -> Body:
        """The first visual or collision, whichever is less of the size of the robot.

        Args:
            span: the longest distance of two joints that follow one another, in m.
        """
        visual, collision = self.link.visuals[0], self.link.collisions[0]
        if span <= 0:
            return visual
        of_visual, of_collision = (
            abs(log(max(one.bounds.edges) / span)) for one in (self.visual, self.collision)
        )
        return visual if of_visual >= of_collision else collision


class VisualCollisionPairs:
    """The links of a robot that have both visuals and collisions.

    Args:
        mesh_solid: a visual or collision that is a mesh, as a solid; None where not measured.
        is_ambiguous: True for a visual or collision that programs rotate differently.
    """

    def __init__(
        self,
        model: RobotModel,
        mesh_solid: Callable[[Body], MeshSolid | None],
        is_ambiguous: Callable[[Body], bool],
    ) -> None:
        self._model = model
        self._mesh_solid = mesh_solid
        self._is_ambiguous = is_ambiguous

    @cached_property
    def mismatches(self) -> dict[Mismatch, list[VisualCollisionPair]]:
        """The links with each mismatch; each link has at most one."""
        found: dict[Mismatch, list[VisualCollisionPair]] = {}
        for one in self._each():
            if mismatch := self._mismatch(one):
                found.setdefault(mismatch, []).append(one)
        return found

    @property
    def span(self) -> float:
        """The longest distance of two joints that follow one another, in m."""
        places = (joint.origin.position for joint in self._model.joints)
        return max((hypot(*place) for place in places), default=0.0)

    def _each(self) -> Iterator[VisualCollisionPair]:
        for link in self._model.links:
            if link.visuals and link.collisions:
                collision = solid(link.collisions, self._mesh_solid)
                visual = solid(link.visuals, self._mesh_solid)
                if collision and visual and collision.parts != visual.parts:
                    yield VisualCollisionPair(link, collision, visual)

    def _mismatch(self, one: VisualCollisionPair) -> Mismatch | None:
        if one.overlap >= ALIGNED or (one.is_marker and not one.is_shrunk):
            return None
        if one.factor:
            return Mismatch.SIZE
        if not one.has_one_shape:  # else the origins explain it
            if any(map(self._is_ambiguous, (*one.link.visuals, *one.link.collisions))):
                return None
            if one.turn:
                return Mismatch.ROTATION
        return Mismatch.APART if one.is_apart else None


def _quarters() -> Iterator[Rotation]:
    """The 23 rotations that lay a cube over itself, the smaller ones first."""
    axes: list[Vector] = [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)]
    found = []
    for (a, b), (s, t) in product(permutations(axes, 2), product((1, -1), repeat=2)):
        x, y = (s * a[0], s * a[1], s * a[2]), (t * b[0], t * b[1], t * b[2])
        found.append((x, y, cross(x, y)))
    found.sort(key=lambda r: -(r[0][0] + r[1][1] + r[2][2]))
    yield from found[1:]


#: All turns by right angles.
QUARTERS: tuple[Rotation, ...] = tuple(_quarters())


def _overlap(one: BoundingBox, other: BoundingBox) -> float:
    """The common volume of two boxes by that of both together."""
    common = one.common_volume(other)
    both = one.volume + other.volume - common
    return common / both if both > 0 else 0.0


def _is_mesh(one: LinkSolid) -> bool:
    return any(isinstance(part, MeshSolid) for part in one.parts)


def _form(shape: Shape) -> tuple[object, ...]:
    name = shape.filename.value if shape.filename else ""
    return (shape.kind, shape.size, shape.radius, shape.length, name, shape.scale)
