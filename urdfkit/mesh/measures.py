"""What is known of the triangles of a mesh, as numbers that fit into a small file.

Lengths in the unit of the file. Nothing here needs numpy: measures come from the cache.
"""

from __future__ import annotations

from typing import Any

from urdfkit.core.record import Record
from urdfkit.core.spatial import Vector

#: The part of a volume that counts more than once, above which masses computed from it are off.
OVERLAP = 0.05


class Uniform(Record):
    """A solid of density 1.

    Attributes:
        volume: cubic; more than 0.
        center: of mass.
        tensor: ixx, ixy, ixz, iyy, iyz, izz about the centre of mass.
    """

    volume: float
    center: Vector
    tensor: tuple[float, float, float, float, float, float]


class Measures(Record):
    """The measures of a mesh; corners at the same place are one vertex.

    Attributes:
        triangles, vertices: how many there are.
        low, high: the corners of the bounding box.
        area: of all triangles.
        solid: what the surface encloses; None unless it is closed and encloses something.
        hull: of the convex hull; None where all vertices lie in a plane.
        points: extreme vertices; the mesh reaches hardly farther in any direction than they.
        inside_out: True if the surface is closed and its triangles look inwards.
        open_edges: edges with an odd number of triangles.
        flipped_edges: edges whose triangles do not look the same way.
        degenerate: triangles without area.
        bodies: connected components.
        overlap: of a closed surface, the volume that lies in several of them at once and is counted
            as often in ``solid``, as a part of the true volume.
        inverted_bodies: closed pieces that look inwards, lie in no other one, and are no trifle.
        unit, up_axis, losses, extras, textures: as in `urdfkit.mesh.geometry.Mesh`.
        no_materials: the files of materials that it names and that are not there.
    """

    triangles: int
    vertices: int
    low: Vector
    high: Vector
    area: float
    solid: Uniform | None
    hull: Uniform | None
    points: tuple[Vector, ...]
    inside_out: bool
    open_edges: int
    flipped_edges: int
    degenerate: int
    bodies: int
    overlap: float
    inverted_bodies: int
    unit: float = 1.0
    up_axis: str = ""
    losses: tuple[str, ...] = ()
    extras: tuple[str, ...] = ()
    textures: tuple[str, ...] = ()
    no_materials: tuple[str, ...] = ()

    @property
    def is_closed(self) -> bool:
        """True if the surface has no edge and one outside."""
        return not self.open_edges and not self.flipped_edges

    @property
    def edges(self) -> Vector:
        """Of the bounding box."""
        x, y, z = (high - low for low, high in zip(self.low, self.high, strict=True))
        return (x, y, z)

    @property
    def diagonal(self) -> float:
        """Of the bounding box."""
        return float(sum(edge * edge for edge in self.edges) ** 0.5)


def to_json(measures: Measures) -> dict[str, Any]:
    """As what the module json writes."""
    content = measures._asdict()
    for key in ("solid", "hull"):
        if content[key] is not None:
            content[key] = content[key]._asdict()
    return content


def from_json(content: dict[str, Any]) -> Measures:
    """From what `to_json` gave.

    Raises:
        KeyError, TypeError, ValueError: it is something else.
    """
    values = {key: _frozen(value) for key, value in content.items()}
    for key in ("solid", "hull"):
        if content[key] is not None:
            values[key] = Uniform(**{name: _frozen(value) for name, value in content[key].items()})
    return Measures(**values)


def _frozen(value: Any) -> Any:
    return tuple(map(_frozen, value)) if isinstance(value, list) else value
