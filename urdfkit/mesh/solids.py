"""Solids to build parts from: boxes, cylinders, turned profiles, and their booleans.

Lengths in m. Everything comes from manifold3d, so every solid is closed and oriented.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, pi, sin

import numpy as np
from manifold3d import CrossSection, JoinType, Manifold, Mesh64, OpType

from urdfkit.core.spatial import Vector
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


class Assembly:
    """Solids of several materials that do not overlap: together they have one true volume."""

    def __init__(self) -> None:
        self.parts: list[tuple[MeshMaterial, Manifold]] = []

    def add(self, material: MeshMaterial, solid: Manifold) -> None:
        """Add a solid; where there is one already, that one stays."""
        for _, earlier in self.parts:
            # What only touches is left alone: a boolean would leave a film of no thickness.
            if (solid ^ earlier).volume() > _FILM * solid.volume():
                solid = solid - earlier
        if solid.volume() > 0:
            self.parts.append((material, solid))

    def mesh(self) -> Mesh:
        """The triangles, one part for each material, with normals."""
        together: dict[MeshMaterial, list[Manifold]] = {}
        for material, solid in self.parts:
            together.setdefault(material, []).append(solid)
        return Mesh(
            tuple(
                shaded(_part(_united(solids), material)) for material, solids in together.items()
            ),
            up_axis="Z_UP",
        )


def _united(solids: Sequence[Manifold]) -> Manifold:
    """Solids as one, without the slivers that booleans leave."""
    whole = Manifold.batch_boolean(solids, OpType.Add)
    return whole.simplify(_SLIVER)


def beyond(pieces: Mesh, mesh: Mesh) -> Mesh:
    """What of some solids lies outside of those that a mesh consists of.

    Args:
        pieces: each part a solid; they may overlap.
        mesh: any; what of it is no solid is passed over.
    """
    from urdfkit.mesh.components import take_apart
    from urdfkit.mesh.edges import Edges, three_cornered
    from urdfkit.mesh.overlap import bodies
    from urdfkit.mesh.welding import weld

    whole = Manifold.batch_boolean(
        [Manifold(Mesh64(part.vertices, part.faces.astype(np.uint64))) for part in pieces.parts],
        OpType.Add,
    )
    # A part may be a solid of its own that touches others, or one colour of a whole.
    for one in (mesh, *(mesh._replace(parts=(part,)) for part in mesh.parts)):
        places, faces = weld(one.vertices, one.faces)
        edges = Edges(faces[three_cornered(faces)])
        for body in bodies(places, edges.faces, take_apart(places, edges)):
            whole = whole - body
    return as_mesh(whole)


def as_mesh(solid: Manifold, material: MeshMaterial | None = None) -> Mesh:
    """A solid as a mesh of one part, without normals."""
    return Mesh((_part(solid, material),), up_axis="Z_UP")


def _part(solid: Manifold, material: MeshMaterial | None) -> MeshPart:
    mesh = solid.to_mesh64()
    vertices = np.asarray(mesh.vert_properties[:, :3], dtype=float)
    return MeshPart(vertices, np.asarray(mesh.tri_verts, dtype=np.int64), material)


def _on_grid(solid: Manifold) -> Manifold:
    """A solid with its vertices on a grid.

    Faces that are meant to lie in one plane then do, to the last bit, and a boolean joins them;
    a nanometre between them would stay as a gap.
    """
    return solid.warp_batch(_rounded)


def _rounded(values: Floats) -> Floats:
    return np.asarray(np.round(values, _DECIMALS))


def _section(outline: Sequence[Point]) -> CrossSection:
    """A polygon; on the grid beforehand, for polygons are kept with a few digits only."""
    return CrossSection([_rounded(np.asarray(outline, dtype=float))])


def box(size: Vector, center: Vector = (0.0, 0.0, 0.0)) -> Manifold:
    """A box along the axes."""
    return _on_grid(Manifold.cube(size, True).translate(center))


def rounded_box(size: Vector, center: Vector, radius: float, chamfer: float = 0.0) -> Manifold:
    """A box whose edges along z are rounded.

    Args:
        size: outer edges.
        center: of the box.
        radius: of those edges.
        chamfer: bevel of the edges around bottom and top.
    """
    x, y, height = size
    plane = CrossSection.square((x - 2 * radius, y - 2 * radius), True)
    outline = plane.offset(radius, JoinType.Round, 2.0, 32)
    if chamfer <= 0:
        return _on_grid(outline.extrude(height).translate((0, 0, -height / 2)).translate(center))
    inner = plane.offset(max(radius - chamfer, 1e-6), JoinType.Round, 2.0, 32)
    middle = outline.extrude(height - 2 * chamfer).translate((0, 0, chamfer))
    whole = (middle + inner.extrude(height)).hull().translate((0, 0, -height / 2))
    return _on_grid(whole.translate(center))


def cylinder(
    radius: float, low: float, high: float, center: Point = (0.0, 0.0), sides: int = SIDES
) -> Manifold:
    """A cylinder along z, from ``low`` to ``high``."""
    return _on_grid(Manifold.cylinder(high - low, radius, radius, sides).translate((*center, low)))


def revolved(profile: Sequence[Point], sides: int = SIDES) -> Manifold:
    """A turned part.

    Args:
        profile: a closed polygon of (distance from z, height).
        sides: of its circles.
    """
    return _on_grid(_section(profile).revolve(sides))


def extruded(outline: Sequence[Point], low: float, high: float) -> Manifold:
    """A polygon in x and y drawn out along z."""
    return _on_grid(_section(outline).extrude(high - low).translate((0.0, 0.0, low)))


def ball(radius: float, center: Vector, sides: int = SIDES) -> Manifold:
    """A ball."""
    return Manifold.sphere(radius, sides).translate(center)


def ring(count: int, radius: float, start: float = 0.0) -> list[Point]:
    """Places around a circle, evenly, as (x, y); ``start`` in rad."""
    angles = (start + 2 * pi * number / count for number in range(count))
    return [(radius * cos(angle), radius * sin(angle)) for angle in angles]
