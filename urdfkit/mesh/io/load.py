"""Loading of mesh files.

trimesh only reads PLY: importing it takes longer than reading the meshes of a robot, and it rejects
many files with small defects.
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
    """A mesh file without readable triangles."""

    def __init__(self, path: str, reason: str) -> None:
        super().__init__(f"{path}: {reason}")
        self.path = path
        self.reason = reason  # a predicate whose subject is the file


def load(path: str | os.PathLike[str]) -> Mesh:
    """The triangles of a mesh file, whose format is determined by its content.

    Raises:
        UnloadableMesh: the file is broken, of an unsupported format, or contains no triangles.
    """
    name = os.fspath(path)
    return load_bytes(read_bytes(name), name)


def load_bytes(data: bytes, path: str) -> Mesh:
    """The triangles in the bytes of a mesh file.

    Args:
        path: path of the file, for references.

    Raises:
        UnloadableMesh: as for `load`.
    """
    properties = sniff(data, os.path.splitext(path)[1])
    if properties.defect:
        raise UnloadableMesh(path, properties.defect.reason)
    return _parse(data, path, properties)


def salvage(path: str | os.PathLike[str]) -> Mesh:
    """The readable triangles of a broken mesh file; ``losses`` describes the rest.

    Raises:
        UnloadableMesh: no triangles are readable.
    """
    name = os.fspath(path)
    data = read_bytes(name)
    return _parse(data, name, sniff(data, os.path.splitext(name)[1]), recover=True)


def read_bytes(path: str) -> bytes:
    """The bytes of a mesh file.

    Raises:
        UnloadableMesh: the file cannot be opened, or is too large.
    """
    try:
        size = disk.state(path).st_size
        if not disk.is_file(path):
            raise UnloadableMesh(path, "is not a regular file")
        if size > MAX_BYTES:
            limit = MAX_BYTES // 1024**2
            raise UnloadableMesh(path, f"is too large: {size // 1024**2} MiB > {limit} MiB")
        return disk.read(path, MAX_BYTES)
    except OSError as error:
        raise UnloadableMesh(path, why_unreadable(path, error)) from error
    except ValueError as error:
        raise UnloadableMesh(path, "cannot be read: its name contains a NUL") from error


def _parse(data: bytes, path: str, properties: MeshFacts, *, recover: bool = False) -> Mesh:
    """Parse by format; ``recover``: read as much as possible of a broken file."""
    directory = os.path.dirname(os.path.abspath(path))
    try:
        if properties.format == facts.BINARY_STL:
            from urdfkit.mesh.io.load_stl import binary

            return binary(data)
        if properties.format == facts.ASCII_STL:
            from urdfkit.mesh.io.load_stl import ascii_text

            return ascii_text(data)
        if properties.format == facts.COLLADA:
            from urdfkit.mesh.io import load_collada

            return load_collada.read(data, directory, recover=recover)
        if properties.format == facts.OBJ:
            from urdfkit.mesh.io import load_obj

            return load_obj.read(data, directory)
        if properties.format in (facts.GLB, facts.GLTF) and not properties.defect:
            from urdfkit.mesh.io import load_gltf

            return load_gltf.read(data, properties.format, directory)
        if properties.format == facts.PLY and not properties.defect:
            from urdfkit.mesh.io import load_ply

            return load_ply.read(data, directory)
    except NoTriangles as error:
        raise UnloadableMesh(path, str(error)) from error
    if properties.defect:
        raise UnloadableMesh(path, properties.defect.reason)
    raise UnloadableMesh(path, f"is {properties.format}, which is not supported")
