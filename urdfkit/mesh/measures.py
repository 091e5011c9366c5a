"""What is known of the triangles of a mesh, as numbers that fit into a small file.

Lengths in the unit of the file. Nothing here needs numpy: measures come from the cache.
"""

from __future__ import annotations

from urdfkit.core.record import Record, frozen
from urdfkit.core.spatial import Vector
from urdfkit.core.static_typing import Any

#: The part of a volume that counts more than once, above which masses computed from it are off.
OVERLAP = 0.05


class Uniform(Record):
    """Mass properties of a solid of density 1."""

    volume: float  # cubic; more than 0
    center: Vector  # of mass
    #: ixx, ixy, ixz, iyy, iyz, izz about the centre of mass.
    tensor: tuple[float, float, float, float, float, float]


class Measures(Record):
    """The measures of a mesh; corners at the same place are one vertex."""

    #: triangles and vertices: how many there are.
    triangles: int
    vertices: int
    #: low and high: the corners of the bounding box.
    low: Vector
    high: Vector
    area: float  # of all triangles
    #: What the surface encloses; None unless it is closed and encloses something.
    solid: Uniform | None
    hull: Uniform | None  # of the convex hull; None where all vertices lie in a plane
    #: Extreme vertices; the mesh reaches hardly farther in any direction than they.
    points: tuple[Vector, ...]
    inside_out: bool  # True if the surface is closed and its triangles look inwards
    open_edges: int  # edges with an odd number of triangles
    flipped_edges: int  # edges whose two triangles have opposite orientation
    degenerate: int  # triangles without area
    bodies: int  # connected components
    #: Of a closed surface, the volume that lies in several of them at once and is counted as often
    #: in ``solid``, as a part of the true volume.
    overlap: float
    inverted_bodies: int  # closed pieces that look inwards, lie in no other one, and are no trifle
    #: unit, up_axis, losses, extras, textures: as in `urdfkit.mesh.geometry.Mesh`.
    unit: float = 1.0
    up_axis: str = ""
    losses: tuple[str, ...] = ()
    extras: tuple[str, ...] = ()
    textures: tuple[str, ...] = ()
    #: The files of materials that it names and that are not there.
    no_materials: tuple[str, ...] = ()

    @property
    def is_closed(self) -> bool:
        """True if the surface has no edge and one outside."""
        return not self.open_edges and not self.flipped_edges

    @property
    def edges(self) -> Vector:
        """Edge lengths of the bounding box."""
        x, y, z = (high - low for low, high in zip(self.low, self.high, strict=True))
        return (x, y, z)

    @property
    def diagonal(self) -> float:
        """Length of the diagonal of the bounding box."""
        return float(sum(edge * edge for edge in self.edges) ** 0.5)


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
        KeyError, TypeError, ValueError: it is something else.
    """
    values = {key: frozen(value) for key, value in content.items()}
    for key in ("solid", "hull"):
        if content[key] is not None:
            values[key] = Uniform(**{name: frozen(value) for name, value in content[key].items()})
    return Measures(**values)
