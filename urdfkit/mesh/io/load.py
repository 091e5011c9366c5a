"""Mesh files to triangles.

All but PLY are read here and not by trimesh: importing it takes longer than reading the meshes of
a robot, and it loses what is there of many files that are not quite right.
"""

import os

from urdfkit.core import disk
from urdfkit.errors import UrdfkitError
from urdfkit.mesh.geometry import Mesh, NoTriangles
from urdfkit.mesh.io import facts
from urdfkit.mesh.io.facts import MAX_BYTES, MeshFacts
from urdfkit.mesh.io.sniff import sniff
from urdfkit.text.source import why_unreadable


class UnloadableMesh(UrdfkitError):
    """A mesh file that gives no triangles."""

    def __init__(self, path: str, reason: str) -> None:
        super().__init__(f"{path}: {reason}")
        self.path = path  # of the file
        self.reason = reason  # a predicate whose subject is the file


def load(path: str | os.PathLike[str]) -> Mesh:
    """The triangles of a mesh file, which is read by its content and not by its suffix.

    Raises:
        UnloadableMesh: it is broken, of a format that is not read, or holds no triangles.
    """
    name = os.fspath(path)
    return load_bytes(read_bytes(name), name)


def load_bytes(data: bytes, path: str) -> Mesh:
    """The triangles in the bytes of a mesh file.

    Args:
        path: of the file, for what it refers to.

    Raises:
        UnloadableMesh: there are none.
    """
    found = sniff(data, os.path.splitext(path)[1])
    if found.defect:
        raise UnloadableMesh(path, found.defect.reason)
    return _parse(data, path, found)


def salvage(path: str | os.PathLike[str]) -> Mesh:
    """The triangles that are left in a broken mesh file; ``losses`` says what is not.

    Raises:
        UnloadableMesh: none are left.
    """
    name = os.fspath(path)
    data = read_bytes(name)
    return _parse(data, name, sniff(data, os.path.splitext(name)[1]), recover=True)


def read_bytes(path: str) -> bytes:
    """The bytes of a mesh file.

    Raises:
        UnloadableMesh: it cannot be opened, or is too large.
    """
    try:
        size = disk.state(path).st_size
        if not disk.is_file(path):
            raise UnloadableMesh(path, "is no regular file")
        if size > MAX_BYTES:
            limit = MAX_BYTES // 1024**2
            raise UnloadableMesh(path, f"has {size // 1024**2} MiB, more than the {limit} read")
        return disk.read(path, MAX_BYTES)
    except OSError as error:
        raise UnloadableMesh(path, why_unreadable(path, error)) from error
    except ValueError as error:
        raise UnloadableMesh(path, "cannot be read: its name holds a NUL") from error


def _parse(data: bytes, path: str, found: MeshFacts, *, recover: bool = False) -> Mesh:
    """Read by the format that was found; ``recover``: what is there of a broken file."""
    directory = os.path.dirname(os.path.abspath(path))
    try:
        if found.format == facts.BINARY_STL:
            from urdfkit.mesh.io.load_stl import binary

            return binary(data)
        if found.format == facts.ASCII_STL:
            from urdfkit.mesh.io.load_stl import ascii_text

            return ascii_text(data)
        if found.format == facts.COLLADA:
            from urdfkit.mesh.io import load_collada

            return load_collada.read(data, directory, recover=recover)
        if found.format == facts.OBJ:
            from urdfkit.mesh.io import load_obj

            return load_obj.read(data, directory)
        if found.format in (facts.GLB, facts.GLTF) and not found.defect:
            from urdfkit.mesh.io import load_gltf

            return load_gltf.read(data, found.format, directory)
        if found.format == facts.PLY and not found.defect:
            from urdfkit.mesh.io import load_ply

            return load_ply.read(data, directory)
    except NoTriangles as error:
        raise UnloadableMesh(path, str(error)) from error
    if found.defect:
        raise UnloadableMesh(path, found.defect.reason)
    raise UnloadableMesh(path, f"is {found.format}, which is not read")
