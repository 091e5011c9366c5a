"""Comparison of the collisions of a link with its visuals.

The collision may be simpler, a little larger, or without some parts. The bounding boxes along the
axes of the link are compared, in m.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from functools import cached_property
from itertools import permutations, product
from math import log

from urdfkit.core.record import Record
from urdfkit.core.spatial import (
    AXES,
    IDENTITY,
    Rotation,
    Transform,
    Vector,
    cross,
    length,
    minus,
    times,
    to_rpy,
)
from urdfkit.robot.link import Body, Link, Shape
from urdfkit.robot.shapes import OTHER_UNIT, BoundingBox, LinkSolid, MeshSolid

#: Common volume by the volume of the union of both bounding boxes, below which they are apart. A
#: body with its origin at one end in one box and in the middle in the other has 1/3, and a little
#: more if half of its height was rounded.
LEAST_OVERLAP = 0.34

#: A box with this part of its volume inside the other box is intentionally larger or smaller.
NESTED = 0.9
#: A box with less of its volume inside the other box is outside: only the part around a joint, on
#: whose both sides a link is, may be inside.
OUTSIDE = 0.2

#: Primitives with no edge over this, in m, are markers.
MARKER = 0.005

#: Corners at a smaller distance, in m, differ by a tolerance, or by the thickness of a sheet.
TOLERANCE = 0.002

#: Largest ratio of the edges of a cube; and the range of ratios of a shape that is too small by a
#: factor of 1000 and only similar.
CUBE, THOUSAND = 1.1, (600.0, 1600.0)

#: The bound instead of `OTHER_UNIT` for two meshes whose ratios agree in all directions up to the
#: second factor: one part at two scales.
SIMILAR_UNIT, SIMILAR = 1.5, 1.02

#: Distance of the centres, as a part of the longest edge, of a collision around one of several
#: visuals, and least volume of that visual as a part of the collision's box.
CONCENTRIC, LEAST_PART = 0.05, 0.1

#: Concentric boxes with a larger overlap show one part; a motor and a cylinder in the place of its
#: neighbour have 0.66.
SAME_OVERLAP = 0.72

#: Least increase of the overlap by a rotation.
MIN_GAIN = 0.3

#: Two meshes with this overlap after a rotation are one part.
SAME_MESH = 0.97


class QuarterTurn(Record):
    """A rotation by right angles that aligns collision and visual."""

    body: Body  # the visual or collision to rotate
    rpy: Vector  # of its ``<origin>`` after the rotation, in rad
    overlap: float  # common volume by the volume of the union, after the rotation

    @property
    def is_written(self) -> bool:
        """True if the body has a rotation, which may be wrong."""
        return self.body.origin.rotation != IDENTITY


class VisualCollisionPair:
    """The collisions and the visuals of a link."""

    def __init__(self, link: Link, collision: LinkSolid, visual: LinkSolid) -> None:
        self.link = link  # the link
        #: collision and visual: all collisions and all visuals of the link, as solids.
        self.collision = collision
        self.visual = visual

    @property
    def is_marker(self) -> bool:
        """True if the collision or the visual is only a marker.

        A tiny mesh of a part has the proportions of the other, unless it is a cube.
        """
        return any(
            max(one.bounds.edges) <= MARKER
            and (
                not _is_mesh(one)
                or (_is_cube(one.bounds.edges) and not _is_cube(other.bounds.edges))
            )
            for one, other in permutations((self.collision, self.visual))
        )

    @cached_property
    def is_shrunk(self) -> bool:
        """True if one of the two is a thousand times too small and not a marker.

        A marker is a cube or a ball; a shrunk shape has the proportions of its link.
        """
        small, large = sorted((self.collision.bounds.edges, self.visual.bounds.edges), key=max)
        ratios = [a / b if b > 0 else 0.0 for a, b in zip(large, small, strict=True)]
        return max(small) >= CUBE * min(small) and all(
            THOUSAND[0] <= ratio <= THOUSAND[1] for ratio in ratios
        )

    @cached_property
    def overlap(self) -> float:
        """Common volume by the volume of the union."""
        return _overlap(self.collision.bounds, self.visual.bounds)

    @property
    def is_nested(self) -> bool:
        """True if one of the two is larger at the same position, or replaces a part."""
        collision, visual = self.collision.bounds, self.visual.bounds
        return collision.common_volume(visual) >= NESTED * min(collision.volume, visual.volume)

    @cached_property
    def factor(self) -> float | None:
        """Size of the visual relative to the collision; None if it may be intended."""
        edges = zip(self.visual.bounds.edges, self.collision.bounds.edges, strict=True)
        low, middle, high = sorted(a / b if b > 0 else 0.0 for a, b in edges)
        if low <= 0:
            return None
        least = SIMILAR_UNIT if self._has_meshes and high < SIMILAR * low else OTHER_UNIT
        return middle if low >= least or high <= 1 / least else None

    @cached_property
    def turn(self) -> QuarterTurn | None:
        """The best rotation by right angles; None if it hardly increases the overlap."""
        return self.best_turn((*self.link.visuals, *self.link.collisions))

    def best_turn(self, bodies: Collection[Body]) -> QuarterTurn | None:
        """The best rotation of one of some bodies; None if it hardly increases the overlap."""
        turns = [*self._turns(self.link.visuals, self.visual, self.collision)]
        turns += self._turns(self.link.collisions, self.collision, self.visual)
        turns = [turn for turn in turns if turn.body in bodies]
        best = max(turns, key=lambda turn: (round(turn.overlap, 3), turn.is_written), default=None)
        least = max(SAME_OVERLAP, self.overlap + MIN_GAIN)
        if self._has_meshes:
            least = min(least, SAME_MESH)
        return best if best and best.overlap >= least else None

    @property
    def _has_meshes(self) -> bool:
        """True if collision and visual are meshes, so that their outlines should be equal."""
        return _is_mesh(self.collision) and _is_mesh(self.visual)

    @staticmethod
    def _turns(bodies: tuple[Body, ...], a: LinkSolid, b: LinkSolid) -> Iterator[QuarterTurn]:
        for body in bodies if len(bodies) == 1 else ():
            frame = body.origin
            for quarter in QUARTERS:
                turned = frame @ Transform(quarter)
                box = a.bounds.moved(turned @ frame.inverse)
                yield QuarterTurn(body, to_rpy(turned.rotation), _overlap(box, b.bounds))

    @property
    def is_apart(self) -> bool:
        """True if they hardly overlap, and are not merely simplified.

        Legs often have the cylinder of the motor next to the hip as its collision, intentionally.
        The same shape at another position is a mistake, and so is a distance larger than the
        shapes.
        """
        if self.overlap >= LEAST_OVERLAP or self.is_nested or self._coincides or self._encloses_one:
            return False
        if not (_is_mesh(self.collision) or _is_mesh(self.visual)) or self.has_one_shape:
            return True
        collision, visual = self.collision.bounds, self.visual.bounds
        concentric = visual.moved(Transform(position=minus(collision.center, visual.center)))
        if _overlap(collision, concentric) >= SAME_OVERLAP or self.mirrored_axis:
            return True
        return collision.gap(visual) > max(*collision.edges, *visual.edges)

    @cached_property
    def mirrored_axis(self) -> str:
        """The coordinate of the collision's origin whose other sign leads into the visual."""
        collision, visual = self.collision.bounds, self.visual.bounds
        volume = collision.volume
        if len(self.link.collisions) > 1 or collision.common_volume(visual) > OUTSIDE * volume:
            return ""
        for axis, unit, value in zip(
            "xyz", AXES, self.link.collisions[0].origin.position, strict=True
        ):
            turned = collision.moved(Transform(position=times(unit, -2 * value)))
            if turned.common_volume(visual) >= NESTED * volume:
                return axis
        return ""

    @property
    def _encloses_one(self) -> bool:
        """True if the collision is around one of several visuals: an antenna without its mast."""
        outer = self.collision.bounds
        near = CONCENTRIC * max(outer.edges)
        parts = self.visual.parts if len(self.visual.parts) > 1 else ()
        return any(
            length(minus(inner.center, outer.center)) <= near
            and inner.volume >= LEAST_PART * outer.volume
            and outer.common_volume(inner) >= NESTED * inner.volume
            for inner in (LinkSolid((part,)).bounds for part in parts)
        )

    @property
    def _coincides(self) -> bool:
        """True if both boxes have the same corners, as two sheets on one another."""
        corners = zip(self.visual.bounds, self.collision.bounds, strict=True)
        return all(length(minus(corner, opposite)) <= TOLERANCE for corner, opposite in corners)

    @property
    def has_one_shape(self) -> bool:
        """True if collision and visual are the same shape, at any pose."""
        if len(self.link.collisions) != 1 or len(self.link.visuals) != 1:
            return False
        a, b = self.link.collisions[0].shape, self.link.visuals[0].shape
        return a is not None and b is not None and _geometry(a) == _geometry(b)

    def unusual(self, span: float) -> Body:
        """The first visual or collision, whichever differs more from the size of the robot.

        Args:
            span: the longest distance between consecutive joints, in m.
        """
        visual, collision = self.link.visuals[0], self.link.collisions[0]
        if span <= 0:
            return visual
        of_visual, of_collision = (
            abs(log(max(solid.bounds.edges) / span)) for solid in (self.visual, self.collision)
        )
        return visual if of_visual >= of_collision else collision


