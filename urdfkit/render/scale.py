"""The scale of an image: a grid on the ground, or a bar in an orthographic view."""

from math import floor, log10

from PIL import Image, ImageDraw

from urdfkit.render.camera import Camera
from urdfkit.render.fonts import writing
from urdfkit.render.labels import ink

#: Least numbers of grid squares and bars in the width of an image.
_SQUARES, _BARS = 7, 6
#: Sine of the elevation below which the grid looks like a line.
_LEAST_RISE = 0.06


def grid_step(camera: Camera, level: float) -> float:
    """The edge of a square of the grid on the ground, in m: 1, 2 or 5 times a power of ten.

    It only depends on the camera, so that it is the same in all images of an animation.

    Returns:
        0 if the camera does not look down on the ground, or is orthographic.
    """
    rise = camera.axes[2][2]
    if camera.is_orthographic or rise < _LEAST_RISE or camera.eye[2] <= level:
        return 0.0
    distance = (camera.eye[2] - level) / rise
    return _round(camera.size[0] / camera.scale * distance / _SQUARES)


def write_scale(image: Image.Image, camera: Camera, level: float) -> None:
    """Write the scale into the lower left corner of an image."""
    bar = _round(camera.size[0] / camera.scale / _BARS) if camera.is_orthographic else 0.0
    length = bar or grid_step(camera, level)
    if not length:
        return
    size = max(11, min(18, image.height // 30))
    font, text = writing(f"{'' if bar else 'grid '}{_metres(length)}", size)
    draw = ImageDraw.Draw(image)
    left, low = size * 0.7, image.height - size * 0.7
    base = low - size * 0.5 if bar else low
    fill = ink(image, draw.textbbox((left, base), text, font=font, anchor="ls"))
    if bar:
        right, tick = left + bar * camera.scale, size * 0.3
        line = [(left, low - tick), (left, low), (right, low), (right, low - tick)]
        draw.line(line, fill=fill, width=max(1, round(size / 9)))
    draw.text((left, base), text, fill=fill, font=font, anchor="ls")


def _round(length: float) -> float:
    """The largest of 1, 2 and 5 times a power of ten up to a length."""
    power = 10.0 ** floor(log10(length))
    return power * max(step for step in (1, 2, 5) if step <= length / power * (1 + 1e-9))


def _metres(length: float) -> str:
    return f"{length:g} m" if length > 0.09 else f"{length * 1000:g} mm"
