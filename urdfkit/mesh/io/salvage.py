"""What is left of a broken mesh file, and how much of it that is."""

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
    """The readable rest of a damaged file."""

    mesh: Mesh  # the triangles
    declared: int  # how many the file says that it has; 0 where it does not say

    @property
    def found(self) -> int:
        """How many triangles are left."""
        return len(self.mesh.faces)

    @property
    def share(self) -> float:
        """The part that is left, from 0 to 1, as far as the file says."""
        return min(1.0, self.found / self.declared) if self.declared else 1.0

    def __str__(self) -> str:
        """Such as ``6 of 12 triangles``."""
        if self.declared > self.found:
            return f"{self.found} of {self.declared} triangles"
        return f"{self.found} triangles"


def salvage(path: str) -> SalvagedPart | None:
    """The triangles that are left in a mesh file; None if there are none.

    Args:
        path: of a file that is cut off or malformed.
    """
    try:
        mesh = load.salvage(path)
        data = load.read_bytes(path)
    except UnloadableMesh:
        return None
    form = sniff(data, os.path.splitext(path)[1]).format
    return SalvagedPart(mesh, _declared(data, form)) if len(mesh.faces) else None


def _declared(data: bytes, form: str) -> int:
    """The number of triangles that a file announces; a lower bound where it counts polygons."""
    if form == facts.COLLADA:
        return sum(int(count) for count in _COUNT.findall(data))
    if form == facts.BINARY_STL:
        return (binary_stl.whole_size(data) - binary_stl.HEADER) // binary_stl.TRIANGLE
    return 0


def load_or_salvage(path: str) -> tuple[Mesh, str]:
    """The triangles of a mesh file, whole or broken.

    Returns:
        The mesh, and what is wrong with the file; empty if it is whole.

    Raises:
        UnloadableMesh: there are none.
    """
    try:
        return load.load(path), ""
    except UnloadableMesh as error:
        left = salvage(path)
        if left is None:
            raise
        return left.mesh, f"{error.reason}; {left} are left"
