"""A scene and a camera become an image.

Three passes on bands of rows, so that memory does not grow with the height of an image:
which surfaces the pixels see, how much light reaches them, and their colours. Nothing depends on
the order of the bands, so the bytes are the same for any number of threads.
"""

import itertools
from typing import NamedTuple, TypedDict

import numpy as np

from urdfkit.core.progress import Progress
from urdfkit.render.arrays import FAR, Bytes, Floats, Integers, Keys, turned
from urdfkit.render.camera import Camera
from urdfkit.render.fragments import Fragments, FragmentSurface, fragments, surface
from urdfkit.render.ground import Ground, ground, without_shadows
from urdfkit.render.light import LATTICE, ShadowMap, rig, shadow_map, sunlight
from urdfkit.render.materials import SurfaceMaterial
from urdfkit.render.occlusion import openness
from urdfkit.render.pixels import STUDIO, Background, encoded, gradient, matching, means, summed
from urdfkit.render.raster import Grid, Projected, nearest, projected, rooks
from urdfkit.render.scene import Scene
from urdfkit.render.shading import Illumination
from urdfkit.render.soup import CameraTriangles, chosen_triangles, cut, extent, rows, soup
from urdfkit.render.surface_colours import SurfaceColours
from urdfkit.render.textures import texture
from urdfkit.render.thread_pool import Workers

#: Rows of pixels of a band.
BAND = 60
#: Surfaces that are seen through one another; those behind are left out.
PEELS = 4
#: What is less transparent than this hides what is behind it.
SOLID = 0.98
#: How much nearer collisions are drawn than they are, as a part of the robot's size.
LIFT = 0.004
#: How far around them surfaces hide the sky from one another, as a part of the robot's size.
REACH = 0.12
#: The mean of light over a lattice leaves out what is further in depth, as a part of the size.
NEAR = 0.012


_OPAQUE, _CLEAR, _OVERLAY = range(3)


class Quality(NamedTuple):
    """How much work an image is worth."""

    samples: int  # of a pixel, for smooth edges
    #: sky and sun: samples of what hides the sky and the sun; none are taken for 0.
    sky: int
    sun: int


QUALITIES = {
    "draft": Quality(3, 0, 4),
    "default": Quality(6, 16, 10),
    "high": Quality(16, 32, 16),
}


#: Hard edges, and no surface takes light from another: to be compared, not to be looked at.
_SAMPLES = Quality(1, 0, 0)


class DrawingOptions(TypedDict, total=False):
    """What `draw` takes by name, but for the level of the ground."""

    quality: str
    background: Background | None
    floor: bool
    threads: int | None


class _Light(NamedTuple):
    """What the first two passes find out about the pixels, (h, w) each."""

    depth: Floats  # of what is seen first, `FAR` where nothing is
    sky: Floats  # the parts of the sky and of the sun that reach it, from 0 to 1
    sun: Floats


