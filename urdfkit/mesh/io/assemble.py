"""Mesh parts from the arrays of a mesh file: corners, invalid values, transforms."""

from collections.abc import Iterable, Iterator
from typing import NamedTuple, TypeVar

import numpy as np

from urdfkit.core.words import counted
from urdfkit.mesh.geometry import Flags, Floats, Integers, Mesh, MeshMaterial, MeshPart, NoTriangles
from urdfkit.mesh.grouping import equal_numbers
from urdfkit.mesh.io.referenced_files import ReferencedFiles

Item = TypeVar("Item")

#: Limits for the nodes and triangles of a scene: a short file can repeat geometry many times.
MAX_NODES = 20_000
MAX_TRIANGLES = 20_000_000

#: Most parts of a mesh, such as the surfaces of one material: each takes 0.3 ms.
MAX_PARTS = 20_000

#: Parts with so much fewer corners than the file has values are numbered by sorting: a file can
#: contain thousands of parts.
_SMALL = 16


class Stream(NamedTuple):
    """Values, and the row of each corner of each triangle in them."""

    values: Floats  # (n, k)
    rows: Integers  # (m, 3), indices of values


class LostData:
    """Elements of a file that could not be read, counted by kind."""

    def __init__(self) -> None:
        self._counts: dict[str, int] = {}

    def add(self, kind: str, number: int | np.signedinteger = 1) -> None:
        """Count losses; ``kind`` is a noun phrase with a ``*`` where the plural has an ``s``."""
        if number:
            self._counts[kind] = self._counts.get(kind, 0) + int(number)

    def sentences(self) -> tuple[str, ...]:
        """A sentence for each kind, in the order of first occurrence."""
        return tuple(
            f"{number} {kind.replace('*', '' if number == 1 else 's', 1)}"
            for kind, number in self._counts.items()
        )


def assemble(
    position: Stream,
    losses: LostData,
    material: MeshMaterial | None = None,
    *,
    normals: Stream | None = None,
    uv: Stream | None = None,
    colors: Stream | None = None,
) -> MeshPart | None:
    """A part of the valid triangles; None if there are none.

    Corners with equal values share a vertex. Unused values are omitted.
    """
    keep = _usable(position, losses)
    if not keep.any():
        return None
    streams = {"positions": _at(position, keep)}
    attributes = {"normals": normals, "texture coordinates": uv, "colours": colors}
    for name, stream in attributes.items():
        if stream is not None and len(stream.values):
            if _exist(stream)[keep].all():
                streams[name] = _at(stream, keep)
            else:
                losses.add(f"surface* whose {name} are not in the file")
    rows, faces = _unified(list(streams.values()))
    values = {
        name: stream.values[row] for (name, stream), row in zip(streams.items(), rows, strict=True)
    }
    vertices = values["positions"]
    return MeshPart(
        vertices,
        faces,
        material,
        _unit(values["normals"], vertices, faces) if "normals" in values else None,
        np.nan_to_num(values["texture coordinates"]) if "texture coordinates" in values else None,
        _rgba(values["colours"]) if "colours" in values else None,
    )


def mesh_of(
    parts: Iterable[MeshPart | None], losses: LostData, files: ReferencedFiles | None = None
) -> Mesh:
    """Build a mesh from its parts.

    Raises:
        NoTriangles: there are no parts, or more than ``MAX_PARTS``.
    """
    present = tuple(limited(parts))
    if not present:
        lost = "; ".join(losses.sentences())
        raise NoTriangles(f"contains no triangles{f' ({lost})' if lost else ''}")
    mesh = Mesh(present, losses=losses.sentences())
    return files.added_to(mesh) if files else mesh


def limited(parts: Iterable[MeshPart | None]) -> Iterator[MeshPart]:
    """The parts that exist.

    Raises:
        NoTriangles: there are more than ``MAX_PARTS``.
    """
    return at_most(MAX_PARTS, "surfaces", (part for part in parts if part is not None))


def at_most(most: int, what: str, items: Iterable[Item]) -> Iterator[Item]:
    """The items.

    Raises:
        NoTriangles: there are more than ``most``.
    """
    for number, item in enumerate(items, 1):
        if number > most:
            raise NoTriangles(f"has more than {most} {what}")
        yield item


