"""Accessors and buffer views of glTF files.

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

#: Most rows of a sparse accessor without a buffer view, which takes no bytes in the file.
MAX_ZEROS = 1_000_000

_TYPES = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}

#: A JSON object with unchecked content: `load_gltf.read` catches the errors.
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
        """(n, k), vectors; normalised integers are converted to numbers between -1 or 0 and 1.

        Raises:
            NoTriangles: the data is not in the file; also for the methods below.
        """
        accessor = self._root["accessors"][index]
        values = self._numbers(accessor)
        if accessor.get("normalized") is not True or values.dtype.kind == "f":
            with np.errstate(invalid="ignore"):  # for values that are not finite
                return values.astype(np.float64)
        return np.asarray(np.maximum(values / float(np.iinfo(values.dtype).max), -1.0))

    def indices(self, index: int) -> Integers:
        """(n,), integers."""
        values = self._numbers(self._root["accessors"][index])
        if values.dtype.kind == "f":
            raise NoTriangles("is not valid glTF: indices are fractions")
        return values[:, 0].astype(np.int64)

    def view(self, index: int) -> memoryview:
        """The bytes of a buffer view."""
        view = self._root["bufferViews"][index]
        data = self._buffer(view["buffer"])
        start, length = view.get("byteOffset", 0), view["byteLength"]
        if start + length > len(data):
            missing = start + length - len(data)
            raise NoTriangles(f"lacks {missing} bytes of bufferViews[{index}]")
        return memoryview(data)[start : start + length]

    def _numbers(self, accessor: GltfObject) -> _Numbers:
        """(n, k), values as stored, with sparse substitutions."""
        count, width, kind = accessor["count"], _WIDTHS[accessor["type"]], _type(accessor)
        sparse = accessor.get("sparse")
        if "bufferView" in accessor:
            numbers = self._table(accessor, kind, count, width)
        elif sparse and count <= MAX_ZEROS:
            numbers = np.zeros((count, width), kind)
        else:
            raise NoTriangles(f"declares {count} rows of numbers and contains none")
        if sparse:
            indices, values = sparse["indices"], sparse["values"]
            rows = self._table(indices, _type(indices), sparse["count"], 1)[:, 0]
            numbers = numbers.copy()
            numbers[rows.astype(np.int64)] = self._table(values, kind, sparse["count"], width)
        return numbers

    def _table(self, owner: GltfObject, kind: np.dtype[Any], count: int, width: int) -> _Numbers:
        """(count, width), the numbers of an accessor or its sparse part in a buffer view."""
        row = kind.itemsize * width
        stride = self._root["bufferViews"][owner["bufferView"]].get("byteStride") or row
        if stride < row:
            raise NoTriangles("is not valid glTF: rows of numbers overlap")
        data, start = self.view(owner["bufferView"]), owner.get("byteOffset", 0)
        return np.asarray(np.ndarray((count, width), kind, data, start, (stride, kind.itemsize)))

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
    """The bytes of a data URI; None for the URI of a file.

    Raises:
        NoTriangles: the bytes cannot be decoded.
    """
    if not uri.startswith("data:"):
        return None
    head, _, body = uri.partition(",")
    try:
        return b64decode(body + "==") if head.endswith(";base64") else unquote_to_bytes(body)
    except ValueError as error:
        raise NoTriangles("contains invalid base64") from error


def _type(owner: GltfObject) -> np.dtype[Any]:
    return np.dtype(_TYPES[owner["componentType"]])
