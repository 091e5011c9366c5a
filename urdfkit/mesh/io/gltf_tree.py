"""The objects of a glTF file: JSON whose values have the types that the format wants."""

from __future__ import annotations

from math import isfinite
from typing import Any

import numpy as np

from urdfkit.mesh.geometry import Floats, NoTriangles


class GltfObject:
    """A JSON object of a glTF file.

    Args:
        values: the object, or whatever stands in its place.
        name: where it is, for messages: ``accessors[2]``.

    Raises:
        NoTriangles: something else stands there; the methods raise it, too.
    """

    def __init__(self, values: object, name: str) -> None:
        if not isinstance(values, dict):
            raise NoTriangles(f"is no valid glTF: {name} is no object")
        self._values: dict[str, Any] = values
        self.name = name

    def __contains__(self, key: str) -> bool:
        return key in self._values

    def whole(self, key: str, default: int | None = None) -> int:
        """A number of things, or of one of them."""
        value = self._values.get(key, default)
        if not isinstance(value, int) or isinstance(value, bool) or not 0 <= value < 2**53:
            raise NoTriangles(f"is no valid glTF: {self._path(key)} is no whole number")
        return value

    def numbers(self, key: str, default: tuple[float, ...]) -> Floats:
        """As many numbers as the default has."""
        value = self._values.get(key, default)
        items = list(value) if isinstance(value, (list, tuple)) else []
        if len(items) != len(default) or not all(map(_is_number, items)):
            raise NoTriangles(f"is no valid glTF: {self._path(key)} is not {len(default)} numbers")
        return np.array(items, dtype=np.float64)

    def number(self, key: str, default: float) -> float:
        value = self._values.get(key, default)
        if not _is_number(value):
            raise NoTriangles(f"is no valid glTF: {self._path(key)} is no number")
        return float(value)

    def flag(self, key: str) -> bool:
        return self._values.get(key) is True

    def text(self, key: str) -> str:
        """A text; empty if there is none."""
        value = self._values.get(key, "")
        return value if isinstance(value, str) else ""

    def inner(self, *keys: str) -> GltfObject:
        """An object in this one, an object in that, and so on; empty if there is none."""
        node = self
        for key in keys:
            node = GltfObject(node._values.get(key, {}), node._path(key))
        return node

    def one_of(self, key: str, index: int) -> GltfObject:
        """An object of a list, by its place."""
        items, name = self._list(key), f"{self._path(key)}[{index}]"
        if not 0 <= index < len(items):
            raise NoTriangles(f"is no valid glTF: there is no {name}")
        return GltfObject(items[index], name)

    def each(self, key: str) -> list[GltfObject]:
        """The objects of a list."""
        name = self._path(key)
        return [GltfObject(value, f"{name}[{i}]") for i, value in enumerate(self._list(key))]

    def indices(self, key: str) -> list[int]:
        """The whole numbers of a list."""
        return [value for value in self._list(key) if type(value) is int]

    def texts(self, key: str) -> set[str]:
        """The texts of a list."""
        return {value for value in self._list(key) if isinstance(value, str)}

    def _list(self, key: str) -> list[Any]:
        value = self._values.get(key, [])
        if not isinstance(value, list):
            raise NoTriangles(f"is no valid glTF: {self._path(key)} is no list")
        return value

    def _path(self, key: str) -> str:
        return f"{self.name}.{key}" if self.name else key


def _is_number(value: Any) -> bool:
    # A whole number of JSON may be larger than any float.
    return type(value) in (int, float) and abs(value) < 1e300 and isfinite(value)
