"""Pixels from fragments: averages of light, sums, backgrounds and bytes."""

from collections.abc import Callable, Sequence

import numpy as np

from urdfkit.render.arrays import Bytes, Floats, Integers
from urdfkit.render.fragments import Fragments
from urdfkit.render.light import LATTICE
from urdfkit.render.textures import LINEAR

#: Two colours, at top and bottom, sRGB from 0 to 1.
Background = tuple[tuple[float, float, float], tuple[float, float, float]]
STUDIO: Background = ((0.925, 0.935, 0.95), (0.8, 0.82, 0.845))


def means(
    images: Sequence[Floats], depth: Floats, first: int, last: int, near: Callable[[Floats], Floats]
) -> list[Floats]:
    """(p,) for each image, means of light around each pixel of a band.

    Two means over a lattice square, one of them shifted by a pixel, form a tent filter of 7x7
    pixels, which removes all grain of the lattice.

    Args:
        images: (h, w) each, light with grain within the squares.
        depth: (h, w), in m.
        first: first row of the band.
        last: row after the band.
        near: maps depths to the greatest depth difference within one surface.
    """
    above, below = max(first - LATTICE + 1, 0), last + LATTICE - 1
    shown = np.flatnonzero(sum((image[above:below] < 1).any(axis=0) for image in images))
    band = [np.ones_like(image[first:last]) for image in images]
    if len(shown):
        start, end = max(int(shown[0]) - LATTICE, 0), int(shown[-1]) + 1 + LATTICE
        window = np.s_[above:below, start:end]
        values, distances = [image[window] for image in images], depth[window]
        bound = near(distances)
        for axis in (1, 0):
            values = _tents(values, distances, bound, axis)
        for result, value in zip(band, values, strict=True):
            result[:, start:end] = value[first - above : last - above]
    return [result.reshape(-1) for result in band]


def _tents(values: Sequence[Floats], distances: Floats, bound: Floats, axis: int) -> list[Floats]:
    """Two means of images along an axis, over pixels of similar depth."""
    half = LATTICE // 2
    is_near = {}
    for offset in range(-half, half + 1):
        here, there = _neighbours(offset, axis)
        is_near[offset] = np.abs(distances[there] - distances[here]) < bound[here]
    for offsets in (range(-half, half), range(1 - half, half + 1)):
        totals, count = [np.zeros_like(value) for value in values], np.zeros_like(distances)
        for offset in offsets:
            here, there = _neighbours(offset, axis)
            count[here] += is_near[offset]
            for total, value in zip(totals, values, strict=True):
                total[here] += value[there] * is_near[offset]
        values = [total / count for total in totals]
    return list(values)


def _neighbours(offset: int, axis: int) -> tuple[tuple[slice, ...], tuple[slice, ...]]:
    """The pixels with a neighbour at an offset along an axis, and these neighbours."""
    back, on = slice(max(-offset, 0), -offset if offset > 0 else None), slice(None)
    away = slice(max(offset, 0), offset if offset < 0 else None)
    return ((back, on), (away, on)) if axis == 0 else ((on, back), (on, away))


def matching(
    pixel: Integers, own: Floats, depth: Floats, near: Callable[[Floats], Floats]
) -> Integers:
    """The adjacent pixel with the depth nearest to each fragment's; its own pixel if it is near.

    Args:
        pixel: (k,), pixels of the fragments, counted from the start of the band.
        own: (k,), depth of the fragments, in m.
        depth: (rows, w), of the pixels of the band.
        near: as for `means`.
    """
    flat, width = depth.reshape(-1), depth.shape[1]
    place: Integers = pixel.copy()
    gap = np.abs(flat[place] - own)
    off = np.flatnonzero(gap > near(flat[place]))
    for step in (-1, 1, -width, width):
        neighbour = np.clip(pixel[off] + step, 0, len(flat) - 1)
        distance = np.abs(flat[neighbour] - own[off])
        better = distance < gap[off]
        place[off[better]] = neighbour[better]
        gap[off[better]] = distance[better]
    return place


def summed(fragments: Fragments, light: Floats, start: int, count: int) -> tuple[Floats, Floats]:
    """Sums of fragments in pixels: light (p, 3) multiplied with coverage, and coverage (p,).

    Args:
        light: (k, 3), of the fragments.
        start: index of the first pixel.
        count: number of pixels.
    """
    place = fragments.pixel - start
    result = np.empty((count, 3), dtype=np.float32)
    for channel in range(3):
        result[:, channel] = np.bincount(place, light[:, channel] * fragments.weight, count)
    return result, np.bincount(place, fragments.weight, count).astype(np.float32)


def gradient(background: Background, first: int, last: int, size: tuple[int, int]) -> Floats:
    """(rows, w, 3), the background in linear light, dithered to avoid bands."""
    width, height = size
    above, below = 255 * np.array(background, dtype=np.float32)
    row, column = np.arange(first, last), np.arange(width)
    part = (row.astype(np.float32) + np.float32(0.5)) / np.float32(height)
    mixed = above + (below - above) * part[:, None, None]
    threshold = _THRESHOLDS[row[:, None] % len(_THRESHOLDS), column % len(_THRESHOLDS)]
    return np.asarray(LINEAR[(mixed + threshold[..., None]).astype(np.uint8)])


def encoded(light: Floats, alpha: Floats) -> Bytes:
    """(p, 4), sRGB with alpha, of premultiplied light."""
    plain = light / np.maximum(alpha, np.float32(1e-6))[:, None]
    steps = np.float32(len(_TABLE) - 1)
    index = (np.clip(plain, 0, 1) * steps + np.float32(0.5)).astype(np.int32)
    result = np.empty((len(light), 4), dtype=np.uint8)
    result[:, :3] = _TABLE[index]
    result[:, 3] = np.rint(np.clip(alpha, 0, 1) * 255)
    return result


def _thresholds() -> Floats:
    """(8, 8), thresholds of ordered dithering from 0 to 1: Bayer's matrix."""
    matrix = np.zeros((1, 1))
    for _ in range(3):
        matrix = np.block([[4 * matrix, 4 * matrix + 2], [4 * matrix + 3, 4 * matrix + 1]])
    return ((matrix + 0.5) / matrix.size).astype(np.float32)


_THRESHOLDS = _thresholds()


def _table() -> Bytes:
    """sRGB values of linear light from 0 to 1 (IEC 61966-2-1)."""
    light = np.arange(1 << 14) / ((1 << 14) - 1)
    value = np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
    return np.asarray(np.rint(value * 255).astype(np.uint8))


_TABLE = _table()
