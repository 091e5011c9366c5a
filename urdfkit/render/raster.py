"""Rasterisation: the nearest triangle at every sample of an image, by scanlines in numpy.

The largest key wins a sample: the bits of the nearness, followed by the number of the triangle.
Positive floats have the order of their bits as integers, so ``maximum.at`` acts as a depth buffer,
and results do not depend on the order of processing.

Both triangles at an edge compute its intersection with a row from the same two points in the same
order, from top to bottom, so they neither overlap nor leave a gap.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from urdfkit.render.arrays import Bools, Floats, Integers, Keys
from urdfkit.render.thread_pool import Workers

#: Most samples at a time, which limits memory for any depth complexity.
MAX_SAMPLES = 1 << 20
#: Key of empty samples; triangles count from 1.
EMPTY = np.uint64(0)
_LOW, _HIGH = (0, 1) if sys.byteorder == "little" else (1, 0)


class Projected(NamedTuple):
    """Triangles in an image."""

    #: x and y: (n,), vertices in pixels from the upper left corner.
    x: Floats
    y: Floats
    nearness: Floats  # (n,), positive, larger for nearer vertices, linear in the image
    corners: tuple[Integers, Integers, Integers]  # three times (m,), indices of the vertices
    #: top and bottom: (m,), least and greatest y of each triangle.
    top: Floats
    bottom: Floats


def projected(
    x: Floats, y: Floats, nearness: Floats, faces: Integers, width: int
) -> tuple[Projected, Integers]:
    """The triangles that may be in an image of a width, and their indices among all."""
    columns = [np.ascontiguousarray(faces[:, corner], dtype=np.int32) for corner in range(3)]
    xs, ys = ([values[column] for column in columns] for values in (x, y))
    top, bottom = np.minimum.reduce(ys), np.maximum.reduce(ys)
    inside = (bottom > top) & (np.minimum.reduce(xs) < width) & (np.maximum.reduce(xs) > 0)
    chosen = np.flatnonzero(inside)
    a, b, c = (column[chosen] for column in columns)
    return Projected(x, y, nearness, (a, b, c), top[chosen], bottom[chosen]), chosen


class Grid(NamedTuple):
    """Samples of a band of an image.

    Every pixel has ``len(offsets)`` rows of samples, one sample in each row, all at different
    offsets from the left (n-rooks sampling). Edges of all directions are as smooth as with the
    square of that number of samples.
    """

    width: int  # of the image in pixels
    #: first and last: rows of pixels, the last one excluded.
    first: int
    last: int
    offsets: Floats  # (s,), of the samples of a pixel, from 0 to 1

    @property
    def shape(self) -> tuple[int, int]:
        """Number of sample rows, and samples in each row."""
        return (self.last - self.first) * len(self.offsets), self.width


def rooks(samples: int) -> Floats:
    """Offsets of the samples of a pixel, well distributed by the golden ratio."""
    order = np.argsort((np.arange(samples) * 0.6180339887498949) % 1.0, kind="stable")
    return ((np.argsort(order) + 0.5) / samples).astype(np.float32)


def nearest(
    triangles: Projected,
    chosen: Integers,
    grid: Grid,
    *,
    above: Keys | None = None,
    below: Keys | None = None,
) -> Keys:
    """The keys of the samples of a band.

    Args:
        chosen: indices of the triangles to draw.
        above: lower bounds of visible keys: the keys of opaque surfaces.
        below: upper bounds of keys (exclusive): the keys of the previous layer.

    Returns:
        Keys in the shape of the grid; the lower half is the number of the triangle, from 1.
    """
    rows, width = grid.shape
    keys = np.zeros(rows * width, dtype=np.uint64) if above is None else above.copy()
    keys = keys.reshape(-1)
    count = len(grid.offsets)
    touching = chosen[(triangles.bottom[chosen] > grid.first) & (triangles.top[chosen] < grid.last)]
    for batch in _slices(_rows(triangles, touching, grid)[1], MAX_SAMPLES // 4):
        spans = _spans(triangles, touching[batch], grid, count)
        for piece in _slices(spans.length, MAX_SAMPLES):
            places, values = _samples(spans.part(piece))
            if below is not None:
                seen = values < below.reshape(-1)[places]
                places, values = places[seen], values[seen]
            np.maximum.at(keys, places, values)
    if above is not None:
        keys[keys == above.reshape(-1)] = EMPTY
    return keys.reshape(rows, width)


def nearness_map(
    x: Floats, y: Floats, nearness: Floats, faces: Integers, size: int, workers: Workers
) -> Floats:
    """(size, size), nearness of triangles at the centres of pixels; 0 without a triangle."""
    screen, _ = projected(x, y, nearness, faces, size)
    everything, middle = np.arange(len(screen.top)), np.array((0.5,), dtype=np.float32)
    result = np.zeros((size, size), dtype=np.float32)

    def band(first: int, last: int) -> None:
        numbers, near = split(nearest(screen, everything, Grid(size, first, last, middle)))
        result[first:last] = np.where(numbers >= 0, near, 0)

    workers.bands(size, 128, band)
    return result


def split(keys: Keys) -> tuple[Integers, Floats]:
    """The indices of the triangles, -1 for none, and their nearness."""
    halves = keys.view(np.uint32).reshape(*keys.shape, 2)
    return halves[..., _LOW].astype(np.int32) - 1, halves[..., _HIGH].copy().view(np.float32)


class Spans(NamedTuple):
    """Pieces of sample rows, each covered by one triangle."""

    place: Integers
    length: Integers
    nearness: Floats
    step: Floats
    number: Integers

    def part(self, rows: slice) -> Spans:
        return Spans._make(column[rows] for column in self)


def _rows(triangles: Projected, numbers: Integers, grid: Grid) -> tuple[Integers, Integers]:
    """The first sample row of each triangle in a band, and its number of rows in the band."""
    count = np.float32(len(grid.offsets))
    half = np.float32(0.5)
    first = np.ceil(triangles.top[numbers] * count - half)
    last = np.ceil(triangles.bottom[numbers] * count - half)
    first = np.maximum(first, grid.first * count).astype(np.intp)
    last = np.minimum(last, grid.last * count).astype(np.intp)
    return first, np.maximum(last - first, 0)


def _spans(triangles: Projected, numbers: Integers, grid: Grid, count: int) -> Spans:
    first, rows = _rows(triangles, numbers, grid)
    mask = rows > 0
    first, rows, numbers = first[mask], rows[mask], numbers[mask]
    upper, middle, lower = _sorted(triangles, numbers, count)
    (x0, y0, n0), (x1, y1, n1), (x2, y2, n2) = upper, middle, lower
    height = y2 - y0
    long_slope = (x2 - x0) / height
    upper_slope = _quotient(x1 - x0, y1 - y0)
    lower_slope = _quotient(x2 - x1, y2 - y1)
    # The nearness is linear: its gradient is computed on the row of the middle corner, between the
    # long edge and the corner.
    along = (n2 - n0) / height
    across = x1 - (x0 + (y1 - y0) * long_slope)
    gradient = _quotient(n1 - (n0 + (y1 - y0) * along), across)
    least, most = np.minimum(np.minimum(n0, n1), n2), np.maximum(np.maximum(n0, n1), n2)

    which, row = _each_row(first, rows)
    at = row.astype(np.float32)
    down = at - y0[which]
    long_x = x0[which] + down * long_slope[which]
    short_x = np.where(
        at < y1[which],
        x0[which] + down * upper_slope[which],
        x1[which] + (at - y1[which]) * lower_slope[which],
    )
    offset = grid.offsets[row % np.int32(count)]
    start = _first_sample(np.minimum(long_x, short_x), offset, grid)
    end = _first_sample(np.maximum(long_x, short_x), offset, grid)
    seen = np.flatnonzero(end > start)
    which, row, start, end = which[seen], row[seen], start[seen], end[seen]
    base = n0[which] + down[seen] * along[which]
    slope, lowest, highest = gradient[which], least[which], most[which]
    first_x = start + offset[seen] - long_x[seen]
    length = end - start
    at_start = np.clip(base + slope * first_x, lowest, highest)
    at_end = np.clip(base + slope * (first_x + length - 1), lowest, highest)
    place = (row.astype(np.intp) - grid.first * count) * grid.width + start.astype(np.intp)
    step = (at_end - at_start) / np.maximum(length - 1, 1)
    return Spans(place, length.astype(np.intp), at_start, step, numbers[which].astype(np.int32))


def _each_row(first: Integers, rows: Integers) -> tuple[Integers, Integers]:
    """The index of the triangle and the row, for each row of samples of each triangle."""
    which = np.repeat(np.arange(len(rows)), rows)
    row = np.arange(len(which), dtype=np.int32)
    row += np.repeat((first - (np.cumsum(rows) - rows)).astype(np.int32), rows)
    return which, row


def _first_sample(x: Floats, offset: Floats, grid: Grid) -> Floats:
    """The first sample of a row at or after x, within the grid."""
    return np.clip(np.ceil(x - offset), 0, np.float32(grid.width))


def _quotient(dividend: Floats, divisor: Floats) -> Floats:
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        result: Floats = dividend / divisor
    result[~np.isfinite(result)] = 0
    return result


def _samples(spans: Spans) -> tuple[Integers, Keys]:
    """The samples of spans: their indices in the band, and keys."""
    starts = np.cumsum(spans.length) - spans.length
    count = int(spans.length.sum())
    places = np.arange(count)
    places += np.repeat(spans.place - starts, spans.length)
    along = np.arange(count, dtype=np.int32)
    along -= np.repeat(starts.astype(np.int32), spans.length)
    nearness = np.repeat(spans.step, spans.length)
    nearness *= along
    nearness += np.repeat(spans.nearness, spans.length)
    keys = np.empty((count, 2), dtype=np.uint32)
    keys[:, _HIGH] = np.maximum(nearness, np.float32(1e-30)).view(np.uint32)
    keys[:, _LOW] = np.repeat((spans.number + 1).astype(np.uint32), spans.length)
    return places, keys.view(np.uint64).reshape(-1)


def _sorted(
    triangles: Projected, numbers: Integers, count: int
) -> list[tuple[Floats, Floats, Floats]]:
    """x, y and nearness of the corners, upper ones first; y in sample rows from a first sample."""
    points = []
    for corner in triangles.corners:
        index = corner[numbers]
        y = triangles.y[index] * np.float32(count) - np.float32(0.5)
        points.append((triangles.x[index], y, triangles.nearness[index]))
    for i, j in ((0, 1), (1, 2), (0, 1)):
        swap = points[i][1] > points[j][1]
        points[i], points[j] = (
            _pick(swap, points[j], points[i]),
            _pick(swap, points[i], points[j]),
        )
    return points


def _pick(
    where: Bools, these: tuple[Floats, ...], those: tuple[Floats, ...]
) -> tuple[Floats, Floats, Floats]:
    x, y, nearness = (np.where(where, a, b) for a, b in zip(these, those, strict=True))
    return x, y, nearness


def _slices(counts: Integers, limit: int) -> Iterator[slice]:
    """Pieces of a list whose counts sum to at most the limit, or of a single item."""
    ends = np.cumsum(counts)
    start, total = 0, 0
    while start < len(counts):
        end = max(int(np.searchsorted(ends, total + limit, side="right")), start + 1)
        yield slice(start, end)
        start, total = end, int(ends[end - 1])
