"""The lists of numbers in a glTF file: accessors of buffer views.

Source: glTF 2.0 Specification, chapter "Binary Data Storage",
https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html#binary-data-storage.
"""

from __future__ import annotations

from base64 import b64decode
from typing import Any
from urllib.parse import unquote, unquote_to_bytes

import numpy as np
from numpy.typing import NDArray

from urdfkit.mesh.geometry import Floats, Integers, NoTriangles
from urdfkit.mesh.io.facts import MAX_BYTES
from urdfkit.mesh.io.gltf_tree import GltfObject
from urdfkit.mesh.io.referenced_files import ReferencedFiles

#: Rows of a list of zeros that a sparse one changes: no byte of it need be in the file.
MAX_ZEROS = 1_000_000

_TYPES = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}

_Numbers = NDArray[Any]


class Accessors:
    """The lists of one file.

    Args:
        root: its JSON.
        binary: the binary chunk of a GLB; empty if there is none.
        files: reads the buffers that are files.
    """

    def __init__(self, root: GltfObject, binary: bytes, files: ReferencedFiles) -> None:
        self._root = root
        self._binary = binary
        self._files = files
        self._buffers: dict[int, bytes] = {}

    def floats(self, index: int) -> Floats:
        """(n, k), a list of vectors; normalised whole numbers lie between -1 or 0 and 1.

        Raises:
            NoTriangles: it is not in the file; so do the functions below.
        """
        accessor = self._root.one_of("accessors", index)
        found = self._numbers(accessor)
        if not accessor.flag("normalized") or found.dtype.kind == "f":
            return found.astype(np.float64)
        fractions: Floats = np.maximum(found / float(np.iinfo(found.dtype).max), -1.0)
        return fractions

    def indices(self, index: int) -> Integers:
        """(n,), a list of whole numbers."""
        accessor = self._root.one_of("accessors", index)
        found = self._numbers(accessor)
        if found.dtype.kind == "f":
            raise NoTriangles(f"is no valid glTF: {accessor.name} counts in fractions")
        return found[:, 0].astype(np.int64)

    def view(self, index: int) -> memoryview:
        """The bytes that a view shows."""
        view = self._root.one_of("bufferViews", index)
        data = self._buffer(view.whole("buffer"))
        start, length = view.whole("byteOffset", 0), view.whole("byteLength")
        if start + length > len(data):
            missing = start + length - len(data)
            raise NoTriangles(f"lacks {missing} bytes of {view.name}")
        return memoryview(data)[start : start + length]

    def _numbers(self, accessor: GltfObject) -> _Numbers:
        """(n, k), as they are stored, with the rows that a sparse list replaces."""
        count = accessor.whole("count")
        kind, width = _type(accessor), _WIDTHS.get(accessor.text("type"), 0)
        if not width:
            raise NoTriangles(f"is no valid glTF: {accessor.name} is no list of vectors")
        if "bufferView" in accessor:
            found = self._table(accessor, kind, count, width)
        elif "sparse" in accessor and count <= MAX_ZEROS:
            found = np.zeros((count, width), kind)
        else:
            raise NoTriangles(f"declares {count} rows of {accessor.name} and holds none")
        return self._replaced(found, accessor.inner("sparse")) if "sparse" in accessor else found

    def _replaced(self, found: _Numbers, sparse: GltfObject) -> _Numbers:
        """A list with the rows that a sparse one changes."""
        places, values = sparse.inner("indices"), sparse.inner("values")
        changed = sparse.whole("count")
        rows = self._table(places, _type(places), changed, 1)[:, 0].astype(np.int64)
        if not ((rows >= 0) & (rows < len(found))).all():
            raise NoTriangles(f"is no valid glTF: {places.name} names rows that are not there")
        found = found.copy()
        found[rows] = self._table(values, found.dtype, changed, found.shape[1])
        return found

    def _table(self, owner: GltfObject, kind: np.dtype[Any], count: int, width: int) -> _Numbers:
        """(count, width), the numbers that an accessor or a part of it finds in a view."""
        index = owner.whole("bufferView")
        stride = self._root.one_of("bufferViews", index).whole("byteStride", 0)
        row = kind.itemsize * width
        stride, start = stride or row, owner.whole("byteOffset", 0)
        if stride < row:
            raise NoTriangles(f"is no valid glTF: the rows of {owner.name} overlap")
        data = self.view(index)
        if count and start + stride * (count - 1) + row > len(data):
            raise NoTriangles(f"has more numbers in {owner.name} than in the view of it")
        found: _Numbers = np.ndarray((count, width), kind, data, start, (stride, kind.itemsize))
        return found

    def _buffer(self, index: int) -> bytes:
        if index not in self._buffers:
            buffer = self._root.one_of("buffers", index)
            uri = buffer.text("uri")
            self._buffers[index] = self._read(uri) if uri else self._binary
        return self._buffers[index]

    def _read(self, uri: str) -> bytes:
        data = embedded(uri)
        if data is None:
            data = self._files.read(unquote(uri), MAX_BYTES)
        if data is None:
            raise NoTriangles(f"needs the file '{uri[:80]}', which cannot be read")
        return data


def embedded(uri: str) -> bytes | None:
    """The bytes that a URI itself holds; None for one that names a file.

    Raises:
        NoTriangles: they cannot be decoded.
    """
    if not uri.startswith("data:"):
        return None
    head, _, body = uri.partition(",")
    try:
        return b64decode(body + "==") if head.endswith(";base64") else unquote_to_bytes(body)
    except ValueError as error:
        raise NoTriangles("holds bytes that are not base64") from error


def _type(owner: GltfObject) -> np.dtype[Any]:
    number = owner.whole("componentType")
    if number not in _TYPES:
        raise NoTriangles(f"is no valid glTF: {owner.name} has the component type {number}")
    return np.dtype(_TYPES[number])