class _Band(NamedTuple):
    """What the first pass finds out about a band."""

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
        background: colours above and below, sRGB from 0 to 1; None for a transparent one.
        floor: whether there is a ground that catches shadows.
        level: height of the ground in m; that of the robot's lowest point if None.
        threads: how many work on it, as many as processors if None; the bytes do not depend on it.
        progress: called with the number of steps done and of all.

    Returns:
        (h, w, 4), red green blue alpha, sRGB, not premultiplied.
    """
    drawing = _Drawing(scene, camera, QUALITIES[quality], Workers(threads), floor, level)
    return drawing.image(background, progress or (lambda _done, _total: None))


class Samples(NamedTuple):
    """A robot alone, one sample for each pixel, without shadows."""

    pixels: Bytes  # (h, w, 4), as `draw` returns
    depth: Floats  # (h, w), in m, `FAR` where nothing is

    def rows(self, first: int, last: int) -> "Samples":
        return Samples(self.pixels[first:last], self.depth[first:last])


def samples(scene: Scene, camera: Camera) -> Samples:
    """Draw a scene to compare it with another one."""
    drawing = _Drawing(scene, camera, _SAMPLES, Workers(None), floor=False, level=None)
    return Samples(drawing.image(None, lambda _done, _total: None), drawing.depth)


class _Drawing:
    """One image while it is drawn."""

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
        workers.each(sorted({one.texture for one in materials if one.texture}, key=str), texture)
        self.kinds = [_kind(one) for one in materials]
        pieces = list(zip(everything.pieces, self.kinds, strict=True))
        solid = [piece for piece, kind in pieces if kind == _OPAQUE]
        robot = [piece for piece, kind in pieces if kind != _OVERLAY] or everything.pieces
        casts = rows(everything.faces, self._kind(everything) == _OPAQUE)
        axes = np.asarray(camera.axes, dtype=np.float32).T
        world = turned(everything.points, axes) + np.asarray(camera.eye, dtype=np.float32)
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
            np.flatnonzero(kind == one) for one in (_OPAQUE, _CLEAR, _OVERLAY)
        )
        self.colours = SurfaceColours(materials, self.soup, self.screen, camera)
        self.offsets = rooks(quality.samples)
        width, height = camera.size
        self.depth = np.full((height, width), FAR, dtype=np.float32)

    def _projected(
        self, everything: CameraTriangles, middle: Floats
    ) -> tuple[Projected, CameraTriangles]:
        """The triangles that may be in the image, there and in the frame of the camera."""
        x, y, near = self.camera.project(everything.points)
        self._lift(near, everything, middle)
        screen, chosen = projected(x, y, near, everything.faces, self.camera.size[0])
        is_whole = len(chosen) == len(everything.faces)
        return screen, everything if is_whole else chosen_triangles(everything, chosen)

    def image(self, background: Background | None, progress: Progress) -> Bytes:
        width, height = self.camera.size
        bands: dict[int, _Band] = {}
        count, steps = 3 * -(-height // BAND), itertools.count(1)

        def see(first: int, last: int) -> None:
            bands[first] = self._see(first, last)
            progress(next(steps), count)

        self.workers.bands(height, BAND, see)
        light = _Light(self.depth, np.ones_like(self.depth), np.ones_like(self.depth))

        def shade(first: int, _last: int) -> None:
            self._light(bands[first].opaque, light)
            progress(next(steps), count)

        self.workers.bands(height, BAND, shade)
        result = np.empty((height, width, 4), dtype=np.uint8)

        def colour(first: int, last: int) -> None:
            result[first:last] = self._colour(bands.pop(first), first, last, light, background)
            progress(next(steps), count)

        self.workers.bands(height, BAND, colour)
        return result

    def _kind(self, some: CameraTriangles) -> Integers:
        """What each triangle is: opaque, seen through, or an overlay, (m,)."""
        result: Integers = np.array(self.kinds, dtype=np.int8)[some.item]
        return result

    def _lift(self, near: Floats, everything: CameraTriangles, middle: Floats) -> None:
        """Bring collisions and contacts that are seen through a little nearer.

        Many lie on their visuals, or a hair below: without it both would show in patches.

        Args:
            near: of the vertices, as the camera projects them.
            middle: of the robot, in the world.
        """
        step = np.float32(LIFT * self.size)
        distance = float(np.dot(np.asarray(self.camera.eye) - middle, self.camera.axes[2]))
        for item, piece, kind in zip(self.scene.items, everything.pieces, self.kinds, strict=True):
            if item.role not in ("collision", "contacts") or kind == _OPAQUE:
                continue
            if self.camera.is_orthographic:
                near[piece] += step
            else:
                near[piece] *= 1 + step / np.float32(max(distance, self.size))

    # -- the first pass: what is seen --

    def _see(self, first: int, last: int) -> _Band:
        """The surfaces of a band; their depth goes to the image's."""
        grid = Grid(self.camera.size[0], first, last, self.offsets)
        opaque = nearest(self.screen, self.opaque, grid)
        found = self._surfaces(fragments(opaque, grid))
        dark = np.zeros((0,), dtype=np.float32)
        if self.floor is not None:
            self.depth[first:last], dark = self.floor.seen(self.camera, first, last)
        self._fill(*found)
        clear = self._peeled(self.clear, grid, opaque)
        overlays = self._peeled(self.overlays, grid, np.zeros_like(opaque))
        return _Band(found, clear, overlays, dark.reshape(-1))

    def _peeled(
        self, numbers: Integers, grid: Grid, above: Keys
    ) -> tuple[tuple[Fragments, FragmentSurface], ...]:
        """The surfaces of what is seen through, from the nearest on, as far as nothing hides it."""
        layers = []
        below = None
        for _ in range(PEELS if len(numbers) else 0):
            below = nearest(self.screen, numbers, grid, above=above, below=below)
            if not below.any():
                break
            layers.append(self._surfaces(fragments(below, grid)))
        return tuple(layers)

    def _surfaces(self, some: Fragments) -> tuple[Fragments, FragmentSurface]:
        return some, surface(some, self.soup, self.screen, self.camera)

    def _fill(self, some: Fragments, there: FragmentSurface) -> None:
        """Give pixels the depth of their largest fragments."""
        order = np.argsort(some.weight, kind="stable")
        self.depth.reshape(-1)[some.pixel[order]] = -there.position[order, 2]

    # -- the second pass: how much light there is --

    def _light(self, opaque: tuple[Fragments, FragmentSurface], light: _Light) -> None:
        """How much light reaches the surfaces that are largest in their pixels; grainy."""
        some, there = opaque
        shown = np.flatnonzero(light.depth.reshape(-1)[some.pixel] == -there.position[:, 2])
        pixel, position = some.pixel[shown], there.position[shown]
        width = self.camera.size[0]
        if self.quality.sky:
            light.sky.reshape(-1)[pixel] = openness(
                light.depth,
                self.camera,
                position,
                there.normal[shown],
                pixel,
                REACH * self.size,
                self.quality.sky,
            )
        if self.quality.sun:
            light.sun.reshape(-1)[pixel] = sunlight(
                self.sun, position, there.flat[shown], pixel, width, self.quality.sun
            )

    # -- the third pass: colours --

    def _colour(
        self, band: _Band, first: int, last: int, found: _Light, background: Background | None
    ) -> Bytes:
        width = self.camera.size[0]
        some, there = band.opaque
        start, count = first * width, (last - first) * width
        near = found.depth[first:last]
        place = matching(some.pixel - start, -there.position[:, 2], near, self._near)
        light_there = means((found.sun, found.sky), found.depth, first, last, self._near)
        lit = Illumination(*(image[place] for image in light_there))
        light, cover = summed(some, self.colours.light(some, there, lit), start, count)
        free = 1 - cover
        dark = band.dark if len(band.dark) else np.zeros_like(free)
        if background is None:
            alpha = cover + free * dark
        else:
            alpha = np.ones_like(cover)
            behind = gradient(background, first, last, self.camera.size)
            light.reshape(-1, width, 3)[:] += (free * (1 - dark)).reshape(-1, width, 1) * behind
        for layer, surfaces in (*reversed(band.clear), *reversed(band.overlays)):
            opacity = self.colours.opacity(layer, surfaces, found.depth)
            ones = np.ones(len(layer.pixel), dtype=np.float32)
            colours = self.colours.light(layer, surfaces, Illumination(ones, ones))
            weighted = layer._replace(weight=layer.weight * opacity)
            over, part = summed(weighted, colours, start, count)
            light = over + light * (1 - part)[:, None]
            alpha = part + alpha * (1 - part)
        return encoded(light, alpha).reshape(last - first, width, 4)

    def _near(self, depth: Floats) -> Floats:
        """How far apart in depth what belongs to one surface may be, across a lattice square."""
        pixel = np.float32(1 / self.camera.scale)
        step = pixel * depth if not self.camera.is_orthographic else np.full_like(depth, pixel)
        near: Floats = np.float32(NEAR * self.size) + np.float32(LATTICE) * step
        return near


def _kind(material: SurfaceMaterial) -> int:
    if material.overlay:
        return _OVERLAY
    return _OPAQUE if material.rgba[3] > SOLID else _CLEAR
