"""Triangles of a mesh file."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from urdfkit.core.record import Record
from urdfkit.core.spatial import Vector

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
Flags = NDArray[np.bool_]


class NoTriangles(Exception):
    """A file without triangles; the text is a predicate whose subject is the file."""


class MeshMaterial(Record):
    """The appearance of a surface."""

    name: str = ""  # in the file; may be empty
    #: Colour, components from 0 to 1, as written (sRGB).
    rgba: tuple[float, float, float, float] = (0.8, 0.8, 0.8, 1.0)
    #: Path of an existing image, or the bytes of an embedded image; None without texture.
    texture: str | bytes | None = None


class MeshPart(Record):
    """Triangles of one material."""

    vertices: Floats  # (n, 3), in the frame of the file, node transforms applied
    faces: Integers  # (m, 3), indices of vertices, counter-clockwise from outside
    material: MeshMaterial | None = None  # None if the file defines none
    normals: Floats | None = None  # (n, 3), unit vectors; None if the file has none
    #: (n, 2), texture coordinates with v upwards; None if the file has none.
    uv: Floats | None = None
    #: (n, 4), vertex colours from 0 to 1; None if the file has none.
    colors: Floats | None = None


class Mesh(Record):
    """Contents of a mesh file."""

    parts: tuple[MeshPart, ...]  # in the order of the file
    #: Metres per unit of length in the file (COLLADA); 1 if not defined.
    unit: float = 1.0
    #: ``X_UP``, ``Y_UP`` or ``Z_UP``, defined by the file or its format (glTF); empty if undefined.
    up_axis: str = ""
    #: Broken elements of the file, which the parts omit, one sentence each.
    losses: tuple[str, ...] = ()
    extras: tuple[str, ...] = ()  # other contents of the file, such as ``2 cameras``
    textures: tuple[str, ...] = ()  # names of the images that its materials use, as written
    #: Names of referenced images and material files that do not exist.
    missing: tuple[str, ...] = ()
    #: Paths of all referenced files, existing or not: images, materials, buffers.
    files: tuple[str, ...] = ()

    @property
    def vertices(self) -> Floats:
        """(n, 3), vertices of all parts."""
        if not self.parts:
            return np.zeros((0, 3))
        return np.concatenate([part.vertices for part in self.parts])

    def scaled(self, factors: Vector) -> Floats:
        """(n, 3), scaled vertices of all parts; infinite on overflow."""
        with np.errstate(over="ignore", invalid="ignore"):
            return np.asarray(self.vertices * factors)

    @property
    def faces(self) -> Integers:
        """(m, 3), faces of all parts, as indices of `vertices`."""
        if not self.parts:
            return np.zeros((0, 3), dtype=np.int64)
        starts = np.cumsum([0, *(len(part.vertices) for part in self.parts[:-1])])
        return np.concatenate(
            [part.faces + start for part, start in zip(self.parts, starts, strict=True)]
        )


def scaled_normals(triangles: Floats) -> Floats:
    """(m, 3), normals of triangles (m, 3, 3), twice as long as the area; inf or nan on overflow."""
    a, b, c = triangles.swapaxes(0, 1)
    with np.errstate(over="ignore", invalid="ignore"):
        return np.asarray(np.cross(b - a, c - a))


def areas(vertices: Floats, faces: Integers) -> Floats:
    """(m,), area of each face; infinite or nan on overflow."""
    with np.errstate(over="ignore", invalid="ignore"):
        return np.asarray(np.linalg.norm(scaled_normals(vertices[faces]), axis=1) / 2)
