"""Materials with textures in MJCF."""

import os
from typing import Any

import mujoco

from urdfkit.core import atomic
from urdfkit.mesh.geometry import MeshMaterial
from urdfkit.mesh.writers import UnwritableMesh
from urdfkit.mesh.writers.textures import texture_bytes
from urdfkit.output.bundle.meshes import FreeNames
from urdfkit.ros.surface_materials import SurfaceMaterial


class Textures:
    """The materials of a specification that have a texture; each image is written once.

    Args:
        directory: base of the paths of its files.
    """

    def __init__(self, spec: Any, directory: str) -> None:
        self._spec = spec
        self._directory = directory
        self._materials: dict[SurfaceMaterial, str] = {}
        self._names: dict[bytes, str] = {}  # by image
        self._free, self._free_materials = FreeNames(), FreeNames()

    def material(self, surface: SurfaceMaterial) -> str:
        """Name of the material of a surface; empty if it has no readable image."""
        if surface not in self._materials:
            image = _png(surface)
            self._materials[surface] = self._added(surface, image) if image else ""
        return self._materials[surface]

    def reason(self, surface: SurfaceMaterial) -> str:
        """Why a surface has no texture; empty if it has one."""
        return "" if self.material(surface) else "the image cannot be read"

    def _added(self, surface: SurfaceMaterial, image: bytes) -> str:
        source = surface.texture if isinstance(surface.texture, str) else "texture"
        stem = os.path.splitext(os.path.basename(source))[0]
        if image not in self._names:
            self._names[image] = name = self._free.take(stem)
            path = f"textures/{name}.png"
            atomic.make_directory(os.path.join(self._directory, "textures"))
            atomic.write(os.path.join(self._directory, path), image, durable=False)
            kind = mujoco.mjtTexture.mjTEXTURE_2D
            self._spec.add_texture(name=name, type=kind, file=path)
        name = self._names[image]
        material = self._free_materials.take(name)
        spec_material = self._spec.add_material(name=material, rgba=surface.rgba)
        spec_material.textures[mujoco.mjtTextureRole.mjTEXROLE_RGB] = name
        return material


def _png(surface: SurfaceMaterial) -> bytes | None:
    """The image of a surface as a PNG, the only format that MuJoCo reads; None without one.

    A PNG is encoded again, because MuJoCo rejects some valid files.
    """
    try:
        data = texture_bytes(MeshMaterial(texture=surface.texture))
    except UnwritableMesh:
        return None
    if not data:
        return None
    from urdfkit.render.textures import texture  # few robots have textures

    image = texture(data)
    return image.png() if image else None
