"""Description of a mesh file, for people and programs."""

from __future__ import annotations

from typing import Any

from urdfkit.core.record import Record
from urdfkit.core.spatial import Vector, vector
from urdfkit.mesh.geometry import Mesh, areas
from urdfkit.mesh.health import Health, examine_mesh
from urdfkit.mesh.io.salvage import load_or_salvage
from urdfkit.mesh.io.sniff import sniff_file
from urdfkit.mesh.transforms import in_metres


class MeshDescription(Record):
    """Contents and state of a mesh file."""

    path: str
    format: str  # by content
    bytes: int  # file size
    defect: str  # defect of the file; empty if it is intact
    mesh: Mesh  # in the unit of the file
    #: low and high: corners of the bounding box in m.
    low: Vector
    high: Vector
    health: Health  # of the triangles, in m
    area: float  # of the surface in m^2

    def as_json(self) -> dict[str, Any]:
        return {
            "path": self.path,
            "format": self.format,
            "bytes": self.bytes,
            "defect": self.defect,
            "unit": self.mesh.unit,
            "up_axis": self.mesh.up_axis,
            "losses": list(self.mesh.losses),
            "parts": [
                {
                    "triangles": len(part.faces),
                    "material": part.material.name if part.material else None,
                    "rgba": list(part.material.rgba) if part.material else None,
                    "texture": bool(part.material and part.material.texture),
                }
                for part in self.mesh.parts
            ],
            "low": list(self.low),
            "high": list(self.high),
            "area": self.area,
            "solid": self.health.is_solid,
            **self.health._asdict(),
        }


def describe(path: str) -> MeshDescription:
    """Describe a mesh file.

    Raises:
        UnloadableMesh: the file has no triangles.
    """
    mesh, defect = load_or_salvage(path)
    facts = sniff_file(path)
    metric = in_metres(mesh)
    vertices, faces = metric.vertices, metric.faces
    used = vertices[faces.reshape(-1)]
    return MeshDescription(
        path,
        facts.format,
        facts.size,
        defect,
        mesh,
        vector(used.min(axis=0)),
        vector(used.max(axis=0)),
        examine_mesh(metric),
        float(areas(vertices, faces).sum()),
    )
