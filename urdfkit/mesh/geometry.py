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
    """The appearance of a surface.

    Attributes:
        name: as the file calls it; may be empty.
        rgba: colour, each part from 0 to 1, as written (sRGB).
        texture: path of an image that is there, or its bytes, where the file holds it; None without
            one.
    """

    name: str = ""
    rgba: tuple[float, float, float, float] = (0.8, 0.8, 0.8, 1.0)
    texture: str | bytes | None = None


class MeshPart(Record):
    """Triangles of one material.

    Attributes:
        vertices: (n, 3), in the frame of the file, node transforms applied.
        faces: (m, 3), indices of vertices, counter-clockwise from outside.
        material: None where the file names none.
        normals: (n, 3), unit vectors; None where the file has none.
        uv: (n, 2), texture coordinates with v upwards; None where the file has none.
        colors: (n, 4), from 0 to 1, of the vertices; None where the file has none.
    """

    vertices: Floats
    faces: Integers
    material: MeshMaterial | None = None
    normals: Floats | None = None
    uv: Floats | None = None
    colors: Floats | None = None


class Mesh(Record):
    """What a mesh file holds.

    Attributes:
        parts: in the order of the file.
        unit: metres per unit of length, as the file says (COLLADA); 1 where it says nothing.
        up_axis: ``X_UP``, ``Y_UP`` or ``Z_UP``, as the file or its format (glTF) says; empty where
            neither says anything.
        losses: what is broken in the file and is therefore not in the parts, one sentence each.
        extras: what the file holds besides triangles, such as ``2 cameras``.
        textures: the names of images that its materials use, as written.
        missing: the names of images and of files of materials that it uses and that are not there.
        files: where the other files lie, or would, that it names: images, materials, numbers.
    """

    parts: tuple[MeshPart, ...]
    unit: float = 1.0
    up_axis: str = ""
    losses: tuple[str, ...] = ()
    extras: tuple[str, ...] = ()
    textures: tuple[str, ...] = ()
    missing: tuple[str, ...] = ()
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
