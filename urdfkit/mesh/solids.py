"""Solids to build parts from: boxes, cylinders, revolved profiles, and their booleans.

Lengths in m. All solids come from manifold3d, so they are closed and oriented.
"""

from collections.abc import Iterable, Sequence

import numpy as np
from manifold3d import CrossSection, JoinType, Manifold, OpType

from urdfkit.core.grouping import by_key
from urdfkit.core.spatial import Vector
from urdfkit.mesh.convex_hull import arrays_of
from urdfkit.mesh.geometry import Floats, Mesh, MeshMaterial, MeshPart
from urdfkit.mesh.normals import shaded

#: Sides of a circle: visually round, and few enough for a simulator.
SIDES = 48

#: Decimals of a coordinate in m: far below what is visible, far above the rounding of sums.
_DECIMALS = 8
#: A common volume below this part of the solid is not an overlap.
_MIN_OVERLAP = 1e-6
#: Thickness in m below which a feature is an artefact of booleans.
_SLIVER = 1e-6

Point = tuple[float, float]

#: A material and the solid that has it.
Coloured = tuple[MeshMaterial, Manifold]


def disjoint(solids: Iterable[Coloured]) -> list[Coloured]:
    """The solids without their overlaps, which stay in the earlier solid."""
    result: list[Coloured] = []
    for material, solid in solids:
        rest = solid
        for _, earlier in result:
            # Solids that only touch are unchanged: a boolean would leave a film of no thickness.
            if (rest ^ earlier).volume() > _MIN_OVERLAP * rest.volume():
                rest = rest - earlier
        if rest.volume() > 0:
            result.append((material, rest))
    return result


def assembled(solids: Iterable[Coloured]) -> Mesh:
    """A mesh of the disjoint solids, one part for each material, with normals."""
    by_material = by_key(disjoint(solids))
    # Booleans leave slivers, which simplification removes.
    unions = (Manifold.batch_boolean(group, OpType.Add) for group in by_material.values())
    parts = zip((union.simplify(_SLIVER) for union in unions), by_material, strict=True)
    return Mesh(tuple(shaded(_part(*part)) for part in parts), up_axis="Z_UP")


def subtract_mesh(pieces: Mesh, mesh: Mesh) -> Mesh:
    """The part of some solids that lies outside of the solids of a mesh.

    Args:
        pieces: each part a solid; they may overlap.
        mesh: components that are not solids are ignored.
    """
    from urdfkit.mesh.components import split_pieces
    from urdfkit.mesh.edges import Edges, have_distinct_corners
    from urdfkit.mesh.manifolds import solid
    from urdfkit.mesh.overlap import bodies
    from urdfkit.mesh.welding import weld

    rest = Manifold.batch_boolean(
        [solid(part.vertices, part.faces) for part in pieces.parts], OpType.Add
    )
    # A part may be a separate solid that touches others, or one colour of a larger solid.
    for group in (mesh, *(mesh._replace(parts=(part,)) for part in mesh.parts)):
        places, faces = weld(group.vertices, group.faces)
        edges = Edges(faces[have_distinct_corners(faces)])
        for body in bodies(places, edges.faces, split_pieces(places, edges)):
            rest = rest - body
    return as_mesh(rest)


def as_mesh(solid: Manifold) -> Mesh:
    """A solid as a mesh of one part, without normals."""
    return Mesh((_part(solid),), up_axis="Z_UP")


def _part(solid: Manifold, material: MeshMaterial | None = None) -> MeshPart:
    return MeshPart(*arrays_of(solid), material)


def on_grid(solid: Manifold) -> Manifold:
    """A solid with its vertices rounded to a grid.

    Faces in one plane are then exactly coplanar, so that a boolean joins them; a distance of one
    nanometre would remain as a gap.
    """
    return solid.warp_batch(_rounded)


def _rounded(values: Floats) -> Floats:
    return np.asarray(np.round(values, _DECIMALS))


def _section(outline: Sequence[Point]) -> CrossSection:
    """A polygon, rounded first, because manifold3d stores polygons with a few digits only."""
    return CrossSection([_rounded(np.asarray(outline, dtype=float))])


def box(size: Vector) -> Manifold:
    """A box along the axes, centred at the origin."""
    return on_grid(Manifold.cube(size, True))


def rounded_box(size: Vector, radius: float, chamfer: float = 0.0) -> Manifold:
    """A box, centred at the origin, whose edges along z are rounded.

    Args:
        size: outer edge lengths.
        radius: of the rounded edges.
        chamfer: bevel of the edges around bottom and top.
    """
    x, y, height = size
    plane = CrossSection.square((x - 2 * radius, y - 2 * radius), True)
    outline = plane.offset(radius, JoinType.Round, 2.0, 32)
    if chamfer <= 0:
        return on_grid(outline.extrude(height).translate((0, 0, -height / 2)))
    inner = plane.offset(max(radius - chamfer, 1e-6), JoinType.Round, 2.0, 32)
    middle = outline.extrude(height - 2 * chamfer).translate((0, 0, chamfer))
    return on_grid((middle + inner.extrude(height)).hull().translate((0, 0, -height / 2)))


def cylinder(radius: float, low: float, high: float, sides: int = SIDES) -> Manifold:
    """A cylinder along z, from ``low`` to ``high``."""
    return on_grid(Manifold.cylinder(high - low, radius, radius, sides).translate((0, 0, low)))


def revolved(profile: Sequence[Point], sides: int = SIDES) -> Manifold:
    """A solid of revolution about z.

    Args:
        profile: a closed polygon of (distance from z, height).
    """
    return on_grid(_section(profile).revolve(sides))


def extruded(outline: Sequence[Point], low: float, high: float) -> Manifold:
    """A polygon in x and y, extruded along z."""
    return on_grid(_section(outline).extrude(high - low).translate((0.0, 0.0, low)))


def ball(radius: float) -> Manifold:
    """A ball, centred at the origin."""
    return Manifold.sphere(radius, SIDES)
