"""The materials of glTF: base colour and its texture."""

from typing import NamedTuple

import numpy as np

from urdfkit.mesh.geometry import Floats, MeshMaterial
from urdfkit.mesh.io.gltf_accessors import Accessors, GltfObject, embedded
from urdfkit.mesh.io.referenced_files import ReferencedFiles

_WHITE = (1.0, 1.0, 1.0, 1.0)
#: What has the base colour and its texture, and what had them in older exporters.
_BASE = ("baseColorFactor", "baseColorTexture")
_OLDER = "KHR_materials_pbrSpecularGlossiness"
_DIFFUSE = ("diffuseFactor", "diffuseTexture")
_AS_THEY_ARE = np.eye(2, 3)


class GltfMaterial(NamedTuple):
    """A material, and how its texture maps the coordinates."""

    material: MeshMaterial | None = None  # the material
    coordinates: int = 0  # which of the sets of them the texture takes
    transform: Floats = _AS_THEY_ARE  # (2, 3), from these to places in the image

    def placed(self, uv: Floats) -> Floats:
        """(n, 2), from coordinates as the file gives them to ours, with v upwards."""
        u, v = self.transform[:, :2] @ uv.T + self.transform[:, 2:]
        return np.column_stack([u, 1 - v])


class GltfMaterials:
    """The materials of one file.

    Args:
        files: finds the images that the file does not hold itself.
    """

    def __init__(self, root: GltfObject, lists: Accessors, files: ReferencedFiles) -> None:
        self._root = root
        self._lists = lists
        self._files = files
        self._known: dict[int, GltfMaterial] = {}

    def material(self, index: int) -> GltfMaterial:
        """A material, by its place in the file."""
        if index not in self._known:
            self._known[index] = self._read(self._root["materials"][index])
        return self._known[index]

    def _read(self, material: GltfObject) -> GltfMaterial:
        factor, textured = _BASE
        base, extensions = material.get("pbrMetallicRoughness"), material.get("extensions", {})
        if base is None:
            base, (factor, textured) = extensions.get(_OLDER, {}), _DIFFUSE
        red, green, blue, alpha = map(float, np.clip(base.get(factor, _WHITE), 0, 1))
        if material.get("alphaMode", "OPAQUE") == "OPAQUE":
            alpha = 1.0
        found = MeshMaterial(str(material.get("name", "")), (red, green, blue, alpha))
        texture = base.get(textured)
        if texture is None:
            return GltfMaterial(found)
        transform = texture.get("extensions", {}).get("KHR_texture_transform", {})
        image = self._image(self._root["textures"][texture["index"]])
        which = transform.get("texCoord", texture.get("texCoord", 0))
        return GltfMaterial(found._replace(texture=image), which, _matrix(transform))

    def _image(self, texture: GltfObject) -> str | bytes | None:
        """The file or the bytes of an image; None if it is not there, or of a newer format."""
        webp = texture.get("extensions", {}).get("EXT_texture_webp", {})
        source = texture.get("source", webp.get("source"))
        if source is None:
            return None
        image = self._root["images"][source]
        if "bufferView" in image:
            return bytes(self._lists.view(image["bufferView"]))
        data = embedded(image["uri"])
        return self._files.image(image["uri"]) if data is None else data


def _matrix(transform: GltfObject) -> Floats:
    """(2, 3), of KHR_texture_transform: scaled, turned, moved."""
    angle = transform.get("rotation", 0.0)
    cos, sin = np.cos(angle), np.sin(angle)
    turned = np.array([(cos, sin), (-sin, cos)]) * transform.get("scale", (1.0, 1.0))
    return np.column_stack([turned, transform.get("offset", (0.0, 0.0))])
