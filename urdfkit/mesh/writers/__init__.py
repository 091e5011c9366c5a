"""Writing of meshes; the bytes only depend on the mesh."""

import os
from importlib import import_module

from urdfkit.core import atomic, disk
from urdfkit.errors import UnwritableFile, UrdfkitError
from urdfkit.mesh.geometry import Mesh

#: Module that writes each format, by suffix.
_WRITERS = {
    ".dae": "collada",
    ".stl": "by_trimesh",
    ".obj": "obj",
    ".glb": "by_trimesh",
    ".ply": "by_trimesh",
}

#: glTF defines y as up. Gazebo, RViz before 15.1.4, assimp and trimesh use the coordinates as they
#: are, and for them z is written as up, as in every other format; newer RViz, Drake and Blender
#: rotate the mesh by 90 degrees. No file suits both.
GLB_NOTE = (
    "glTF defines y as up: Gazebo uses the coordinates as they are, RViz 15.1.4 and later rotates "
    "them; COLLADA and OBJ look the same in both"
)

#: Suffixes of writable formats.
SUFFIXES = tuple(_WRITERS)


class UnwritableMesh(UrdfkitError):
    """A mesh cannot be written; the text states the reason and a solution."""


def encode(mesh: Mesh, name: str) -> dict[str, bytes]:
    """The bytes of a mesh file and of the files that it references.

    Lengths are metres in every format: the unit of the mesh is applied, as in RViz and Gazebo. Its
    axes do not change, because neither of them rotates a mesh by its up axis.

    Args:
        mesh: with at least one triangle.
        name: file name without directories; its suffix selects the format.

    Returns:
        Contents by file name: the mesh first, then materials and textures of OBJ and COLLADA.

    Raises:
        UnwritableMesh: the suffix is not in `SUFFIXES`, the mesh has no triangles, a vertex is not
            finite or absurdly far away, or a texture is missing.
    """
    from urdfkit.mesh.welding import finite

    suffix = os.path.splitext(name)[1].lower()
    if suffix not in _WRITERS:
        raise UnwritableMesh(f"{name}: unsupported suffix; use one of {', '.join(SUFFIXES)}")
    if not len(mesh.faces):
        raise UnwritableMesh(f"{name}: the mesh has no triangles")
    if not finite(mesh.vertices).all():
        raise UnwritableMesh(
            f"{name}: a vertex is not finite, or absurdly far away; repair the mesh first"
        )
    from urdfkit.mesh.transforms import in_metres

    writer = import_module(f"urdfkit.mesh.writers.{_WRITERS[suffix]}")
    files: dict[str, bytes] = writer.encode(in_metres(mesh), name)
    return files


def losses(mesh: Mesh, name: str) -> list[str]:
    """Properties of a mesh that a format does not support, as text."""
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
        lost.append("vertex colours")
    return lost


class SoundMesh(UrdfkitError):
    """A file is a valid mesh, which is replaced on request only."""


def require_replaceable(path: str | os.PathLike[str]) -> None:
    """Check that a file may be overwritten.

    Raises:
        SoundMesh: the file is a valid mesh.
    """
    from urdfkit.mesh.io.sniff import sniff_file

    name = os.fspath(path)
    if disk.exists(name) and sniff_file(name).defect is None:
        raise SoundMesh(f"{name} is a valid mesh; use --force to replace it")


def write(mesh: Mesh, path: str | os.PathLike[str]) -> list[str]:
    """Write a mesh file and the files that it references, each atomically.

    The mesh is written last, so that all files that it references exist. Missing directories are
    created.

    Returns:
        The paths of the written files, the mesh first.

    Raises:
        UnwritableMesh: as for `encode`.
        UnwritableFile: a directory or file cannot be written.
    """
    directory, name = os.path.split(os.path.abspath(path))
    return write_files(encode(mesh, name), directory)


def write_files(files: dict[str, bytes], directory: str) -> list[str]:
    """Write the result of `encode` to a directory, which is created if it is missing.

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
