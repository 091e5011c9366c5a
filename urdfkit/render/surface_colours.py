"""The colours of fragments: materials, textures and light."""

from collections.abc import Sequence

import numpy as np

from urdfkit.render.arrays import Floats, Integers
from urdfkit.render.camera import Camera
from urdfkit.render.fragments import Fragments, FragmentSurface
from urdfkit.render.light import rig
from urdfkit.render.raster import Projected
from urdfkit.render.shading import Illumination, shaded
from urdfkit.render.soup import CameraTriangles
from urdfkit.render.textures import sample, srgb_to_linear, texture
from urdfkit.ros.surface_materials import SurfaceMaterial

#: Opacity of hidden overlays.
HIDDEN = 0.45


class SurfaceColours:
    """Colours the fragments of one image.

    Args:
        screen: the vertices of the triangles in the image.
    """

    def __init__(
        self,
        materials: Sequence[SurfaceMaterial],
        soup: CameraTriangles,
        screen: Projected,
        camera: Camera,
    ) -> None:
        self._materials, self._soup, self._screen = materials, soup, screen
        self._rig, self._is_parallel = rig(camera), camera.is_orthographic

    def opacity(self, fragments: Fragments, surface: FragmentSurface, depth: Floats) -> Floats:
        """(k,), opacity of fragments; reduced for hidden overlays."""
        rgba = np.array([material.rgba[3] for material in self._materials], dtype=np.float32)
        overlays = np.array([material.overlay for material in self._materials])
        item = self._soup.item[fragments.number]
        hidden = overlays[item] & (depth.reshape(-1)[fragments.pixel] < -surface.position[:, 2])
        return np.asarray(rgba[item] * np.where(hidden, np.float32(HIDDEN), np.float32(1)))

    def light(self, fragments: Fragments, surface: FragmentSurface, lit: Illumination) -> Floats:
        """(k, 3), the light that fragments emit."""
        item = self._soup.item[fragments.number]
        rgb = [material.rgba[:3] for material in self._materials] or [(1, 1, 1)]
        albedo = srgb_to_linear(np.array(rgb, dtype=np.float32))[item]
        if surface.color is not None:
            albedo = albedo * srgb_to_linear(surface.color[:, :3])
        for index, material in enumerate(self._materials):
            if material.texture is not None:
                textured = np.flatnonzero(item == index)
                if len(textured):
                    albedo[textured] *= self._texture_colours(
                        material, fragments, surface, textured
                    )
        return shaded(
            albedo, surface.position, surface.normal, lit, self._rig, parallel=self._is_parallel
        )

    def _texture_colours(
        self,
        material: SurfaceMaterial,
        fragments: Fragments,
        surface: FragmentSurface,
        rows: Integers,
    ) -> Floats:
        """(k, 3), colours of a texture on the fragments with some indices."""
        assert material.texture is not None
        image = texture(material.texture)
        if image is None:
            return np.ones((len(rows), 3), dtype=np.float32)
        faces = self._soup.faces[fragments.number[rows]]
        assert self._soup.uv is not None
        assert surface.uv is not None
        uv = [self._soup.uv[faces[:, corner]] for corner in range(3)]
        xy = [
            np.stack((self._screen.x[faces[:, i]], self._screen.y[faces[:, i]]), axis=1)
            for i in range(3)
        ]
        ratio = _area(*uv) / np.maximum(_area(*xy), np.float32(1e-6))
        return sample(image, surface.uv[rows], np.sqrt(ratio))


def _area(a: Floats, b: Floats, c: Floats) -> Floats:
    u, v = b - a, c - a
    return np.abs(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])
