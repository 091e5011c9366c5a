"""The triangles of a COLLADA ``<geometry>``.

COLLADA 1.4.1, chapter 5: the corners of a surface are rows of indices, one index for each input
offset; an input with the semantic VERTEX refers to the inputs of ``<vertices>``.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from urdfkit.mesh.geometry import Floats, Integers
from urdfkit.mesh.io.assemble import LostData, Stream
from urdfkit.mesh.io.collada_tree import ColladaTree, Element, child, children, tag, text
from urdfkit.mesh.io.numbers import floats, integers
from urdfkit.mesh.io.polygons import fans, strips, triangles

SURFACES = ("triangles", "polylist", "polygons", "trifans", "tristrips")
LINES = ("lines", "linestrips")

#: Limit for the inputs of a corner.
_MOST_OFFSETS = 64


class ColladaTriangles(NamedTuple):
    """Triangles with the same material."""

    symbol: str  # of the material
    position: Stream  # of the corners
    #: normals and colors: of the corners, or None.
    normals: Stream | None
    colors: Stream | None
    #: Texture coordinates by set number, in the order of the file.
    uvs: dict[str, Stream]


class _Input(NamedTuple):
    """Values of corners, and the column of their index."""

    semantic: str
    set: str
    offset: int
    values: Floats


class Geometries:
    """The surfaces of the geometries of a file, each parsed once."""

    def __init__(self, tree: ColladaTree, losses: LostData) -> None:
        self._tree = tree
        self._losses = losses
        self._sources: dict[Element, Floats] = {}
        self._surfaces: dict[Element, list[ColladaTriangles]] = {}
        self._repeated: set[str] = set()
        self.lines = 0

    def surfaces(self, geometry: Element) -> list[ColladaTriangles]:
        if geometry not in self._surfaces:
            mesh = child(geometry, "mesh")
            self.lines += sum(1 for _ in children(mesh, *LINES))
            surfaces = [self._surface(element) for element in children(mesh, *SURFACES)]
            self._surfaces[geometry] = [surface for surface in surfaces if surface]
        return self._surfaces[geometry]

    def _surface(self, element: Element) -> ColladaTriangles | None:
        inputs = list(self._inputs(element))
        position = next((entry for entry in inputs if entry.semantic == "POSITION"), None)
        offsets = [_number(entry.get("offset"), 0) for entry in children(element, "input")]
        width = max(offsets, default=0) + 1
        if position is None or width > _MOST_OFFSETS:
            self._losses.add("surface* without coordinates")
            return None
        corners, index = self._corners(element, width, position)
        by_semantic: dict[str, Stream] = {}
        uvs: dict[str, Stream] = {}
        for entry in inputs:
            stream = Stream(entry.values, corners[:, entry.offset][index])
            by_semantic.setdefault(entry.semantic, stream)
            if entry.semantic == "TEXCOORD":
                uvs.setdefault(entry.set, stream)
        return ColladaTriangles(
            element.get("material", ""),
            by_semantic["POSITION"],
            by_semantic.get("NORMAL"),
            by_semantic.get("COLOR"),
            uvs,
        )

    def _inputs(self, element: Element) -> Iterator[_Input]:
        for entry in children(element, "input"):
            offset = _number(entry.get("offset"), 0)
            number = entry.get("set", "0")
            if entry.get("semantic") != "VERTEX":
                yield from self._input(entry, offset, number)
                continue
            vertices = self._named(entry, "vertices")
            for shared in children(vertices, "input"):
                yield from self._input(shared, offset, number)

    def _input(self, entry: Element, offset: int, number: str) -> Iterator[_Input]:
        semantic = entry.get("semantic", "")
        width = {"POSITION": (3, 3), "NORMAL": (3, 3), "TEXCOORD": (2, 2), "COLOR": (3, 4)}
        if semantic not in width or offset < 0:
            return
        source = self._named(entry, "source")
        values = self._source(source) if source is not None else np.zeros((0, 0))
        least, most = width[semantic]
        if values.shape[1] >= least:
            yield _Input(semantic, number, offset, values[:, :most])
        elif semantic != "POSITION":
            self._losses.add(f"list* of {semantic} values that cannot be read")

    def _named(self, entry: Element, kind: str) -> Element | None:
        """The element that an input refers to: of its own mesh, if an id is repeated, as in assimp.

        Gazebo takes the first of the file.
        """
        reference = entry.get("source")
        first = self._tree.named(reference, kind)
        if reference is None or first is None:
            return first
        for mesh in entry.iterancestors("{*}mesh"):
            for own in children(mesh, kind):
                if own.get("id") == first.get("id"):
                    if own is not first and reference not in self._repeated:
                        self._repeated.add(reference)
                        self._losses.add("repeated id*, of which Gazebo reads the first")
                    return own
        return first

    def _source(self, source: Element) -> Floats:
        """(n, k), the values of a source."""
        if source not in self._sources:
            self._sources[source] = self._read(source)
        return self._sources[source]

    def _read(self, source: Element) -> Floats:
        accessor = child(source, "technique_common", "accessor")
        array = child(source, "float_array")
        if accessor is None:
            return np.zeros((0, 0))
        if array is None:
            array = self._tree.named(accessor.get("source"), "float_array")
        numbers = floats((array.text or "") if array is not None else "")
        names = [param.get("name", "") for param in children(accessor, "param")]
        stride = _number(accessor.get("stride"), 1)
        start = _number(accessor.get("offset"), 0)
        if stride < 1 or start < 0:
            return np.zeros((0, 0))
        numbers = numbers[start:]
        rows = numbers[: len(numbers) // stride * stride].reshape(-1, stride)
        # COLLADA: a parameter without a name is skipped.
        used = [i for i, name in enumerate(names[:stride]) if name]
        return rows[:, used] if used else rows

    def _corners(self, element: Element, width: int, position: _Input) -> tuple[Integers, Integers]:
        """Rows of indices, (c, width), and triangles as indices of rows, (m, 3)."""
        kind = tag(element)
        if kind == "triangles":
            rows = self._rows(text(child(element, "p")), width)
            return rows, np.arange(len(rows) // 3 * 3).reshape(-1, 3)
        if kind == "polylist":
            rows = self._rows(text(child(element, "p")), width)
            counts = np.clip(integers(text(child(element, "vcount"))), 0, len(rows) + 1)
            whole = np.cumsum(counts) <= len(rows)
            self._losses.add("polygon* with missing corners", np.count_nonzero(~whole))
            return rows, triangles(counts[whole], _places(rows, position))
        lists = [text(p) for p in children(element, "p")]
        if kind == "polygons":
            holed = list(children(element, "ph"))
            self._losses.add("polygon* with filled holes", len(holed))
            lists += [text(child(ph, "p")) for ph in holed]
        rows, counts = self._lists_of_rows(lists, width)
        if kind == "tristrips":
            return rows, strips(counts)
        if kind == "trifans":
            return rows, fans(counts)
        return rows, triangles(counts, _places(rows, position))

    def _rows(self, numbers: str, width: int) -> Integers:
        return self._lists_of_rows([numbers], width)[0]

    def _lists_of_rows(self, lists: list[str], width: int) -> tuple[Integers, Integers]:
        """The rows of all lists, (c, width), and the number of rows of each."""
        indices = integers(" ".join(lists))  # at once: a file may have a list for each polygon
        if len(lists) == 1:
            lengths = np.array([len(indices)])
        else:
            lengths = np.array([len(numbers.split()) for numbers in lists], dtype=np.int64)
        counts, rest = np.divmod(lengths, width)
        self._losses.add("truncated list* of corners", np.count_nonzero(rest))
        if rest.any():
            within = np.arange(len(indices)) - np.repeat(np.cumsum(lengths) - lengths, lengths)
            indices = indices[within < np.repeat(counts * width, lengths)]
        return indices.reshape(-1, width), counts


def _places(rows: Integers, position: _Input) -> Floats:
    """(c, 3), positions of the corners; arbitrary for invalid indices."""
    if not len(position.values):
        return np.zeros((len(rows), 3))
    return position.values.take(rows[:, position.offset], axis=0, mode="clip")


def _number(word: str | None, default: int) -> int:
    """A small integer in an attribute; -1 if invalid."""
    if word is None:
        return default
    word = word.strip()
    return int(word) if word.isdecimal() and len(word) < 9 else -1
