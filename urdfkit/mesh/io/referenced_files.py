"""The files that mesh files name: images, the materials of OBJ, the numbers of glTF."""

from __future__ import annotations

import os


def find_image(name: str, folder: str) -> str | None:
    """The file of an image that a mesh file in a folder names; None if it is not there.

    Names are paths or URIs. Those of other machines end in the file's own name, which often lies
    beside the mesh; Gazebo and assimp search it there too.
    """
    from urllib.parse import unquote  # 4 ms, and few meshes name images

    plain = name.strip().removeprefix("file://").replace("\\", "/")
    for path in dict.fromkeys((plain, unquote(plain), os.path.basename(unquote(plain)))):
        found = os.path.join(folder, path)
        try:
            if os.path.isfile(found):
                return os.path.normpath(found)
        except ValueError:  # a NUL in the name
            return None
    return None


def place(name: str, folder: str) -> str:
    """Where a file lies, or would, that a mesh file in a folder names."""
    return os.path.normpath(os.path.join(folder, name.replace("\\", "/")))


def read(path: str, most: int) -> bytes | None:
    """What a file holds; None if it is not there, or has more than some bytes."""
    try:
        if not os.path.isfile(path) or os.path.getsize(path) > most:
            return None
        with open(path, "rb") as file:
            return file.read(most)
    except (OSError, ValueError):
        return None
