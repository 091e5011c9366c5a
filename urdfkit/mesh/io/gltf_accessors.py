"""The lists of numbers in a glTF file: accessors of buffer views.

Source: glTF 2.0 Specification, chapter "Binary Data Storage",
https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html#binary-data-storage.
"""

from base64 import b64decode
from typing import Any
from urllib.parse import unquote, unquote_to_bytes

import numpy as np
from numpy.typing import NDArray

from urdfkit.mesh.geometry import Floats, Integers, NoTriangles
from urdfkit.mesh.io.facts import MAX_BYTES
from urdfkit.mesh.io.referenced_files import ReferencedFiles

#: Rows of a list of zeros that a sparse one changes: no byte of it need be in the file.
MAX_ZEROS = 1_000_000

_TYPES = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}

#: An object of the JSON, which may hold anything: `load_gltf.read` catches what comes of that.
GltfObject = dict[str, Any]
_Numbers = NDArray[Any]


class Accessors:
    """Reads the accessors (typed arrays) of one glTF file.

    Args:
        binary: the binary chunk of a GLB; empty if there is none.
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
        accessor = self._root["accessors"][index]
        found = self._numbers(accessor)
        if accessor.get("normalized") is not True or found.dtype.kind == "f":
            with np.errstate(invalid="ignore"):  # of what is not finite
                return found.astype(np.float64)
        fractions: Floats = np.maximum(found / float(np.iinfo(found.dtype).max), -1.0)
        return fractions

    def indices(self, index: int) -> Integers:
        """(n,), a list of whole numbers."""
        found = self._numbers(self._root["accessors"][index])
        if found.dtype.kind == "f":
            raise NoTriangles("is not valid glTF: indices are fractions")
        return found[:, 0].astype(np.int64)

    def view(self, index: int) -> memoryview:
        """The bytes that a view shows."""
        view = self._root["bufferViews"][index]
        data = self._buffer(view["buffer"])
        start, length = view.get("byteOffset", 0), view["byteLength"]
        if start + length > len(data):
            missing = start + length - len(data)
            raise NoTriangles(f"lacks {missing} bytes of bufferViews[{index}]")
        return memoryview(data)[start : start + length]

    def _numbers(self, accessor: GltfObject) -> _Numbers:
        """(n, k), as they are stored, with the rows that a sparse list replaces."""
        count, width, kind = accessor["count"], _WIDTHS[accessor["type"]], _type(accessor)
        sparse = accessor.get("sparse")
        if "bufferView" in accessor:
            found = self._table(accessor, kind, count, width)
        elif sparse and count <= MAX_ZEROS:
            found = np.zeros((count, width), kind)
        else:
            raise NoTriangles(f"declares {count} rows of numbers and holds none")
        if sparse:
            places, values = sparse["indices"], sparse["values"]
            rows = self._table(places, _type(places), sparse["count"], 1)[:, 0]
            found = found.copy()
            found[rows.astype(np.int64)] = self._table(values, kind, sparse["count"], width)
        return found

    def _table(self, owner: GltfObject, kind: np.dtype[Any], count: int, width: int) -> _Numbers:
        """(count, width), the numbers that an accessor or a part of it finds in a view."""
        row = kind.itemsize * width
        stride = self._root["bufferViews"][owner["bufferView"]].get("byteStride") or row
        if stride < row:
            raise NoTriangles("is not valid glTF: rows of numbers overlap")
        data, start = self.view(owner["bufferView"]), owner.get("byteOffset", 0)
        found: _Numbers = np.ndarray((count, width), kind, data, start, (stride, kind.itemsize))
        return found

    def _buffer(self, index: int) -> bytes:
        if index not in self._buffers:
            uri = self._root["buffers"][index].get("uri")
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
    return np.dtype(_TYPES[owner["componentType"]])
