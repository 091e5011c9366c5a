"""Triangles, as a mesh file gives them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from urdfkit.core.record import Record
from urdfkit.core.spatial import Vector

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
Flags = NDArray[np.bool_]


class NoTriangles(Exception):
    """A file gives no triangles; the text is a predicate whose subject is the file."""


class MeshMaterial(Record):
    """The appearance of a surface."""

    name: str = ""  # as the file calls it; may be empty
    #: Colour, each part from 0 to 1, as written (sRGB).
    rgba: tuple[float, float, float, float] = (0.8, 0.8, 0.8, 1.0)
    #: Path of an image that is there, or its bytes, where the file holds it; None without one.
    texture: str | bytes | None = None


class MeshPart(Record):
    """Triangles of one material."""

    vertices: Floats  # (n, 3), in the frame of the file, node transforms applied
    faces: Integers  # (m, 3), indices of vertices, counter-clockwise from outside
    material: MeshMaterial | None = None  # None where the file names none
    normals: Floats | None = None  # (n, 3), unit vectors; None where the file has none
    #: (n, 2), texture coordinates with v upwards; None where the file has none.
    uv: Floats | None = None
    #: (n, 4), from 0 to 1, of the vertices; None where the file has none.
    colors: Floats | None = None


class Mesh(Record):
    """What a mesh file holds."""

    parts: tuple[MeshPart, ...]  # in the order of the file
    #: Metres per unit of length, as the file says (COLLADA); 1 where it says nothing.
    unit: float = 1.0
    #: ``X_UP``, ``Y_UP`` or ``Z_UP``, as the file or its format (glTF) says; empty where neither
    #: says anything.
    up_axis: str = ""
    #: What is broken in the file and is therefore not in the parts, one sentence each.
    losses: tuple[str, ...] = ()
    extras: tuple[str, ...] = ()  # what the file holds besides triangles, such as ``2 cameras``
    textures: tuple[str, ...] = ()  # the names of images that its materials use, as written
    #: The names of images and of files of materials that it uses and that are not there.
    missing: tuple[str, ...] = ()
    #: Where the other files lie, or would, that it names: images, materials, numbers.
    files: tuple[str, ...] = ()

    @property
    def vertices(self) -> Floats:
        """(n, 3), of all parts."""
        if not self.parts:
            return np.zeros((0, 3))
        return np.concatenate([part.vertices for part in self.parts])

    def scaled(self, factors: Vector) -> Floats:
        """(n, 3), the vertices of all parts scaled; infinite where no number is so large."""
        with np.errstate(over="ignore", invalid="ignore"):
            found: Floats = self.vertices * factors
        return found

    @property
    def faces(self) -> Integers:
        """(m, 3), of all parts, as indices of `vertices`."""
        if not self.parts:
            return np.zeros((0, 3), dtype=np.int64)
        starts = np.cumsum([0, *(len(part.vertices) for part in self.parts[:-1])])
        return np.concatenate(
            [part.faces + start for part, start in zip(self.parts, starts, strict=True)]
        )


def areas(vertices: Floats, faces: Integers) -> Floats:
    """(m,), of each face; infinite or nan where no number is so large."""
    a, b, c = (vertices[faces[:, corner]] for corner in range(3))
    with np.errstate(over="ignore", invalid="ignore"):
        return np.asarray(np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2)
