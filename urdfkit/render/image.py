"""Images of a robot: one view, or several views on a sheet."""

from __future__ import annotations

import io
import os
from collections.abc import Sequence
from typing import TYPE_CHECKING

from PIL import Image, ImageColor

from urdfkit.core import atomic
from urdfkit.errors import UrdfkitError
from urdfkit.render.camera import Camera, CameraOptions, place_camera, size_error
from urdfkit.render.draw import DrawingOptions, draw
from urdfkit.render.labels import caption, opaque, write
from urdfkit.render.pixels import STUDIO
from urdfkit.render.scale import write_scale
from urdfkit.render.scene import Scene

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from urdfkit.core.progress import Progress

#: Grey pixels between the views of a sheet.
_GAP = 2


class ImageError(UrdfkitError):
    """An image cannot be rendered; the text states why."""


def render_image(
    scene: Scene,
    views: Sequence[str] = ("iso",),
    *,
    size: tuple[int, int] = (1280, 720),
    camera_options: CameraOptions | None = None,
    progress: Progress | None = None,
    **drawing: Unpack[DrawingOptions],
) -> Image.Image:
    """Draw a robot.

    Args:
        scene: the robot, from `build`.
        views: names of `camera.VIEWS`; several form a sheet.
        size: of the image, in pixels.
        camera_options: as for `place_camera`.
        progress: called with the number of finished steps and of all.
        drawing: as for `draw`.

    Raises:
        NoSuchView: a view is unknown, or a number is out of bounds.
        ImageError: the size is out of bounds.
    """
    has_background = drawing.get("background", STUDIO) is not None
    columns, rows = _grid(len(views))
    cell = (size[0] // columns, size[1] // rows)
    gap = _GAP if len(views) > 1 else 0
    if reason := size_error(size) or size_error((cell[0] - gap, cell[1] - gap)):
        raise ImageError(reason)
    sheet = Image.new("RGBA", size, (190, 195, 202, 255) if has_background else (0, 0, 0, 0))
    level = scene.level()
    cameras = _cameras(scene, views, (cell[0] - gap, cell[1] - gap), camera_options or {})
    for number, (view, camera) in enumerate(zip(views, cameras, strict=True)):
        part = _part(progress, number, len(views))
        image = render_view(scene, camera, level, drawing, part)
        if len(views) > 1:
            caption(image, view)
        sheet.paste(image, (number % columns * cell[0], number // columns * cell[1]))
    return sheet.convert("RGB") if has_background else sheet


def render_view(
    scene: Scene,
    camera: Camera,
    level: float,
    drawing: DrawingOptions,
    progress: Progress | None = None,
) -> Image.Image:
    """One view of a scene, with labels, legend and scale.

    Args:
        level: height of the ground in m.
    """
    image = Image.fromarray(draw(scene, camera, level=level, progress=progress, **drawing))
    write(image, scene, camera)
    if has_scale(drawing):
        write_scale(image, camera, level)
    return image


def has_scale(drawing: DrawingOptions) -> bool:
    """True if the ground is drawn."""
    return drawing.get("background", STUDIO) is not None and drawing.get("floor", True)


def _cameras(
    scene: Scene, views: Sequence[str], size: tuple[int, int], options: CameraOptions
) -> list[Camera]:
    """A camera for each view; on a sheet, all but ``iso`` are orthographic with a common scale."""
    is_sheet = len(views) > 1 and options.get("distance") is None
    cameras = []
    for view in views:
        flat = options.get("orthographic", False) or (is_sheet and view != "iso")
        view_options: CameraOptions = {**options, "orthographic": flat}
        cameras.append(place_camera(scene.points(), view, size=size, **view_options))
    extent = max(camera.extent for camera in cameras)
    return [cam._replace(extent=extent) if cam.is_orthographic else cam for cam in cameras]


def _part(progress: Progress | None, number: int, count: int) -> Progress | None:
    if progress is None:
        return None
    return lambda done, total: progress(number * total + done, count * total)


def colour(word: str) -> tuple[float, float, float]:
    """A colour from its HTML name or ``#rrggbb``, each component from 0 to 1.

    Raises:
        ImageError: the word is not a colour.
    """
    try:
        r, g, b = ImageColor.getrgb(word)[:3]
    except ValueError as error:
        raise ImageError(f"'{word}' is not a colour; use a name, or #rrggbb") from error
    return r / 255, g / 255, b / 255


def _grid(count: int) -> tuple[int, int]:
    """Columns and rows of a sheet: at most twice as wide as high, with few empty cells."""
    grids = [(-(-count // rows), rows) for rows in range(1, count + 1)]
    square = [(columns, rows) for columns, rows in grids if rows <= columns <= 2 * rows]
    return min(square, key=lambda grid: (grid[0] * grid[1], grid[0]))


def save(image: Image.Image, path: str | os.PathLike[str]) -> None:
    """Write an image atomically, in the format of the suffix.

    Raises:
        ImageError: Pillow does not support the format.
        UnwritableFile: the file cannot be written.
    """
    suffix = os.path.splitext(os.fspath(path))[1].lower()
    format = Image.registered_extensions().get(suffix)
    if format is None or format not in Image.SAVE:
        reason = f"'{suffix}' is not a supported image format" if suffix else "it has no suffix"
        raise ImageError(f"{os.fspath(path)}: {reason}; write .png, .webp or .jpg")
    if format == "JPEG":
        image = opaque(image)
    buffer = io.BytesIO()
    try:
        image.save(buffer, format, compress_level=4) if format == "PNG" else image.save(
            buffer, format
        )
    except (OSError, ValueError, KeyError) as error:
        raise ImageError(f"{os.fspath(path)}: {error}") from error
    atomic.write(path, buffer.getvalue())