def transformed(part: MeshPart, matrix: Floats, losses: LostData) -> MeshPart | None:
    """A part transformed by a homogeneous (4, 4) matrix; None if it would not be finite.

    A mirrored part keeps its outside.
    """
    if np.array_equal(matrix, np.eye(4)):
        return part
    linear = matrix[:3, :3]
    vertices = part.vertices @ linear.T + matrix[:3, 3]
    if not np.isfinite(vertices).all():
        losses.add("surface* that a node moves to infinity")
        return None
    determinant = np.linalg.det(linear)
    faces = part.faces[:, ::-1] if determinant < 0 else part.faces
    normals = None
    if part.normals is not None and determinant:
        normals = _unit(part.normals @ np.linalg.inv(linear), vertices, faces)
    return part._replace(vertices=vertices, faces=faces, normals=normals)


def _usable(position: Stream, losses: LostData) -> Flags:
    """(m,), True for triangles whose corners exist and are finite."""
    exists = _exist(position)
    losses.add("triangle* with a vertex that is not in the file", np.count_nonzero(~exists))
    keep: Flags = exists.copy()
    keep[exists] = np.isfinite(position.values[position.rows[exists]]).all(axis=(1, 2))
    lost = np.count_nonzero(exists & ~keep)
    losses.add("triangle* with a coordinate that is not finite", lost)
    return keep


def _exist(stream: Stream) -> Flags:
    """(m,), True for triangles whose values all exist."""
    return np.asarray(np.all((stream.rows >= 0) & (stream.rows < len(stream.values)), axis=1))


def _at(stream: Stream, keep: Flags) -> Stream:
    return stream if keep.all() else Stream(stream.values, stream.rows[keep])


def _unified(streams: list[Stream]) -> tuple[list[Integers], Integers]:
    """The row of each vertex in each stream, and the vertices (m, 3) of the triangles."""
    first = streams[0]
    if all(np.array_equal(stream.rows, first.rows) for stream in streams[1:]):
        if _SMALL * first.rows.size < len(first.values):
            rows, faces = np.unique(first.rows, return_inverse=True)
            return [rows] * len(streams), faces.reshape(first.rows.shape)
        used = np.zeros(min(len(stream.values) for stream in streams), dtype=bool)
        used[first.rows] = True
        faces = (np.cumsum(used) - 1)[first.rows]
        return [np.flatnonzero(used)] * len(streams), faces
    key = first.rows.reshape(-1)
    for stream in streams[1:]:
        # Renumbered in each round, so that no product overflows.
        _, key = np.unique(key, return_inverse=True)
        key = key * len(stream.values) + stream.rows.reshape(-1)
    corners, faces, _ = equal_numbers(key)
    return [stream.rows.reshape(-1)[corners] for stream in streams], faces.reshape(-1, 3)


def _rgba(colors: Floats) -> Floats:
    """RGB or RGBA colours as RGBA, each component from 0 to 1."""
    full = np.ones((len(colors), 4))
    full[:, : colors.shape[1]] = np.clip(np.nan_to_num(colors[:, :4], nan=1.0), 0, 1)
    return full


def _unit(normals: Floats, vertices: Floats, faces: Integers) -> Floats:
    """Unit normals; a zero normal is replaced by the normal of a triangle at the vertex."""
    with np.errstate(over="ignore", invalid="ignore"):
        length = np.linalg.norm(normals, axis=1)
        bad = ~(np.isfinite(length) & (length > 1e-12))
        unit = normals / np.where(bad, 1, length)[:, None]
    if bad.any():
        at = faces[bad[faces].any(axis=1)]
        edges = vertices[at[:, 1]] - vertices[at[:, 0]], vertices[at[:, 2]] - vertices[at[:, 0]]
        with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
            across = np.cross(*edges)
            across /= np.linalg.norm(across, axis=1)[:, None]
        across[~np.isfinite(across).all(axis=1)] = (0, 0, 1)
        instead = np.zeros_like(unit)
        for corner in range(3):
            instead[at[:, corner]] = across
        unit[bad] = instead[bad]
    return unit


def counted_kinds(kinds: dict[str, int]) -> tuple[str, ...]:
    """The kinds that occur, as ``2 cameras``, ``1 line set``."""
    return tuple(counted(number, kind) for kind, number in kinds.items() if number)
