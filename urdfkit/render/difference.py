"""Two states of a robot side by side, and where they differ."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from PIL import Image

from urdfkit.render.arrays import Bytes
from urdfkit.render.camera import CameraOptions, place_camera
from urdfkit.render.draw import DrawingOptions, draw
from urdfkit.render.image import drawn
from urdfkit.render.labels import caption, write_legend
from urdfkit.render.pixels import STUDIO
from urdfkit.render.scene import Scene

if TYPE_CHECKING:
    from typing_extensions import Unpack

GONE, NEW, CHANGED = (0.84, 0.19, 0.19, 1.0), (0.09, 0.59, 0.30, 1.0), (0.94, 0.63, 0.08, 1.0)
LEGEND = ((GONE, "only before"), (NEW, "only after"), (CHANGED, "looks different"))
#: Differences of colour up to this, of 255, are none.
TOLERANCE = 14


def difference(
    before: Scene,
    after: Scene,
    view: str = "iso",
    *,
    size: tuple[int, int] = (1920, 480),
    camera_options: CameraOptions | None = None,
    **drawing: Unpack[DrawingOptions],
) -> Image.Image:
    """Before, after and the difference, seen by one camera that has both in view.

    In the difference the robot is pale; red is what only the first state covers, green what only
    the second one does, amber what looks different in both.

    Args:
        size: of all three images together, in pixels.
        camera_options: as `place_camera` takes it.
        drawing: as `draw` takes it.

    Raises:
        NoSuchView: the view has no name, or a number is out of bounds.
    """
    cell = (max(size[0] // 3, 16), max(size[1], 16))
    points = np.concatenate((before.points(), after.points()))
    camera = place_camera(points, view, size=cell, **(camera_options or {}))
    level = min(before.level(), after.level())
    bare, whole = [], Image.new("RGBA", (cell[0] * 3, cell[1]))
    for number, (scene, name) in enumerate(((before, "before"), (after, "after"))):
        bare.append(draw(scene, camera, quality="draft", background=None, floor=False))
        image = drawn(scene, camera, level, drawing)
        caption(image, name)
        whole.paste(image, (number * cell[0], 0))
    image = Image.fromarray(_compared(*bare))
    caption(image, "difference")
    write_legend(image, LEGEND)
    whole.paste(image, (2 * cell[0], 0))
    has_background = drawing.get("background", STUDIO) is not None
    return whole.convert("RGB") if has_background else whole


def _compared(before: Bytes, after: Bytes) -> Bytes:
    """The image of the difference of two images of robots and nothing else.

    A pixel that one state covers in part, at an edge, has the colours in these parts.
    """
    old, new = (pixels.astype(np.float32) / 255 for pixels in (before, after))
    cover_old, cover_new = old[..., 3:], new[..., 3:]
    grey = np.where(cover_new > 0, new, old)[..., :3].mean(axis=2, keepdims=True)
    apart = np.abs(old[..., :3] - new[..., :3]).max(axis=2, keepdims=True)
    both = np.minimum(cover_old, cover_new)
    changed = both * (apart > TOLERANCE / 255)
    pale = np.float32(0.7) + np.float32(0.25) * grey
    result = np.ones_like(old)
    result[..., :3] = 1 - np.maximum(cover_old, cover_new) + (both - changed) * pale
    gone, new_here = cover_old - both, cover_new - both
    for part, colour in ((changed, CHANGED), (gone, GONE), (new_here, NEW)):
        shaded = np.array(colour[:3], dtype=np.float32) * (np.float32(0.6) + np.float32(0.4) * grey)
        result[..., :3] += part * shaded
    return np.rint(result * 255).astype(np.uint8)
