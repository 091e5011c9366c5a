"""Images of two states of a robot and of their difference."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from PIL import Image

from urdfkit.render.arrays import Bytes, Floats, bounds
from urdfkit.render.camera import Camera, CameraOptions, place_camera
from urdfkit.render.draw import DrawingOptions, Samples, samples
from urdfkit.render.ground import without_shadows
from urdfkit.render.image import has_scale, render_view
from urdfkit.render.labels import caption, write_legend
from urdfkit.render.pixels import STUDIO
from urdfkit.render.scale import write_scale
from urdfkit.render.scene import Scene

if TYPE_CHECKING:
    from typing_extensions import Unpack

GONE, NEW, CHANGED = (0.84, 0.19, 0.19, 1.0), (0.09, 0.59, 0.30, 1.0), (0.94, 0.63, 0.08, 1.0)
LEGEND = ((GONE, "only before"), (NEW, "only after"), (CHANGED, "changed"))
#: Colour difference, of 255, that is ignored.
TOLERANCE = 14
#: Samples along the edge of a pixel, compared separately, and most samples of an image.
FINE, MAX_SAMPLES = 4, 16_000_000


def difference(
    before: Scene,
    after: Scene,
    view: str = "iso",
    *,
    size: tuple[int, int] = (1920, 480),
    camera_options: CameraOptions | None = None,
    **drawing: Unpack[DrawingOptions],
) -> Image.Image:
    """The state before, the state after, and the difference, with a common camera.

    In the difference, the robot is pale; pixels are red where only the first state is, green where
    only the second state is, and amber where the surface has another position or colour. Shadows
    are not compared.

    Args:
        size: of all three images together, in pixels.
        camera_options: as for `place_camera`.
        drawing: as for `draw`.

    Raises:
        NoSuchView: the view is unknown, or a number is out of bounds.
    """
    cell = (max(size[0] // 3, 16), max(size[1], 16))
    points = np.concatenate((before.points(), after.points()))
    camera = place_camera(points, view, size=cell, **(camera_options or {}))
    level = min(before.level(), after.level())
    sheet = Image.new("RGBA", (cell[0] * 3, cell[1]))
    for number, (scene, name) in enumerate(((before, "before"), (after, "after"))):
        image = render_view(scene, camera, level, drawing)
        caption(image, name)
        sheet.paste(image, (number * cell[0], 0))
    floor = np.zeros((cell[1], cell[0]), dtype=np.float32)
    if has_scale(drawing):
        _, floor = without_shadows(*bounds(points), camera, level).render_band(camera, 0, cell[1])
    image = Image.fromarray(_compared(before, after, camera, floor))
    caption(image, "difference")
    write_legend(image, LEGEND)
    if has_scale(drawing):
        write_scale(image, camera, level)
    sheet.paste(image, (2 * cell[0], 0))
    has_background = drawing.get("background", STUDIO) is not None
    return sheet.convert("RGB") if has_background else sheet


def _compared(before: Scene, after: Scene, camera: Camera, floor: Floats) -> Bytes:
    """The image of the difference; samples are classified separately.

    Args:
        floor: (h, w), darkness of the ground, from 0 to 1.
    """
    width, height = camera.size
    fine = max(1, min(FINE, int((MAX_SAMPLES / (width * height)) ** 0.5)))
    close = camera._replace(size=(width * fine, height * fine))
    old, new = samples(before, close), samples(after, close)
    result = np.full((height, width, 4), 255, dtype=np.uint8)
    for row in range(height):
        strip = row * fine, (row + 1) * fine
        colours, cover = _kinds(camera, old.rows(*strip), new.rows(*strip))
        mean = colours.reshape(fine, width, fine, 3).mean(axis=(0, 2))
        free = 1 - cover.reshape(fine, width, fine).mean(axis=(0, 2))
        light = mean + (free * (1 - floor[row]))[:, None]
        result[row, :, :3] = np.rint(light * 255)
    return result


def _kinds(camera: Camera, before: Samples, after: Samples) -> tuple[Floats, Floats]:
    """The colour of each sample, multiplied with its coverage, and the coverage."""
    old, new = (state.pixels.astype(np.float32) / 255 for state in (before, after))
    cover_old, cover_new = old[..., 3:], new[..., 3:]
    grey = np.where(cover_new > 0, new, old)[..., :3].mean(axis=2, keepdims=True)
    colour_distance = np.abs(old[..., :3] - new[..., :3]).max(axis=2, keepdims=True)
    # Differences of position up to the width of a pixel are ignored.
    pixel = (1 if camera.is_orthographic else before.depth) / np.float32(camera.scale)
    moved = (np.abs(before.depth - after.depth) > pixel)[..., None]
    both = np.minimum(cover_old, cover_new)
    changed = both * (moved | (colour_distance > TOLERANCE / 255))
    result = (both - changed) * (np.float32(0.7) + np.float32(0.25) * grey)
    shade = np.float32(0.75) + np.float32(0.25) * grey
    for part, colour in ((changed, CHANGED), (cover_old - both, GONE), (cover_new - both, NEW)):
        result = result + part * shade * np.array(colour[:3], dtype=np.float32)
    return result, np.maximum(cover_old, cover_new)[..., 0]
