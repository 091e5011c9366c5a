"""The files that mesh files name: images, and the materials of OBJ."""

from __future__ import annotations

import os

#: No file of materials is larger.
MAX_LIBRARY = 4 * 1024 * 1024


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


def read_library(name: str, folder: str) -> bytes | None:
    """The materials that an OBJ file in a folder names; None if they are not there."""
    path = os.path.join(folder, name.replace("\\", "/"))
    try:
        if not os.path.isfile(path) or os.path.getsize(path) > MAX_LIBRARY:
            return None
        with open(path, "rb") as file:
            return file.read()
    except (OSError, ValueError):
        return None
