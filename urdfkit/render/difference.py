"""Two states of a robot side by side, and where they differ."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from PIL import Image

from urdfkit.render.arrays import Bytes
from urdfkit.render.camera import CameraOptions, place_camera
from urdfkit.render.draw import DrawingOptions, draw
from urdfkit.render.labels import caption
from urdfkit.render.pixels import STUDIO
from urdfkit.render.scene import Scene

if TYPE_CHECKING:
    from typing_extensions import Unpack

GONE, NEW, CHANGED = (214, 48, 49), (22, 150, 76), (240, 160, 20)
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
        after: the second one.
        size: of all three images together, in pixels.
        camera_options: as `place_camera` takes it.
        drawing: as `draw` takes it.

    Raises:
        NoSuchView: the view has no name, or a number is out of bounds.
    """
    cell = (max(size[0] // 3, 16), max(size[1], 16))
    points = np.concatenate((before.points(), after.points()))
    camera = place_camera(points, view, size=cell, **(camera_options or {}))
    level = float(points[:, 2].min()) if len(points) else None
    bare, whole = [], Image.new("RGBA", (cell[0] * 3, cell[1]))
    for number, (scene, name) in enumerate(((before, "before"), (after, "after"))):
        bare.append(draw(scene, camera, quality="draft", background=None, floor=False))
        image = Image.fromarray(draw(scene, camera, level=level, **drawing))
        caption(image, name)
        whole.paste(image, (number * cell[0], 0))
    image = Image.fromarray(_compared(*bare))
    caption(image, "difference")
    whole.paste(image, (2 * cell[0], 0))
    has_background = drawing.get("background", STUDIO) is not None
    return whole.convert("RGB") if has_background else whole


def _compared(before: Bytes, after: Bytes) -> Bytes:
    """The image of the difference of two images of robots and nothing else."""
    old, new = (pixels.astype(np.int32) for pixels in (before, after))
    result = np.full(before.shape, 255, dtype=np.uint8)
    shown = np.where((new[..., 3] > 0)[..., None], new, old)
    grey = shown[..., :3].mean(axis=2) * 0.25 + 180
    cover = np.maximum(old[..., 3], new[..., 3]) / 255
    result[..., :3] = np.rint(255 * (1 - cover) + grey * cover)[..., None]
    apart = np.abs(old[..., :3] - new[..., :3]).max(axis=2)
    both = (old[..., 3] > 127) & (new[..., 3] > 127)
    for where, colour in (
        (both & (apart > TOLERANCE), CHANGED),
        ((old[..., 3] > 127) & (new[..., 3] <= 127), GONE),
        ((new[..., 3] > 127) & (old[..., 3] <= 127), NEW),
    ):
        light = shown[where][:, :3].mean(axis=1, keepdims=True) / 255
        result[where, :3] = np.rint(np.array(colour) * (0.6 + 0.4 * light))
    return result
