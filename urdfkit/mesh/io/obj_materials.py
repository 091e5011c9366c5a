"""Materials of OBJ files: MTL."""

import numpy as np

from urdfkit.mesh.geometry import MeshMaterial
from urdfkit.mesh.io.assemble import LostData
from urdfkit.mesh.io.numbers import floats
from urdfkit.mesh.io.referenced_files import ReferencedFiles

#: Largest material file, in bytes.
MAX_LIBRARY = 4 * 1024 * 1024

#: Greatest number of words after the options of a texture; some may be missing.
_OPTIONS = {b"-mm": 2, b"-o": 3, b"-s": 3, b"-t": 3}


class MaterialLibrary:
    """The materials of one OBJ file.

    Args:
        names: MTL file names in the OBJ file.
        files: resolves MTL files and their images.
    """

    def __init__(self, names: list[str], files: ReferencedFiles, losses: LostData) -> None:
        self._materials: dict[str, MeshMaterial] = {}
        self._losses = losses
        self._files = files
        for name in dict.fromkeys(names):
            self._add(files.read(name, MAX_LIBRARY) or b"")

    def material(self, name: str) -> MeshMaterial | None:
        """The material with a name; the default colour if it is undefined; None without a name."""
        return self._materials.get(name, MeshMaterial(name)) if name else None

    def _add(self, data: bytes) -> None:
        name = ""
        for line in data.splitlines():
            word, _, rest = line.strip().replace(b"\t", b" ").partition(b" ")
            rest = rest.strip()
            if word == b"newmtl":
                name = rest.decode("utf-8", "replace")
                self._materials[name] = MeshMaterial(name)
            elif name:
                self._materials[name] = self._with(self._materials[name], word, rest)

    def _with(self, material: MeshMaterial, word: bytes, rest: bytes) -> MeshMaterial:
        """The material after another line."""
        red, green, blue, alpha = material.rgba
        if word == b"map_Kd":
            return self._textured(material, rest)
        if word not in (b"Kd", b"d", b"Tr"):
            return material
        numbers = floats(rest.removeprefix(b"-halo").decode("latin-1"))
        if not len(numbers) or not np.isfinite(numbers).all():
            self._losses.add(f"{word.decode()} value* of a material that cannot be read")
            return material
        values = [min(max(float(value), 0.0), 1.0) for value in numbers]
        if word == b"Kd":
            red, green, blue = (values * 3)[:3] if len(values) < 3 else values[:3]
        elif word == b"d":
            alpha = values[0]
        elif values[0] < 1:  # MeshLab writes Tr 1 for opaque materials
            alpha = 1 - values[0]
        return material._replace(rgba=(red, green, blue, alpha))

    def _textured(self, material: MeshMaterial, rest: bytes) -> MeshMaterial:
        name = _without_options(rest).decode("utf-8", "replace")
        return material._replace(texture=self._files.image(name))


def _without_options(rest: bytes) -> bytes:
    """The file name after the options of a texture."""
    words = rest.split(b" ")
    while words and words[0].startswith(b"-"):
        option = words.pop(0)
        for _ in range(_OPTIONS.get(option, 1)):
            if len(words) > 1 and (option not in _OPTIONS or _is_number(words[0])):
                words.pop(0)
    return b" ".join(words).strip()


def _is_number(word: bytes) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True
