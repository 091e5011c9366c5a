"""Files that mesh files reference: images, materials of OBJ, buffers of glTF."""

from __future__ import annotations

import os
from functools import lru_cache

from urdfkit.core import disk
from urdfkit.core.paths import is_within
from urdfkit.core.static_typing import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.mesh.geometry import Mesh


def find_image(name: str, directory: str) -> str | None:
    """The path of an image that a mesh file references; None if it does not exist.

    Names are paths or URIs. Of an absolute path from another machine, only the file name is used,
    and searched next to the mesh, as in Gazebo and assimp.
    """
    from urllib.parse import unquote  # 4 ms, and few meshes have images

    plain = name.strip().removeprefix("file://").replace("\\", "/")
    for path in dict.fromkeys((plain, unquote(plain), os.path.basename(unquote(plain)))):
        candidate = os.path.normpath(os.path.join(directory, path))
        try:
            if disk.is_file(candidate) and _may_be_read(candidate, directory):
                return candidate
        except ValueError:  # a NUL in the name
            return None
    return None


class ReferencedFiles:
    """Records all files that one mesh file references.

    Args:
        directory: the directory of the mesh file, to which names are relative.
    """

    def __init__(self, directory: str) -> None:
        self._directory = directory
        self._textures: list[str] = []
        self._missing: list[str] = []
        self._files: list[str] = []

    def image(self, name: str) -> str | None:
        """The path of an image; None if it does not exist."""
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
        """The bytes of a file; None as for the function `read`."""
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
    """The path of a file that a mesh file in a directory references; it need not exist."""
    return os.path.normpath(os.path.join(directory, name.replace("\\", "/")))


def read(path: str, most: int, directory: str) -> bytes | None:
    """The bytes of a file that a mesh file in a directory references.

    None if the file does not exist, is outside the workspace or package of the mesh, or has more
    than ``most`` bytes.
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
    """True for a file in the directory of a mesh file or in its workspace."""
    real = disk.real(path)
    if is_within(real, disk.real(directory)):
        return True
    return any(is_within(real, root) for root in _roots(directory))


@lru_cache(maxsize=256)
def _roots(directory: str) -> tuple[str, ...]:
    """The workspaces of a directory: of its path, and of its path without symbolic links."""
    from urdfkit.workspace.resolve import Resolver  # few meshes use files of other directories

    packages = Resolver().packages
    paths = (os.path.abspath(directory), disk.real(directory))
    return tuple(disk.real(packages.workspace(os.path.join(path, "x"))) for path in paths)
