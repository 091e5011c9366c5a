"""Images on surfaces: read once, halved again and again, and sampled where they fit."""

from __future__ import annotations

import io
from functools import lru_cache

import numpy as np
from PIL import Image

from urdfkit.render.arrays import Bytes, Floats
from urdfkit.render.looks import STRIPES

#: Larger images are halved when they are read; no picture shows more of them.
MAX_EDGE = 4096

Pyramid = tuple[Floats, ...]


def srgb_to_linear(values: Floats) -> Floats:
    """Colours as written to amounts of light (IEC 61966-2-1)."""
    low = values / np.float32(12.92)
    high = ((values + np.float32(0.055)) / np.float32(1.055)) ** np.float32(2.4)
    linear: Floats = np.where(values <= 0.04045, low, high).astype(np.float32)
    return linear


@lru_cache(maxsize=64)
def pyramid(texture: str | bytes) -> Pyramid | None:
    """An image in linear light, (h, w, 4) with the first row below, and its halves.

    None if it is no image that Pillow reads, or too large to be meant.
    """
    pixels = _stripes() if texture == STRIPES else _read(texture)
    if pixels is None:
        return None
    levels = [pixels]
    while max(levels[-1].shape[:2]) > 1:
        levels.append(_halved(levels[-1]))
    return tuple(levels)


def _read(texture: str | bytes) -> Floats | None:
    try:
        with Image.open(io.BytesIO(texture) if isinstance(texture, bytes) else texture) as image:
            image.thumbnail((MAX_EDGE, MAX_EDGE))
            return _linear(np.asarray(image.convert("RGBA")))
    except (OSError, ValueError, SyntaxError, Image.DecompressionBombError):
        return None  # Pillow's readers raise all of these for foreign bytes


def _linear(pixels: Bytes) -> Floats:
    table = srgb_to_linear(np.arange(256, dtype=np.float32) / np.float32(255))
    linear = table[pixels]
    linear[..., 3] = pixels[..., 3] / np.float32(255)
    return linear[::-1]


def _stripes() -> Floats:
    """Slanting stripes in orange and dark grey, as on a barrier."""
    x, y = np.meshgrid(np.arange(256), np.arange(256))
    bright = ((x + y) // 32 % 2 == 0)[..., None]
    orange, grey = np.array((255, 122, 0, 255)), np.array((58, 58, 62, 255))
    return _linear(np.where(bright, orange, grey).astype(np.uint8))


def _halved(pixels: Floats) -> Floats:
    height, width = pixels.shape[:2]
    pixels = np.pad(pixels, ((0, height % 2), (0, width % 2), (0, 0)), mode="edge")
    return (pixels[::2, ::2] + pixels[1::2, ::2] + pixels[::2, 1::2] + pixels[1::2, 1::2]) / 4


def sample(levels: Pyramid, uv: Floats, spread: Floats) -> Floats:
    """The colours at texture coordinates, (k, 4), in linear light; images repeat.

    Args:
        levels: the image.
        uv: (k, 2), v upwards.
        spread: (k,), the edge of a pixel of the picture, as a part of the image.
    """
    edge = max(levels[0].shape[:2])
    level = np.log2(np.maximum(spread * np.float32(edge), np.float32(1)))
    level = np.clip(np.rint(level), 0, len(levels) - 1).astype(np.int32)
    found = np.empty((len(uv), 4), dtype=np.float32)
    for number in np.unique(level):
        some = np.flatnonzero(level == number)
        found[some] = _bilinear(levels[number], uv[some])
    return found


def _bilinear(pixels: Floats, uv: Floats) -> Floats:
    height, width = pixels.shape[:2]
    finite = np.nan_to_num(uv, posinf=0, neginf=0)
    x = (finite[:, 0] - np.floor(finite[:, 0])) * width - np.float32(0.5)
    y = (finite[:, 1] - np.floor(finite[:, 1])) * height - np.float32(0.5)
    left, low = np.floor(x).astype(np.int32), np.floor(y).astype(np.int32)
    across, up = (x - left)[:, None], (y - low)[:, None]
    left, right = left % width, (left + 1) % width
    low, high = low % height, (low + 1) % height
    lower = pixels[low, left] * (1 - across) + pixels[low, right] * across
    upper = pixels[high, left] * (1 - across) + pixels[high, right] * across
    mixed: Floats = lower * (1 - up) + upper * up
    return mixed
