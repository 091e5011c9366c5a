"""The files that mesh files name: images, the materials of OBJ, the numbers of glTF."""

from __future__ import annotations

import os
from functools import lru_cache

from urdfkit.core import disk
from urdfkit.core.paths import is_within
from urdfkit.core.static_typing import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.mesh.geometry import Mesh


def find_image(name: str, directory: str) -> str | None:
    """The file of an image that a mesh file in a directory names; None if it is not there.

    Names are paths or URIs. Those of other machines end in the file's own name, which often lies
    next to the mesh; Gazebo and assimp search it there too.
    """
    from urllib.parse import unquote  # 4 ms, and few meshes name images

    plain = name.strip().removeprefix("file://").replace("\\", "/")
    for path in dict.fromkeys((plain, unquote(plain), os.path.basename(unquote(plain)))):
        found = os.path.normpath(os.path.join(directory, path))
        try:
            if disk.is_file(found) and _may_be_read(found, directory):
                return found
        except ValueError:  # a NUL in the name
            return None
    return None


class ReferencedFiles:
    """The files that one mesh file names, each as often as it is named.

    Args:
        directory: that the mesh file is in; names are relative to it.
    """

    def __init__(self, directory: str) -> None:
        self._directory = directory
        self._textures: list[str] = []
        self._missing: list[str] = []
        self._files: list[str] = []

    def image(self, name: str) -> str | None:
        """The file of an image; None if it is not there."""
        self._textures.append(name)
        path = find_image(name, self._directory)
        if path is None:
            from urllib.parse import unquote

            self._missing.append(name)
            self._files.append(place(unquote(name), self._directory))
        else:
            self._files.append(path)
        return path

    def read(self, name: str, most: int) -> bytes | None:
        """What another file holds; None if it is not there, or has more than some bytes."""
        path = place(name, self._directory)
        self._files.append(path)
        data = read(path, most, self._directory)
        if data is None:
            self._missing.append(name)
        return data

    def added_to(self, mesh: Mesh) -> Mesh:
        return mesh._replace(
            textures=tuple(dict.fromkeys(self._textures)),
            missing=tuple(dict.fromkeys(self._missing)),
            files=tuple(dict.fromkeys(self._files)),
        )


def place(name: str, directory: str) -> str:
    """Where a file lies, or would, that a mesh file in a directory names."""
    return os.path.normpath(os.path.join(directory, name.replace("\\", "/")))


def read(path: str, most: int, directory: str) -> bytes | None:
    """What a file holds that a mesh file in a directory names.

    None if it is not there, lies outside the workspace or package of the mesh, or has more than
    some bytes.
    """
    try:
        if not disk.is_file(path) or disk.state(path).st_size > most:
            return None
        if not _may_be_read(path, directory):
            return None
        return disk.read(path, most)
    except (OSError, ValueError):
        return None


def _may_be_read(path: str, directory: str) -> bool:
    """True for a file in the directory of a mesh file, or else in its workspace."""
    real = disk.real(path)
    if is_within(real, disk.real(directory)):
        return True
    return any(is_within(real, root) for root in _roots(directory))


@lru_cache(maxsize=256)
def _roots(directory: str) -> tuple[str, ...]:
    """The workspaces of a directory: of its path, and of where that leads."""
    from urdfkit.workspace.resolve import Resolver  # few meshes name files of other directories

    packages = Resolver().packages
    near = (os.path.join(at, "x") for at in (os.path.abspath(directory), disk.real(directory)))
    return tuple(disk.real(packages.workspace(one)) for one in near)