def _quarters() -> Iterator[Rotation]:
    """The 23 rotations that map a cube onto itself, the smaller ones first."""
    rotations = []
    for (a, b), (s, t) in product(permutations(AXES, 2), product((1, -1), repeat=2)):
        x, y = (s * a[0], s * a[1], s * a[2]), (t * b[0], t * b[1], t * b[2])
        rotations.append((x, y, cross(x, y)))
    rotations.sort(key=lambda r: -(r[0][0] + r[1][1] + r[2][2]))
    yield from rotations[1:]


#: All rotations by multiples of right angles, without the identity.
QUARTERS: tuple[Rotation, ...] = tuple(_quarters())


def _overlap(a: BoundingBox, b: BoundingBox) -> float:
    """Common volume of two boxes by the volume of their union."""
    common = a.common_volume(b)
    both = a.volume + b.volume - common
    return common / both if both > 0 else 0.0


def _is_mesh(solid: LinkSolid) -> bool:
    return any(isinstance(part, MeshSolid) for part in solid.parts)


def _is_cube(edges: Vector) -> bool:
    return max(edges) < CUBE * min(edges)


def _geometry(shape: Shape) -> tuple[object, ...]:
    name = shape.filename.value if shape.filename else ""
    return (shape.kind, shape.size, shape.radius, shape.length, name, shape.scale)
