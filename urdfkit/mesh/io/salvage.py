"""Recovery of the triangles of a broken mesh file."""

from __future__ import annotations

import os
import re

from urdfkit.core.record import Record
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.io import binary_stl, facts, load
from urdfkit.mesh.io.load import UnloadableMesh
from urdfkit.mesh.io.sniff import sniff

_COUNT = re.compile(rb"""<(?:triangles|polylist|polygons)\s[^<>]*?\bcount\s*=\s*["']\s*(\d{1,9})""")


class SalvagedPart(Record):
    """The readable part of a damaged file."""

    mesh: Mesh
    declared: int  # number of triangles that the file declares; 0 if unknown

    @property
    def found(self) -> int:
        """Number of readable triangles."""
        return len(self.mesh.faces)

    @property
    def share(self) -> float:
        """The readable part of the declared triangles, from 0 to 1."""
        return min(1.0, self.found / self.declared) if self.declared else 1.0

    def __str__(self) -> str:
        """Such as ``6 of 12 triangles``."""
        if self.declared > self.found:
            return f"{self.found} of {self.declared} triangles"
        return f"{self.found} triangles"


def salvage(path: str) -> SalvagedPart | None:
    """The readable triangles of a truncated or malformed mesh file; None if there are none."""
    try:
        mesh = load.salvage(path)
        data = load.read_bytes(path)
    except UnloadableMesh:
        return None
    form = sniff(data, os.path.splitext(path)[1]).format
    return SalvagedPart(mesh, _declared(data, form)) if len(mesh.faces) else None


def _declared(data: bytes, form: str) -> int:
    """The number of triangles that a file declares; a lower bound if it counts polygons."""
    if form == facts.COLLADA:
        return sum(int(count) for count in _COUNT.findall(data))
    if form == facts.BINARY_STL:
        return (binary_stl.whole_size(data) - binary_stl.HEADER) // binary_stl.TRIANGLE
    return 0


def load_or_salvage(path: str) -> tuple[Mesh, str]:
    """The triangles of an intact or broken mesh file.

    Returns:
        The mesh and the defect of the file; empty if it is intact.

    Raises:
        UnloadableMesh: no triangles are readable.
    """
    try:
        return load.load(path), ""
    except UnloadableMesh as error:
        part = salvage(path)
        if part is None:
            raise
        return part.mesh, f"{error.reason}; {part} are readable"
