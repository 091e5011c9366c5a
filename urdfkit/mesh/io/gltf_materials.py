"""The materials of glTF: base colour and its texture."""

from typing import NamedTuple

import numpy as np

from urdfkit.mesh.geometry import Floats, MeshMaterial
from urdfkit.mesh.io.gltf_accessors import Accessors, GltfObject, embedded
from urdfkit.mesh.io.referenced_files import ReferencedFiles

_WHITE = (1.0, 1.0, 1.0, 1.0)
#: Properties for the base colour and its texture, and those of older exporters.
_BASE = ("baseColorFactor", "baseColorTexture")
_OLDER = "KHR_materials_pbrSpecularGlossiness"
_DIFFUSE = ("diffuseFactor", "diffuseTexture")
_IDENTITY = np.eye(2, 3)


class GltfMaterial(NamedTuple):
    """A material and its texture mapping."""

    material: MeshMaterial | None = None
    coordinates: int = 0  # index of the set of texture coordinates
    transform: Floats = _IDENTITY  # (2, 3), from texture coordinates to the image

    def image_coordinates(self, uv: Floats) -> Floats:
        """(n, 2), transformed texture coordinates with v upwards; in glTF, v is downwards."""
        u, v = self.transform[:, :2] @ uv.T + self.transform[:, 2:]
        return np.column_stack([u, 1 - v])


class GltfMaterials:
    """The materials of one file.

    Args:
        files: resolves images that are not embedded.
    """

    def __init__(self, root: GltfObject, lists: Accessors, files: ReferencedFiles) -> None:
        self._root = root
        self._lists = lists
        self._files = files
        self._cache: dict[int, GltfMaterial] = {}

    def material(self, index: int) -> GltfMaterial:
        """The material of an index."""
        if index not in self._cache:
            self._cache[index] = self._read(self._root["materials"][index])
        return self._cache[index]

    def _read(self, material: GltfObject) -> GltfMaterial:
        factor, texture_key = _BASE
        base, extensions = material.get("pbrMetallicRoughness"), material.get("extensions", {})
        if base is None:
            base, (factor, texture_key) = extensions.get(_OLDER, {}), _DIFFUSE
        red, green, blue, alpha = map(float, np.clip(base.get(factor, _WHITE), 0, 1))
        if material.get("alphaMode", "OPAQUE") == "OPAQUE":
            alpha = 1.0
        result = MeshMaterial(str(material.get("name", "")), (red, green, blue, alpha))
        texture = base.get(texture_key)
        if texture is None:
            return GltfMaterial(result)
        transform = texture.get("extensions", {}).get("KHR_texture_transform", {})
        image = self._image(self._root["textures"][texture["index"]])
        uv_set = transform.get("texCoord", texture.get("texCoord", 0))
        return GltfMaterial(result._replace(texture=image), uv_set, _matrix(transform))

    def _image(self, texture: GltfObject) -> str | bytes | None:
        """The path or the bytes of an image; None if it is missing, or in a newer format."""
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
    """(2, 3), of KHR_texture_transform: scaling, rotation, translation."""
    angle = transform.get("rotation", 0.0)
    cos, sin = np.cos(angle), np.sin(angle)
    linear = np.array([(cos, sin), (-sin, cos)]) * transform.get("scale", (1.0, 1.0))
    return np.column_stack([linear, transform.get("offset", (0.0, 0.0))])
