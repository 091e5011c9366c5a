"""Writing meshes: the same mesh gives the same bytes, on every day and every machine."""

import os
from importlib import import_module

from urdfkit.core import atomic, disk
from urdfkit.errors import UnwritableFile, UrdfkitError
from urdfkit.mesh.geometry import Mesh

#: The module that writes each format, by suffix.
_WRITERS = {
    ".dae": "collada",
    ".stl": "by_trimesh",
    ".obj": "obj",
    ".glb": "by_trimesh",
    ".ply": "by_trimesh",
}

#: glTF says that y is upwards. Gazebo, RViz before 15.1.4, assimp and trimesh take the numbers as
#: they are, and for them z stays upwards here, as in every other format; newer RViz, Drake and
#: Blender turn what they read by 90 degrees. No file suits both.
GLB_NOTE = (
    "glTF means y upwards: Gazebo takes the numbers as they are, RViz from 15.1.4 on turns them; "
    "COLLADA and OBJ mean the same to both"
)

#: The suffixes that can be written.
SUFFIXES = tuple(_WRITERS)


class UnwritableMesh(UrdfkitError):
    """A mesh that cannot be written; the text says why and what to do."""


def encode(mesh: Mesh, name: str) -> dict[str, bytes]:
    """The bytes of a mesh file, and of the files next to it that it needs.

    Lengths are metres in every format: a unit that the mesh has is applied, as RViz and Gazebo
    would. Its axes stay as they are, for neither of them turns a mesh by its up axis.

    Args:
        mesh: with at least one triangle.
        name: of the file, without directories; its suffix says the format.

    Returns:
        Contents by file name. The mesh is the first; materials and textures of OBJ and COLLADA
        follow.

    Raises:
        UnwritableMesh: the suffix is none of `SUFFIXES`, the mesh has no triangles or vertices
            that are not finite or absurdly far away, or a texture is missing.
    """
    from urdfkit.mesh.welding import finite

    suffix = os.path.splitext(name)[1].lower()
    if suffix not in _WRITERS:
        known = ", ".join(SUFFIXES)
        raise UnwritableMesh(f"{name}: this suffix cannot be written; take one of {known}")
    if not len(mesh.faces):
        raise UnwritableMesh(f"{name}: there are no triangles to write")
    if not finite(mesh.vertices).all():
        raise UnwritableMesh(
            f"{name}: a vertex is not finite, or absurdly far away; repair it first"
        )
    from urdfkit.mesh.transforms import in_metres

    writer = import_module(f"urdfkit.mesh.writers.{_WRITERS[suffix]}")
    files: dict[str, bytes] = writer.encode(in_metres(mesh), name)
    return files


def losses(mesh: Mesh, name: str) -> list[str]:
    """What a format cannot hold of a mesh, as words for a person."""
    suffix = os.path.splitext(name)[1].lower()
    lost = []
    materials = any(part.material for part in mesh.parts)
    textures = any(part.material and part.material.texture for part in mesh.parts)
    colors = any(part.colors is not None for part in mesh.parts)
    if suffix in (".stl", ".ply") and materials:
        lost.append("materials")
    if suffix == ".ply" and len(mesh.parts) > 1:
        lost.append("the division into parts")
    if suffix in (".stl", ".ply") and textures:
        lost.append("textures")
    if suffix == ".stl" and colors:
        lost.append("colours of vertices")
    return lost


class SoundMesh(UrdfkitError):
    """A file is a sound mesh, which is replaced on request only."""


def require_replaceable(path: str | os.PathLike[str]) -> None:
    """Check that a file may be overwritten: it is not a sound mesh.

    Raises:
        SoundMesh: the file is one.
    """
    from urdfkit.mesh.io.sniff import sniff_file

    name = os.fspath(path)
    if disk.exists(name) and sniff_file(name).defect is None:
        raise SoundMesh(f"{name} is a good mesh already; --force replaces it")


def write(mesh: Mesh, path: str | os.PathLike[str]) -> list[str]:
    """Write a mesh file and the files that it needs, each whole or not at all.

    The mesh comes last, so that it never names a file that is not there yet. Directories that are
    missing are made.

    Returns:
        The paths that were written, the mesh first.

    Raises:
        UnwritableMesh: as for `encode`.
        UnwritableFile: a directory or file cannot be written.
    """
    directory, name = os.path.split(os.path.abspath(path))
    return write_files(encode(mesh, name), directory)


def write_files(files: dict[str, bytes], directory: str) -> list[str]:
    """Write what `encode` gave into a directory, which is made where it is missing.

    Raises:
        UnwritableFile: a directory or file cannot be written, or a link leads out of its workspace.
    """
    paths = [os.path.join(directory, name) for name in files]
    for path in paths:
        _require_inside(path)
    atomic.make_directory(directory)
    for path, data in reversed([*zip(paths, files.values(), strict=True)]):
        atomic.write(path, data)
    return paths


def _require_inside(path: str) -> None:
    """Check that no symbolic link in a path leads out of the workspace of the file."""
    real = disk.real(path)
    if real == path:
        return
    from urdfkit.core.paths import is_within
    from urdfkit.workspace.resolve import Resolver

    if not is_within(real, disk.real(Resolver().packages.workspace(path))):
        raise UnwritableFile(
            f"{path}: a link leads to {real}, outside of the workspace; pass that path instead"
        )
