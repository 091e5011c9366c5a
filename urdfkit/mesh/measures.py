"""Measures of the triangles of a mesh, as numbers that fit into a small file.

Lengths in the unit of the file. This module does not need numpy: measures come from the cache.
"""

from __future__ import annotations

from urdfkit.core.record import Record, frozen
from urdfkit.core.spatial import Vector
from urdfkit.core.static_typing import Any

#: Overlapping part of a volume above which masses computed from the volume are wrong.
OVERLAP = 0.05


class Uniform(Record):
    """Mass properties of a solid of density 1."""

    volume: float  # cubic; more than 0
    center: Vector  # of mass
    #: ixx, ixy, ixz, iyy, iyz, izz about the centre of mass.
    tensor: tuple[float, float, float, float, float, float]


class Measures(Record):
    """The measures of a mesh; corners at the same place are one vertex."""

    triangles: int  # number of triangles
    vertices: int  # number of vertices
    #: low and high: corners of the bounding box.
    low: Vector
    high: Vector
    area: float  # of all triangles
    #: The enclosed solid; None unless the surface is closed and encloses a volume.
    solid: Uniform | None
    hull: Uniform | None  # of the convex hull; None if all vertices lie in a plane
    #: Extreme vertices; the mesh extends hardly farther than them in any direction.
    points: tuple[Vector, ...]
    inside_out: bool  # True if the surface is closed and its triangles face inwards
    open_edges: int  # edges with an odd number of triangles
    flipped_edges: int  # edges whose two triangles have opposite orientation
    degenerate: int  # triangles without area
    bodies: int  # connected components
    #: Volume inside several closed surfaces at once, counted as often in ``solid``, as a part of
    #: the true volume; 0 also if it is certainly less than ``OVERLAP``.
    overlap: float
    inverted_bodies: int  # significant closed pieces that face inwards and lie in no other piece
    #: unit, up_axis, losses, extras, textures: as in `urdfkit.mesh.geometry.Mesh`.
    unit: float = 1.0
    up_axis: str = ""
    losses: tuple[str, ...] = ()
    extras: tuple[str, ...] = ()
    textures: tuple[str, ...] = ()
    #: Referenced material files that do not exist.
    no_materials: tuple[str, ...] = ()

    @property
    def is_closed(self) -> bool:
        """True if the surface has no boundary and is consistently oriented."""
        return not self.open_edges and not self.flipped_edges

    @property
    def edges(self) -> Vector:
        """Edge lengths of the bounding box."""
        x, y, z = (high - low for low, high in zip(self.low, self.high, strict=True))
        return (x, y, z)


def to_json(measures: Measures) -> dict[str, Any]:
    """Measures as lists and dictionaries that ``json`` can write."""
    content = measures._asdict()
    for key in ("solid", "hull"):
        if content[key] is not None:
            content[key] = content[key]._asdict()
    return content


def from_json(content: dict[str, Any]) -> Measures:
    """Measures from the result of `to_json`.

    Raises:
        KeyError, TypeError, ValueError: the content has another form.
    """
    values = {key: frozen(value) for key, value in content.items()}
    for key in ("solid", "hull"):
        if content[key] is not None:
            values[key] = Uniform(**{name: frozen(value) for name, value in content[key].items()})
    return Measures(**values)
