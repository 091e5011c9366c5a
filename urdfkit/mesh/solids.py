"""Solids to build parts from: boxes, cylinders, turned profiles, and their booleans.

Lengths in m. Everything comes from manifold3d, so every solid is closed and oriented.
"""

from collections.abc import Iterable, Sequence

import numpy as np
from manifold3d import CrossSection, JoinType, Manifold, OpType

from urdfkit.core.spatial import Vector
from urdfkit.mesh.convex_hull import arrays_of
from urdfkit.mesh.geometry import Floats, Mesh, MeshMaterial, MeshPart
from urdfkit.mesh.normals import shaded

#: Sides of a circle: round to the eye, and few enough for a simulator.
SIDES = 48

#: Of a coordinate in m: far below what is seen, and far above the rounding of sums.
_DECIMALS = 8
#: A common volume below this part of the whole is no overlap.
_FILM = 1e-6
#: Thinner than this, in m, is an accident of booleans.
_SLIVER = 1e-6

Point = tuple[float, float]


#: A solid and the material of its surface.
Coloured = tuple[MeshMaterial, Manifold]


def disjoint(solids: Iterable[Coloured]) -> list[Coloured]:
    """Solids that do not overlap, so that together they have one true volume.

    Where there is one already, that one stays.
    """
    found: list[Coloured] = []
    for material, solid in solids:
        left = solid
        for _, earlier in found:
            # What only touches is left alone: a boolean would leave a film of no thickness.
            if (left ^ earlier).volume() > _FILM * left.volume():
                left = left - earlier
        if left.volume() > 0:
            found.append((material, left))
    return found


def assembled(solids: Iterable[Coloured]) -> Mesh:
    """The triangles of disjoint solids, one part for each material, with normals."""
    by_material: dict[MeshMaterial, list[Manifold]] = {}
    for material, solid in disjoint(solids):
        by_material.setdefault(material, []).append(solid)
    # Booleans leave slivers.
    unions = (Manifold.batch_boolean(each, OpType.Add) for each in by_material.values())
    parts = zip((whole.simplify(_SLIVER) for whole in unions), by_material, strict=True)
    return Mesh(tuple(shaded(_part(*part)) for part in parts), up_axis="Z_UP")


def beyond(pieces: Mesh, mesh: Mesh) -> Mesh:
    """What of some solids lies outside of those that a mesh consists of.

    Args:
        pieces: each part a solid; they may overlap.
        mesh: any; components that are no solid are ignored.
    """
    from urdfkit.mesh.components import take_apart
    from urdfkit.mesh.edges import Edges, three_cornered
    from urdfkit.mesh.manifolds import solid
    from urdfkit.mesh.overlap import bodies
    from urdfkit.mesh.welding import weld

    whole = Manifold.batch_boolean(
        [solid(part.vertices, part.faces) for part in pieces.parts], OpType.Add
    )
    # A part may be a solid of its own that touches others, or one colour of a whole.
    for one in (mesh, *(mesh._replace(parts=(part,)) for part in mesh.parts)):
        places, faces = weld(one.vertices, one.faces)
        edges = Edges(faces[three_cornered(faces)])
        for body in bodies(places, edges.faces, take_apart(places, edges)):
            whole = whole - body
    return as_mesh(whole)


def as_mesh(solid: Manifold) -> Mesh:
    """A solid as a mesh of one part, without normals."""
    return Mesh((_part(solid),), up_axis="Z_UP")


def _part(solid: Manifold, material: MeshMaterial | None = None) -> MeshPart:
    return MeshPart(*arrays_of(solid), material)


def on_grid(solid: Manifold) -> Manifold:
    """A solid with its vertices on a grid.

    Faces of one plane are then exactly coplanar, and a boolean joins them;
    a nanometre between them would stay as a gap.
    """
    return solid.warp_batch(_rounded)


def _rounded(values: Floats) -> Floats:
    return np.asarray(np.round(values, _DECIMALS))


def _section(outline: Sequence[Point]) -> CrossSection:
    """A polygon; on the grid beforehand, for polygons are kept with a few digits only."""
    return CrossSection([_rounded(np.asarray(outline, dtype=float))])


def box(size: Vector) -> Manifold:
    """A box along the axes, about its middle."""
    return on_grid(Manifold.cube(size, True))


def rounded_box(size: Vector, radius: float, chamfer: float = 0.0) -> Manifold:
    """A box about its middle whose edges along z are rounded.

    Args:
        size: outer edges.
        radius: of those edges.
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
    """A turned part.

    Args:
        profile: a closed polygon of (distance from z, height).
    """
    return on_grid(_section(profile).revolve(sides))


def extruded(outline: Sequence[Point], low: float, high: float) -> Manifold:
    """A polygon in x and y drawn out along z."""
    return on_grid(_section(outline).extrude(high - low).translate((0.0, 0.0, low)))


def ball(radius: float) -> Manifold:
    """A ball about the origin."""
    return Manifold.sphere(radius, SIDES)
