"""Reading of STL files.

Normals are ignored: the order of the corners defines them, and many programs write zeros.
"""

import re

import numpy as np

from urdfkit.core.words import counted
from urdfkit.mesh.geometry import Floats, Mesh
from urdfkit.mesh.io import binary_stl
from urdfkit.mesh.io.assemble import LostData, Stream, assemble, mesh_of
from urdfkit.mesh.io.numbers import floats

_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("colour", "<u2")])
_VERTEX = re.compile(rb"\svertex\s+(\S+)\s+(\S+)\s+(\S+)")


def binary(data: bytes) -> Mesh:
    """The complete triangles of a binary STL file.

    Raises:
        NoTriangles: the file has none.
    """
    declared = int.from_bytes(data[80 : binary_stl.HEADER], "little")
    number = max(len(data) - binary_stl.HEADER, 0) // binary_stl.TRIANGLE
    table = np.frombuffer(data, _TRIANGLE, number, binary_stl.HEADER if number else 0)
    losses = LostData()
    losses.add("declared triangle* missing from the file", max(declared - number, 0))
    extras: tuple[str, ...] = ()
    coloured = np.count_nonzero(table["colour"] & 0x8000) if number else 0
    if coloured:
        extras = (f"colours of {counted(int(coloured), 'triangle')}",)
    with np.errstate(invalid="ignore"):  # for values that are not finite
        corners = table["corners"].reshape(-1, 3).astype(np.float64)
    return _mesh(corners, losses, extras)


def ascii_text(data: bytes) -> Mesh:
    """The triangles of an ASCII STL file.

    Raises:
        NoTriangles: the file has none.
    """
    text = data.lower()
    # The solid's name, in the first and the last line, may contain "vertex", too.
    facets = text[text.find(b"facet") : text.rfind(b"endfacet")]
    words = b" ".join(word for corner in _VERTEX.findall(facets) for word in corner)
    numbers = floats(words.decode("latin-1"))
    whole = len(numbers) // 9 * 9
    losses = LostData()
    losses.add("number* of an incomplete triangle", len(numbers) - whole)
    return _mesh(numbers[:whole].reshape(-1, 3), losses)


def _mesh(corners: Floats, losses: LostData, extras: tuple[str, ...] = ()) -> Mesh:
    index = np.arange(len(corners)).reshape(-1, 3)
    return mesh_of([assemble(Stream(corners, index), losses)], losses)._replace(extras=extras)
