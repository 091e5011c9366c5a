"""Renders a scene.

Three passes over bands of rows, so that memory does not grow with the height of an image: visible
surfaces, light, and colours. Results do not depend on the order of the bands, so the bytes are the
same for any number of threads.
"""

import itertools
from typing import NamedTuple, TypedDict

import numpy as np

from urdfkit.core.progress import Progress, silent
from urdfkit.render.arrays import FAR, Bytes, Floats, Integers, Keys, rotated
from urdfkit.render.camera import Camera
from urdfkit.render.fragments import Fragments, FragmentSurface, fragments_of, surface_of
from urdfkit.render.ground import Ground, ground, without_shadows
from urdfkit.render.light import LATTICE, ShadowMap, rig, shadow_map, sunlight
from urdfkit.render.occlusion import openness
from urdfkit.render.pixels import STUDIO, Background, encoded, gradient, matching, means, summed
from urdfkit.render.raster import Grid, Projected, nearest, projected, rooks
from urdfkit.render.scene import Scene
from urdfkit.render.shading import Illumination
from urdfkit.render.soup import CameraTriangles, chosen_triangles, cut, extent, rows, soup
from urdfkit.render.surface_colours import SurfaceColours
from urdfkit.render.textures import texture
from urdfkit.render.thread_pool import Workers
from urdfkit.ros.surface_materials import SurfaceMaterial

#: Rows of pixels in a band.
BAND = 60
#: Most layers of translucent surfaces.
MAX_LAYERS = 4
#: Opacity above which a surface is opaque.
MIN_OPAQUE = 0.98
#: Offset of collisions towards the camera, as a part of the robot's size.
COLLISION_OFFSET = 0.004
#: Radius of ambient occlusion, as a part of the robot's size.
OCCLUSION_RADIUS = 0.12
#: Depth difference up to which light is averaged over a lattice, as a part of the robot's size.
LATTICE_DEPTH = 0.012

_OPAQUE, _CLEAR, _OVERLAY = range(3)


class Quality(NamedTuple):
    """Numbers of samples of an image."""

    samples: int  # for each pixel, for smooth edges
    #: sky and sun: for ambient occlusion and shadows; 0 disables them.
    sky: int
    sun: int


QUALITIES = {"draft": Quality(3, 0, 4), "default": Quality(6, 16, 10), "high": Quality(16, 32, 16)}


#: Hard edges without shadows, for comparisons.
_SAMPLES = Quality(1, 0, 0)


class DrawingOptions(TypedDict, total=False):
    """Keyword arguments of `draw`, except the level of the ground."""

    quality: str
    background: Background | None
    floor: bool
    threads: int | None


class _Light(NamedTuple):
    """Results of the first two passes for the pixels, (h, w) each."""

    depth: Floats  # of the nearest surface; `FAR` without a surface
    #: sky and sun: visible parts of the sky and the sun, from 0 to 1.
    sky: Floats
    sun: Floats


class _Band(NamedTuple):
    """Results of the first pass for a band."""

    opaque: tuple[Fragments, FragmentSurface]
    clear: tuple[tuple[Fragments, FragmentSurface], ...]
    overlays: tuple[tuple[Fragments, FragmentSurface], ...]
    dark: Floats


def draw(
    scene: Scene,
    camera: Camera,
    *,
    quality: str = "default",
    background: Background | None = STUDIO,
    floor: bool = True,
    level: float | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
) -> Bytes:
    """Draw a scene.

    Args:
        quality: a name of `QUALITIES`.
        background: colours at top and bottom, sRGB from 0 to 1; None for transparent.
        floor: True for a ground with shadows.
        level: height of the ground in m; None for the robot's lowest point.
        threads: number of threads; None for the number of processors. It does not change the bytes.
        progress: called with the number of finished steps and of all.

    Returns:
        (h, w, 4), RGBA, sRGB, not premultiplied.
    """
    drawing = _Drawing(scene, camera, QUALITIES[quality], Workers(threads), floor, level)
    return drawing.image(background, progress or silent)


class Samples(NamedTuple):
    """A robot without ground and shadows, with one sample for each pixel."""

    pixels: Bytes  # (h, w, 4), as from `draw`
    depth: Floats  # (h, w), in m; `FAR` without a surface

    def rows(self, first: int, last: int) -> "Samples":
        return Samples(self.pixels[first:last], self.depth[first:last])


def samples(scene: Scene, camera: Camera) -> Samples:
    """Draw a scene for comparisons."""
    drawing = _Drawing(scene, camera, _SAMPLES, Workers(None), floor=False, level=None)
    return Samples(drawing.image(None, silent), drawing.depth)


