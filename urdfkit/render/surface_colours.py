"""The colours of surfaces: materials, textures and light, for each fragment."""

from collections.abc import Sequence

import numpy as np

from urdfkit.render.arrays import Floats, Integers
from urdfkit.render.camera import Camera
from urdfkit.render.fragments import Fragments, FragmentSurface
from urdfkit.render.light import rig
from urdfkit.render.materials import SurfaceMaterial
from urdfkit.render.raster import Projected
from urdfkit.render.shading import Illumination, shaded
from urdfkit.render.soup import CameraTriangles
from urdfkit.render.textures import sample, srgb_to_linear, texture

#: How much is seen of an overlay that something hides.
HIDDEN = 0.45


class SurfaceColours:
    """Colours the fragments of one image.

    Args:
        screen: the vertices of these in the image.
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

    def opacity(self, some: Fragments, there: FragmentSurface, depth: Floats) -> Floats:
        """How much fragments hide of what is behind them, (k,); less of it if they are hidden."""
        rgba = np.array([one.rgba[3] for one in self._materials], dtype=np.float32)
        overlays = np.array([one.overlay for one in self._materials])
        item = self._soup.item[some.number]
        hidden = overlays[item] & (depth.reshape(-1)[some.pixel] < -there.position[:, 2])
        opacity: Floats = rgba[item] * np.where(hidden, np.float32(HIDDEN), np.float32(1))
        return opacity

    def light(self, some: Fragments, there: FragmentSurface, lit: Illumination) -> Floats:
        """The light that fragments send, (k, 3)."""
        item = self._soup.item[some.number]
        rgb = np.array([one.rgba[:3] for one in self._materials] or [(1, 1, 1)], dtype=np.float32)
        albedo = srgb_to_linear(rgb)[item]
        if there.color is not None:
            albedo = albedo * srgb_to_linear(there.color[:, :3])
        for index, one in enumerate(self._materials):
            if one.texture is not None:
                of_it = np.flatnonzero(item == index)
                if len(of_it):
                    albedo[of_it] *= self._textured(one, some, there, of_it)
        return shaded(
            albedo, there.position, there.normal, lit, self._rig, parallel=self._is_parallel
        )

    def _textured(
        self, material: SurfaceMaterial, some: Fragments, there: FragmentSurface, of_it: Integers
    ) -> Floats:
        """What a texture shows on fragments, (k, 3)."""
        assert material.texture is not None
        image = texture(material.texture)
        if image is None:
            return np.ones((len(of_it), 3), dtype=np.float32)
        faces = self._soup.faces[some.number[of_it]]
        assert self._soup.uv is not None
        assert there.uv is not None
        uv = [self._soup.uv[faces[:, corner]] for corner in range(3)]
        xy = [
            np.stack((self._screen.x[faces[:, i]], self._screen.y[faces[:, i]]), axis=1)
            for i in range(3)
        ]
        ratio = _area(*uv) / np.maximum(_area(*xy), np.float32(1e-6))
        return sample(image, there.uv[of_it], np.sqrt(ratio))


def _area(a: Floats, b: Floats, c: Floats) -> Floats:
    u, v = b - a, c - a
    return np.abs(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])
