"""The images that mesh files name."""

from __future__ import annotations

import os
from urllib.parse import unquote


def find_image(name: str, folder: str) -> str | None:
    """The file of an image that a mesh file in a folder names; None if it is not there.

    Names are paths or URIs. Those of other machines end in the file's own name, which often lies
    beside the mesh; Gazebo and assimp search it there too.
    """
    plain = name.strip().removeprefix("file://").replace("\\", "/")
    for path in dict.fromkeys((plain, unquote(plain), os.path.basename(unquote(plain)))):
        found = os.path.join(folder, path)
        try:
            if os.path.isfile(found):
                return os.path.normpath(found)
        except ValueError:  # a NUL in the name
            return None
    return None
