"""Reading of Wavefront OBJ files."""

from itertools import chain
from typing import NamedTuple

import numpy as np

from urdfkit.mesh.geometry import Floats, Integers, Mesh, MeshPart
from urdfkit.mesh.io.assemble import LostData, Stream, assemble, counted_kinds, mesh_of
from urdfkit.mesh.io.numbers import floats
from urdfkit.mesh.io.obj_materials import MaterialLibrary
from urdfkit.mesh.io.polygons import triangles
from urdfkit.mesh.io.referenced_files import ReferencedFiles

_EXTRAS = {b"l": "line", b"p": "point set", b"curv": "curve", b"surf": "free-form surface"}


class _Group(NamedTuple):
    """Successive faces of the same material, each as the text of its corners."""

    material: str
    faces: list[bytes]


def read(data: bytes, directory: str) -> Mesh:
    """Read an OBJ file.

    Args:
        data: the file.
        directory: the directory of the file, for its materials.

    Raises:
        NoTriangles: the file has none.
    """
    lines = _Lines(data)
    losses = LostData()
    files = ReferencedFiles(directory)
    library = MaterialLibrary(lines.libraries, files, losses)
    points = lines.table(b"v")
    values = (points[:, :3], lines.table(b"vt")[:, :2], lines.table(b"vn")[:, :3])
    colors = points[:, 3:6] if points.shape[1] == 6 else None
    parts = (_part(group, values, colors, library, losses) for group in lines.groups)
    return mesh_of(parts, losses, files)._replace(extras=counted_kinds(lines.extras))


class _Lines:
    """The lines of an OBJ file by keyword."""

    def __init__(self, data: bytes) -> None:
        self._rows: dict[bytes, list[bytes]] = {b"v": [], b"vt": [], b"vn": []}
        self.groups: list[_Group] = [_Group("", [])]
        self.libraries: list[str] = []  # names of material files
        self.extras: dict[str, int] = {}  # numbers of other elements
        for line in data.replace(b"\\\r\n", b" ").replace(b"\\\n", b" ").splitlines():
            word, _, rest = line.strip().replace(b"\t", b" ").partition(b" ")
            if word in self._rows:
                self._rows[word].append(rest)
            elif word == b"f":
                self.groups[-1].faces.append(self._absolute(rest) if b"-" in rest else rest)
            elif word == b"usemtl":
                self.groups.append(_Group(rest.strip().decode("utf-8", "replace"), []))
            elif word == b"mtllib":
                self.libraries.append(rest.strip().decode("utf-8", "replace"))
            elif word in _EXTRAS:
                self.extras[_EXTRAS[word]] = self.extras.get(_EXTRAS[word], 0) + 1

    def table(self, word: bytes) -> Floats:
        """(n, k), the numbers of the lines with a keyword; k is at least 3, or 2 for ``vt``."""
        rows = self._rows[word]
        least = 2 if word == b"vt" else 3
        if not rows:
            return np.zeros((0, least))
        width = len(rows[0].split())
        numbers = floats(b" ".join(rows).decode("latin-1"))
        if width >= least and len(numbers) == width * len(rows):
            return numbers.reshape(-1, width)
        table = np.full((len(rows), least), np.nan)
        for row, line in zip(table, rows, strict=True):
            numbers = floats(line.decode("latin-1"))[:least]
            row[: len(numbers)] = numbers
        return np.nan_to_num(table) if word == b"vt" else table  # v is optional

    def _absolute(self, rest: bytes) -> bytes:
        """The corners of a face with absolute instead of relative indices."""
        counts = [len(self._rows[word]) for word in (b"v", b"vt", b"vn")]
        corners = []
        for corner in rest.split():
            words = corner.split(b"/")
            for column, word in enumerate(words[:3]):
                if word[:1] == b"-" and word[1:].isdigit() and len(word) < 18:
                    words[column] = b"%d" % max(counts[column] + 1 - int(word[1:]), 0)
            corners.append(b"/".join(words))
        return b" ".join(corners)


def _part(
    group: _Group,
    values: tuple[Floats, Floats, Floats],
    colors: Floats | None,
    library: MaterialLibrary,
    losses: LostData,
) -> MeshPart | None:
    corners = [face.partition(b"#")[0].split() for face in group.faces]
    if not any(corners) or not len(values[0]):
        return None
    index = _indices(list(chain.from_iterable(corners)))
    places = values[0].take(index[:, 0], axis=0, mode="clip")
    cut = triangles(np.array([len(face) for face in corners], dtype=np.int64), places)
    streams = [
        Stream(rows, index[:, column][cut]) if index.shape[1] > column else None
        for column, rows in enumerate(values)
    ]
    position, uv, normals = streams
    assert position is not None
    return assemble(
        position,
        losses,
        library.material(group.material),
        normals=_if_used(normals),
        uv=_if_used(uv),
        colors=Stream(colors, position.rows) if colors is not None else None,
    )


def _if_used(stream: Stream | None) -> Stream | None:
    """The stream; None if no corner has an index in it."""
    return None if stream is None or (stream.rows < 0).all() else stream


def _indices(corners: list[bytes]) -> Integers:
    """(n, 1 to 3), indices of corners such as ``1/2/3``, counted from 0; -1 if missing."""
    width = min(corners[0].count(b"/") + 1, 3) if corners else 1
    text = b" ".join(corners).replace(b"//", b"/0/")
    try:
        numbers = np.array(text.replace(b"/", b" ").split(), dtype=np.int64)
        uniform = len(numbers) == width * len(corners)
        uniform = uniform and all(corner.count(b"/") == width - 1 for corner in corners)
    except (ValueError, OverflowError):
        uniform = False
    if not uniform:
        rows = [[_index(word) for word in corner.split(b"/")[:3]] for corner in corners]
        numbers = np.array([row + [0] * (3 - len(row)) for row in rows], dtype=np.int64)
        width = 3
    return np.asarray(numbers.reshape(-1, width) - 1)


def _index(word: bytes) -> int:
    return int(word) if word.isdigit() and len(word) < 18 else 0
