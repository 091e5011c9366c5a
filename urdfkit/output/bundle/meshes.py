"""The mesh files of a bundle: copied, or converted to a format that the consumer reads."""

from __future__ import annotations

import os
from collections.abc import Iterator
from itertools import chain, count
from typing import TYPE_CHECKING

from urdfkit.core import disk
from urdfkit.core.installation import needing
from urdfkit.core.paths import is_within
from urdfkit.core.record import Record
from urdfkit.mesh.io import facts, referenced_files
from urdfkit.mesh.io.facts import MAX_BYTES, MeshFacts, has_other_unit
from urdfkit.mesh.io.obj import objects
from urdfkit.output.bundle.consumers import Consumer

if TYPE_CHECKING:
    from urdfkit.mesh.geometry import Mesh

#: Formats that cannot reference other files.
_SINGLE = (facts.BINARY_STL, facts.ASCII_STL, facts.PLY, facts.GLB)


class BundledFile(Record):
    """A file of a bundle."""

    path: str  # in the bundle, with ``/``
    data: bytes  # contents
    source: str  # path of the original file; empty for a file that the bundle adds
    change: str = ""  # difference from the original; empty for a copy


class FreeNames:
    """Unique names, ignoring case, as file systems and MuJoCo require."""

    def __init__(self) -> None:
        self._taken: set[str] = set()

    def take(self, *candidates: str) -> str:
        """The first free name of the candidates, else the first candidate with a number."""
        names = chain(candidates, (f"{candidates[0]}_{number}" for number in count(2)))
        free = next(name for name in names if name.casefold() not in self._taken)
        self._taken.add(free.casefold())
        return free

    def take_stem(self, path: str) -> str:
        """A free stem for a mesh file: its own, else with its directory, else with a number.

        MuJoCo and Gazebo identify a mesh by its name without directory and suffix.
        """
        stem = os.path.splitext(os.path.basename(path))[0]
        return self.take(stem, f"{os.path.basename(os.path.dirname(path))}_{stem}")


def bundled(
    path: str, found: MeshFacts, consumer: Consumer, stem: str, *, is_visual: bool
) -> Iterator[BundledFile]:
    """The files for a mesh in a bundle, the mesh first.

    Args:
        found: properties of the mesh file.
        consumer: the program that must read it.
        is_visual: True if a visual uses it; materials are kept if the format supports them.

    Raises:
        UrdfkitError: the mesh cannot be converted.
    """
    suffix = os.path.splitext(path)[1].lower()
    is_readable = found.format in consumer.reads and found.format in facts.BY_SUFFIX.get(suffix, ())
    if is_readable and found.format in _SINGLE:
        yield BundledFile(f"meshes/{stem}{suffix}", disk.read(path), path)
        return
    mesh = _loaded(path)
    if not is_readable:
        suffix = consumer.visual if is_visual else ".stl"
        change = f"{found.format} written as {suffix[1:].upper()}"
    elif consumer.loads_first_object and found.format == facts.OBJ and _has_objects(path):
        change = "its objects are one"
    elif all(_lies_below(path, other) for other in mesh.files):
        yield from _with_its_files(path, mesh, stem)
        return
    else:
        suffix = ".glb" if found.format == facts.GLTF else suffix
        change = "files that it names from elsewhere are written beside it"
    yield from _written(path, found, mesh, f"{stem}{suffix}", change)


def _has_objects(path: str) -> bool:
    return objects(disk.read(path)) > 1


def _loaded(path: str) -> Mesh:
    with needing(f"{path}: to read it", "meshes"):
        from urdfkit.mesh.io.load import load
    return load(path)


def _lies_below(path: str, other: str) -> bool:
    directory = os.path.dirname(os.path.abspath(path))
    return is_within(os.path.abspath(other), directory)


def _with_its_files(path: str, mesh: Mesh, stem: str) -> Iterator[BundledFile]:
    """A mesh file and its referenced files, at the same relative paths."""
    path = os.path.abspath(path)
    start, name = os.path.split(path)
    read = {other: referenced_files.read(other, MAX_BYTES, start) for other in mesh.files}
    others = {other: data for other, data in read.items() if data is not None and other != path}
    home = f"meshes/{stem}" if others else "meshes"
    own = name if others else stem + os.path.splitext(name)[1]
    yield BundledFile(f"{home}/{own}", disk.read(path), path)
    for other, data in others.items():
        relative = os.path.relpath(other, start).replace(os.sep, "/")
        yield BundledFile(f"{home}/{relative}", data, other)


def _written(
    path: str, found: MeshFacts, mesh: Mesh, name: str, change: str
) -> Iterator[BundledFile]:
    from urdfkit.mesh.writers import encode, losses

    changes = [change]
    if has_other_unit(found):
        changes.append(f"in metres, by its unit of {found.unit:g} m")
    lost = [*losses(mesh, name), *mesh.losses]
    if lost:
        changes.append(f"not kept: {', '.join(lost)}")
    files = encode(mesh, name)
    home = f"meshes/{os.path.splitext(name)[0]}" if len(files) > 1 else "meshes"
    for one, data in files.items():
        yield BundledFile(f"{home}/{one}", data, path, "; ".join(changes) if one == name else "")
