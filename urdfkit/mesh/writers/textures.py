"""Textures of a written mesh: their bytes and file names."""

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
    """File names for the textures of a mesh, in the directory of its file.

    Returns:
        The texture name of each part that has one, and the contents by name. Equal contents are
        written once; a file keeps its name unless another texture has it.
    """
    stem = os.path.splitext(name)[0]
    names: dict[int, str] = {}
    contents: dict[str, bytes] = {}
    for number, part in enumerate(mesh.parts):
        data = texture_bytes(part.material)
        if data is None or part.material is None:
            continue
        texture = part.material.texture
        preferred = os.path.basename(texture) if isinstance(texture, str) else ""
        if not preferred.lower().endswith(_SUFFIXES):  # a mesh must not choose an arbitrary suffix
            preferred = f"{stem}{_suffix(data)}"
        names[number] = _unused_name(preferred, data, contents)
        contents[names[number]] = data
    return names, contents


def _suffix(data: bytes) -> str:
    return next((suffix for magic, suffix in _KINDS if data.startswith(magic)), ".png")


def _unused_name(preferred: str, data: bytes, contents: dict[str, bytes]) -> str:
    stem, suffix = os.path.splitext(preferred)
    name, number = preferred, 1
    while contents.get(name, data) != data:
        number += 1
        name = f"{stem}_{number}{suffix}"
    return name