class _Drawing:
    """The state of drawing one image."""

    def __init__(
        self,
        scene: Scene,
        camera: Camera,
        quality: Quality,
        workers: Workers,
        floor: bool,
        level: float | None,
    ) -> None:
        self.scene, self.camera, self.quality, self.workers = scene, camera, quality, workers
        everything = soup(scene, camera)
        materials = [item.material for item in scene.items]
        textures = {material.texture for material in materials if material.texture}
        workers.each(sorted(textures, key=str), texture)
        self.kinds = [_kind(material) for material in materials]
        pieces = list(zip(everything.pieces, self.kinds, strict=True))
        solid = [piece for piece, kind in pieces if kind == _OPAQUE]
        robot = [piece for piece, kind in pieces if kind != _OVERLAY] or everything.pieces
        casts = rows(everything.faces, self._kind(everything) == _OPAQUE)
        axes = np.asarray(camera.axes, dtype=np.float32).T
        world = rotated(everything.points, axes) + np.asarray(camera.eye, dtype=np.float32)
        lowest, highest = extent(world, robot)
        self.size = float((highest - lowest).max()) or 1.0
        self.sun: ShadowMap = shadow_map(everything, casts, solid, rig(camera), workers)
        self.floor: Ground | None = None
        if floor and len(casts):
            self.floor = ground(world, casts, solid, self.sun, camera, level, workers)
        elif floor:
            self.floor = without_shadows(lowest, highest, camera, level)
        self.screen, self.soup = self._projected(cut(everything, camera), (lowest + highest) / 2)
        kind = self._kind(self.soup)
        self.opaque, self.clear, self.overlays = (
            np.flatnonzero(kind == group) for group in (_OPAQUE, _CLEAR, _OVERLAY)
        )
        self.colours = SurfaceColours(materials, self.soup, self.screen, camera)
        self.offsets = rooks(quality.samples)
        width, height = camera.size
        self.depth = np.full((height, width), FAR, dtype=np.float32)

    def _projected(
        self, everything: CameraTriangles, middle: Floats
    ) -> tuple[Projected, CameraTriangles]:
        """The triangles that may be in the image, in the image and in the camera frame."""
        x, y, near = self.camera.project(everything.points)
        self._lift(near, everything, middle)
        screen, chosen = projected(x, y, near, everything.faces, self.camera.size[0])
        is_whole = len(chosen) == len(everything.faces)
        return screen, everything if is_whole else chosen_triangles(everything, chosen)

    def image(self, background: Background | None, progress: Progress) -> Bytes:
        width, height = self.camera.size
        bands: dict[int, _Band] = {}
        count, steps = 3 * -(-height // BAND), itertools.count(1)

        def render_surfaces(first: int, last: int) -> None:
            bands[first] = self._render_surfaces(first, last)
            progress(next(steps), count)

        self.workers.bands(height, BAND, render_surfaces)
        light = _Light(self.depth, np.ones_like(self.depth), np.ones_like(self.depth))

        def compute_light(first: int, _last: int) -> None:
            self._compute_light(bands[first].opaque, light)
            progress(next(steps), count)

        self.workers.bands(height, BAND, compute_light)
        result = np.empty((height, width, 4), dtype=np.uint8)

        def compose(first: int, last: int) -> None:
            result[first:last] = self._compose(bands.pop(first), first, last, light, background)
            progress(next(steps), count)

        self.workers.bands(height, BAND, compose)
        return result

    def _kind(self, triangles: CameraTriangles) -> Integers:
        """(m,), kind of each triangle: opaque, translucent, or an overlay."""
        return np.asarray(np.array(self.kinds, dtype=np.int8)[triangles.item])

    def _lift(self, near: Floats, everything: CameraTriangles, middle: Floats) -> None:
        """Move translucent collisions and contacts slightly towards the camera.

        Many coincide with their visuals; without an offset, both would be visible in patches.

        Args:
            near: nearness of the vertices.
            middle: of the robot, in the world.
        """
        step = np.float32(COLLISION_OFFSET * self.size)
        distance = float(np.dot(np.asarray(self.camera.eye) - middle, self.camera.axes[2]))
        for item, piece, kind in zip(self.scene.items, everything.pieces, self.kinds, strict=True):
            if item.role not in ("collision", "contacts") or kind == _OPAQUE:
                continue
            if self.camera.is_orthographic:
                near[piece] += step
            else:
                near[piece] *= 1 + step / np.float32(max(distance, self.size))

    # -- the first pass: visible surfaces --

    def _render_surfaces(self, first: int, last: int) -> _Band:
        """The surfaces of a band; stores their depth."""
        grid = Grid(self.camera.size[0], first, last, self.offsets)
        keys = nearest(self.screen, self.opaque, grid)
        opaque = self._with_surface(fragments_of(keys, grid))
        dark = np.zeros((0,), dtype=np.float32)
        if self.floor is not None:
            self.depth[first:last], dark = self.floor.render_band(self.camera, first, last)
        self._store_depth(*opaque)
        clear = self._peeled(self.clear, grid, keys)
        overlays = self._peeled(self.overlays, grid, np.zeros_like(keys))
        return _Band(opaque, clear, overlays, dark.reshape(-1))

    def _peeled(
        self, numbers: Integers, grid: Grid, above: Keys
    ) -> tuple[tuple[Fragments, FragmentSurface], ...]:
        """The visible translucent surfaces, the nearest layer first (depth peeling)."""
        layers = []
        below = None
        for _ in range(MAX_LAYERS if len(numbers) else 0):
            below = nearest(self.screen, numbers, grid, above=above, below=below)
            if not below.any():
                break
            layers.append(self._with_surface(fragments_of(below, grid)))
        return tuple(layers)

    def _with_surface(self, fragments: Fragments) -> tuple[Fragments, FragmentSurface]:
        return fragments, surface_of(fragments, self.soup, self.screen, self.camera)

    def _store_depth(self, fragments: Fragments, surface: FragmentSurface) -> None:
        """Give pixels the depth of their largest fragments."""
        order = np.argsort(fragments.weight, kind="stable")
        self.depth.reshape(-1)[fragments.pixel[order]] = -surface.position[order, 2]

    # -- the second pass: light --

    def _compute_light(self, opaque: tuple[Fragments, FragmentSurface], light: _Light) -> None:
        """Compute the light on the largest surface of each pixel, with grain."""
        fragments, surface = opaque
        shown = np.flatnonzero(light.depth.reshape(-1)[fragments.pixel] == -surface.position[:, 2])
        pixel, position = fragments.pixel[shown], surface.position[shown]
        width = self.camera.size[0]
        if self.quality.sky:
            light.sky.reshape(-1)[pixel] = openness(
                light.depth,
                self.camera,
                position,
                surface.normal[shown],
                pixel,
                OCCLUSION_RADIUS * self.size,
                self.quality.sky,
            )
        if self.quality.sun:
            light.sun.reshape(-1)[pixel] = sunlight(
                self.sun, position, surface.flat[shown], pixel, width, self.quality.sun
            )

    # -- the third pass: colours --

    def _compose(
        self, band: _Band, first: int, last: int, light: _Light, background: Background | None
    ) -> Bytes:
        width = self.camera.size[0]
        fragments, surface = band.opaque
        start, count = first * width, (last - first) * width
        near = light.depth[first:last]
        place = matching(fragments.pixel - start, -surface.position[:, 2], near, self._near)
        light_of_band = means((light.sun, light.sky), light.depth, first, last, self._near)
        lit = Illumination(*(image[place] for image in light_of_band))
        pixels, cover = summed(fragments, self.colours.light(fragments, surface, lit), start, count)
        free = 1 - cover
        dark = band.dark if len(band.dark) else np.zeros_like(free)
        if background is None:
            alpha = cover + free * dark
        else:
            alpha = np.ones_like(cover)
            behind = gradient(background, first, last, self.camera.size)
            pixels.reshape(-1, width, 3)[:] += (free * (1 - dark)).reshape(-1, width, 1) * behind
        for layer, surfaces in (*reversed(band.clear), *reversed(band.overlays)):
            opacity = self.colours.opacity(layer, surfaces, light.depth)
            ones = np.ones(len(layer.pixel), dtype=np.float32)
            colours = self.colours.light(layer, surfaces, Illumination(ones, ones))
            weighted = layer._replace(weight=layer.weight * opacity)
            over, part = summed(weighted, colours, start, count)
            pixels = over + pixels * (1 - part)[:, None]
            alpha = part + alpha * (1 - part)
        return encoded(pixels, alpha).reshape(last - first, width, 4)

    def _near(self, depth: Floats) -> Floats:
        """Greatest depth difference within one surface across a lattice square."""
        pixel = np.float32(1 / self.camera.scale)
        step = pixel * depth if not self.camera.is_orthographic else np.full_like(depth, pixel)
        return np.asarray(np.float32(LATTICE_DEPTH * self.size) + np.float32(LATTICE) * step)


def _kind(material: SurfaceMaterial) -> int:
    if material.overlay:
        return _OVERLAY
    return _OPAQUE if material.rgba[3] > MIN_OPAQUE else _CLEAR
