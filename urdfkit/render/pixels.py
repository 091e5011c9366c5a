"""From fragments to pixels: light over lattices, sums, backgrounds and bytes."""

from __future__ import annotations

import numpy as np

from urdfkit.render.arrays import Bytes, Floats, Integers
from urdfkit.render.fragments import Fragments
from urdfkit.render.light import LATTICE
from urdfkit.render.textures import srgb_to_linear

#: Two colours, above and below, sRGB from 0 to 1.
Background = tuple[tuple[float, float, float], tuple[float, float, float]]
STUDIO: Background = ((0.965, 0.97, 0.978), (0.862, 0.878, 0.9))


def means(image: Floats, depth: Floats, first: int, last: int, near: Floats) -> Floats:
    """The means of light over the lattice square around each pixel of a band, (p,).

    Args:
        image: (h, w), light that is grainy within the squares.
        depth: (h, w), in m.
        first: row of the band.
        last: row after it.
        near: (rows, w), how far apart in depth what belongs to one surface may be.
    """
    height, width = depth.shape
    total = np.ones((last - first, width), dtype=np.float32)
    rows = np.clip(np.arange(first - LATTICE // 2, last + LATTICE // 2), 0, height - 1)
    shown = np.flatnonzero((image[rows] < 1).any(axis=0))
    if not len(shown):
        return total.reshape(-1)
    start, end = max(int(shown[0]) - LATTICE, 0), min(int(shown[-1]) + 1 + LATTICE, width)
    columns = np.clip(np.arange(start - LATTICE // 2, end + LATTICE // 2), 0, width - 1)
    values, distances = image[rows][:, columns], depth[rows][:, columns]
    own, bound = depth[first:last, start:end], near[:, start:end]
    mean, count = np.zeros_like(own), np.zeros_like(own)
    for down in range(LATTICE):
        for across in range(LATTICE):
            window = np.s_[down : down + last - first, across : across + end - start]
            alike = np.abs(distances[window] - own) < bound
            count += alike
            mean += values[window] * alike
    total[:, start:end] = mean / count
    return total.reshape(-1)


def matching(pixel: Integers, own: Floats, depth: Floats, near: Floats) -> Integers:
    """The pixel beside each fragment whose depth is nearest to that; its own if that is near.

    Args:
        pixel: (k,), of the fragments, from the first of the band.
        own: (k,), depth of the fragments, in m.
        depth: (rows, w), of the pixels of the band.
        near: (rows, w), what is near.
    """
    flat, width = depth.reshape(-1), depth.shape[1]
    place: Integers = pixel.copy()
    gap = np.abs(flat[place] - own)
    off = np.flatnonzero(gap > near.reshape(-1)[place])
    for step in (-1, 1, -width, width):
        beside = np.clip(pixel[off] + step, 0, len(flat) - 1)
        distance = np.abs(flat[beside] - own[off])
        better = distance < gap[off]
        place[off[better]] = beside[better]
        gap[off[better]] = distance[better]
    return place


def summed(some: Fragments, light: Floats, start: int, count: int) -> tuple[Floats, Floats]:
    """Fragments in their pixels: light (p, 3), times coverage, and the coverage (p,).

    Args:
        some: the fragments.
        light: (k, 3), that they send.
        start: number of the first pixel.
        count: of pixels.
    """
    place = some.pixel - start
    result = np.empty((count, 3), dtype=np.float32)
    for channel in range(3):
        result[:, channel] = np.bincount(place, light[:, channel] * some.weight, count)
    return result, np.bincount(place, some.weight, count).astype(np.float32)


def gradient(background: Background, first: int, last: int, height: int) -> Floats:
    """The background of rows, (rows, 1, 3), in linear light."""
    above, below = srgb_to_linear(np.array(background, dtype=np.float32))
    row = np.arange(first, last, dtype=np.float32)[:, None, None]
    mixed: Floats = above + (below - above) * ((row + np.float32(0.5)) / np.float32(height))
    return mixed


def encoded(light: Floats, alpha: Floats) -> Bytes:
    """sRGB with alpha, (p, 4), of light that is multiplied with its alpha."""
    plain = light / np.maximum(alpha, np.float32(1e-6))[:, None]
    steps = np.float32(len(_TABLE) - 1)
    index = (np.clip(plain, 0, 1) * steps + np.float32(0.5)).astype(np.int32)
    result = np.empty((len(light), 4), dtype=np.uint8)
    result[:, :3] = _TABLE[index]
    result[:, 3] = np.rint(np.clip(alpha, 0, 1) * 255)
    return result


def _table() -> Bytes:
    """sRGB of amounts of light from 0 to 1 (IEC 61966-2-1)."""
    light = np.arange(1 << 14) / ((1 << 14) - 1)
    value = np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
    table: Bytes = np.rint(value * 255).astype(np.uint8)
    return table


_TABLE = _table()
