"""Textures on their way into another file: bytes, or a file next to the mesh."""

import os

from urdfkit.core import disk
from urdfkit.mesh.geometry import Mesh, MeshMaterial
from urdfkit.mesh.writers import UnwritableMesh

_KINDS = ((b"\x89PNG", ".png"), (b"\xff\xd8\xff", ".jpg"), (b"RIFF", ".webp"), (b"BM", ".bmp"))
_SUFFIXES = (".png", ".jpg", ".jpeg", ".webp", ".bmp", ".tga", ".tif", ".tiff", ".gif", ".dds")


def texture_bytes(material: MeshMaterial | None) -> bytes | None:
    """The content of the texture of a material; None without one.

    Raises:
        UnwritableMesh: the file cannot be read.
    """
    if material is None or material.texture is None:
        return None
    if isinstance(material.texture, bytes):
        return material.texture
    try:
        return disk.read(material.texture)
    except OSError as error:
        reason = error.strerror or error
        raise UnwritableMesh(f"texture {material.texture}: cannot be read: {reason}") from error


def texture_files(mesh: Mesh, name: str) -> tuple[dict[int, str], dict[str, bytes]]:
    """Names for the textures of a mesh, next to its file.

    Returns:
        The name of the texture of each part that has one, and the contents by name. Equal
        contents are written once; a file keeps its name unless another one has it.
    """
    stem = os.path.splitext(name)[0]
    names: dict[int, str] = {}
    contents: dict[str, bytes] = {}
    for number, part in enumerate(mesh.parts):
        data = texture_bytes(part.material)
        if data is None or part.material is None:
            continue
        texture = part.material.texture
        wanted = os.path.basename(texture) if isinstance(texture, str) else ""
        if not wanted.lower().endswith(_SUFFIXES):  # a mesh must not name any file to be written
            wanted = f"{stem}{_kind(data)}"
        names[number] = _free(wanted, data, contents)
        contents[names[number]] = data
    return names, contents


def _kind(data: bytes) -> str:
    return next((suffix for magic, suffix in _KINDS if data.startswith(magic)), ".png")


def _free(wanted: str, data: bytes, contents: dict[str, bytes]) -> str:
    stem, suffix = os.path.splitext(wanted)
    name, number = wanted, 1
    while contents.get(name, data) != data:
        number += 1
        name = f"{stem}_{number}{suffix}"
    return name
