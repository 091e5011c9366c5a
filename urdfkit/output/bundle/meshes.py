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
    path: str, info: MeshFacts, consumer: Consumer, stem: str, *, is_visual: bool
) -> Iterator[BundledFile]:
    """The files for a mesh in a bundle, the mesh first.

    Args:
        info: properties of the mesh file.
        consumer: the program that must read it.
        is_visual: True if a visual uses it; materials are kept if the format supports them.

    Raises:
        UrdfkitError: the mesh cannot be converted.
    """
    suffix = os.path.splitext(path)[1].lower()
    is_readable = info.format in consumer.reads and info.format in facts.BY_SUFFIX.get(suffix, ())
    if is_readable and info.format in _SINGLE:
        yield BundledFile(f"meshes/{stem}{suffix}", disk.read(path), path)
        return
    mesh = _loaded(path)
    if not is_readable:
        suffix = consumer.visual if is_visual else ".stl"
        change = f"{info.format} written as {suffix[1:].upper()}"
    elif consumer.loads_first_object and info.format == facts.OBJ and objects(disk.read(path)) > 1:
        change = "its objects are joined"
    elif all(_is_below(path, file) for file in mesh.files):
        yield from _with_its_files(path, mesh, stem)
        return
    else:
        suffix = ".glb" if info.format == facts.GLTF else suffix
        change = "referenced files from other directories are written next to it"
    yield from _written(path, info, mesh, f"{stem}{suffix}", change)


def _loaded(path: str) -> Mesh:
    with needing(f"{path}: reading it", "meshes"):
        from urdfkit.mesh.io.load import load
    return load(path)


def _is_below(path: str, referenced: str) -> bool:
    directory = os.path.dirname(os.path.abspath(path))
    return is_within(os.path.abspath(referenced), directory)


def _with_its_files(path: str, mesh: Mesh, stem: str) -> Iterator[BundledFile]:
    """A mesh file and its referenced files, at the same relative paths."""
    path = os.path.abspath(path)
    start, name = os.path.split(path)
    read = {file: referenced_files.read(file, MAX_BYTES, start) for file in mesh.files}
    referenced = {file: data for file, data in read.items() if data is not None and file != path}
    directory = f"meshes/{stem}" if referenced else "meshes"
    mesh_name = name if referenced else stem + os.path.splitext(name)[1]
    yield BundledFile(f"{directory}/{mesh_name}", disk.read(path), path)
    for file, data in referenced.items():
        relative = os.path.relpath(file, start).replace(os.sep, "/")
        yield BundledFile(f"{directory}/{relative}", data, file)


def _written(
    path: str, info: MeshFacts, mesh: Mesh, name: str, change: str
) -> Iterator[BundledFile]:
    from urdfkit.mesh.writers import encode, losses

    changes = [change]
    if has_other_unit(info):
        changes.append(f"in metres, by its unit of {info.unit:g} m")
    lost = [*losses(mesh, name), *mesh.losses]
    if lost:
        changes.append(f"not kept: {', '.join(lost)}")
    files = encode(mesh, name)
    directory = f"meshes/{os.path.splitext(name)[0]}" if len(files) > 1 else "meshes"
    for file, data in files.items():
        change = "; ".join(changes) if file == name else ""
        yield BundledFile(f"{directory}/{file}", data, path, change)
