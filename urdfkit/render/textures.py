"""Textures: read once, with mipmaps on demand, and sampled."""

import io
from functools import cache, lru_cache

import numpy as np
from PIL import Image

from urdfkit.core import disk
from urdfkit.mesh.texture_image import opened
from urdfkit.render.arrays import Bytes, Floats, Integers
from urdfkit.ros.surface_materials import STRIPES

#: Largest edge of a texture in pixels; larger images are reduced when they are read.
MAX_EDGE = 2048


class Texture:
    """An image with mipmap levels, each computed on first use.

    Args:
        image: RGB.
    """

    def __init__(self, image: Image.Image) -> None:
        self._levels = [image]
        self.edge = max(image.size)

    def level(self, number: int) -> Bytes:
        """(h, w, 3), sRGB, bottom row first; each pixel is the mean of 4 ** number pixels."""
        levels = self._levels
        while len(levels) <= number:
            levels = [*levels, levels[-1].reduce(2)]
        self._levels = levels
        return np.asarray(levels[number])[::-1]

    def jpeg(self) -> bytes:
        """The image as a JPEG file, for browsers."""
        file = io.BytesIO()
        self._levels[0].save(file, "JPEG", quality=88)
        return file.getvalue()

    def png(self) -> bytes:
        """The image as a lossless file."""
        file = io.BytesIO()
        self._levels[0].save(file, "PNG")
        return file.getvalue()


def srgb_to_linear(values: Floats) -> Floats:
    """sRGB values as linear light (IEC 61966-2-1)."""
    low = values / np.float32(12.92)
    high = ((values + np.float32(0.055)) / np.float32(1.055)) ** np.float32(2.4)
    return np.asarray(np.where(values <= 0.04045, low, high).astype(np.float32))


def texture(source: str | bytes) -> Texture | None:
    """An image; None if Pillow cannot read it, or it is too large.

    Args:
        source: path of an image, or its bytes.
    """
    if source == STRIPES:
        source = stripes()
    data = source if isinstance(source, bytes) else disk.contents(source)
    return _decoded(data) if data is not None else None


@lru_cache(maxsize=64)
def _decoded(data: bytes) -> Texture | None:
    try:
        with opened(data) as image:
            image.draft("RGB", (MAX_EDGE, MAX_EDGE))  # much faster for JPEG
            image.thumbnail((MAX_EDGE, MAX_EDGE), Image.Resampling.BOX)
            return Texture(image.convert("RGB"))
    except (OSError, ValueError):
        return None


@cache
def stripes() -> bytes:
    """A PNG file with diagonal stripes in white and dark grey."""
    x, y = np.meshgrid(np.arange(256), np.arange(256))
    bright = ((x + y) // 32 % 2 == 0)[..., None]
    white, grey = np.array((255, 255, 255)), np.array((58, 58, 62))
    file = io.BytesIO()
    Image.fromarray(np.where(bright, white, grey).astype(np.uint8)).save(file, "PNG")
    return file.getvalue()


def sample(image: Texture, uv: Floats, spread: Floats) -> Floats:
    """(k, 3), colours at texture coordinates, in linear light; images repeat.

    Args:
        uv: (k, 2), v upwards.
        spread: (k,), edge of a pixel of the rendered image, as a part of the texture.
    """
    level = np.log2(np.maximum(spread * np.float32(image.edge), np.float32(1)))
    level = np.clip(np.rint(level), 0, int(np.log2(image.edge))).astype(np.int32)
    colours = np.empty((len(uv), 3), dtype=np.float32)
    for number in np.unique(level):
        rows = np.flatnonzero(level == number)
        colours[rows] = _bilinear(image.level(int(number)), uv[rows])
    return colours


def _bilinear(pixels: Bytes, uv: Floats) -> Floats:
    height, width = pixels.shape[:2]
    finite = np.nan_to_num(uv, posinf=0, neginf=0)
    x = (finite[:, 0] - np.floor(finite[:, 0])) * width - np.float32(0.5)
    y = (finite[:, 1] - np.floor(finite[:, 1])) * height - np.float32(0.5)
    left, low = np.floor(x).astype(np.int32), np.floor(y).astype(np.int32)
    across, up = (x - left)[:, None], (y - low)[:, None]
    left, right = left % width, (left + 1) % width
    low, high = low % height, (low + 1) % height
    lower = _light(pixels, low, left) * (1 - across) + _light(pixels, low, right) * across
    upper = _light(pixels, high, left) * (1 - across) + _light(pixels, high, right) * across
    return np.asarray(lower * (1 - up) + upper * up)


def _light(pixels: Bytes, row: Integers, column: Integers) -> Floats:
    return LINEAR[pixels[row, column]]


#: Linear light of the 256 sRGB values.
LINEAR = srgb_to_linear(np.arange(256, dtype=np.float32) / np.float32(255))
