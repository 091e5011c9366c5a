"""Numbers in text formats."""

from collections.abc import Iterable, Iterator
from typing import NamedTuple

import numpy as np

from urdfkit.mesh.geometry import Floats, Integers

#: More decimals would need a power of ten that overflows.
_MOST_DECIMALS = 300
#: Rows that are formatted together, which bounds the memory.
_ROWS_AT_ONCE = 20_000


class Table(NamedTuple):
    """Distinct rows, and the row of each corner of each face."""

    rows: Floats  # (k, width), sorted
    corners: Integers  # (m, 3), indices of rows


def table(rows: Floats, faces: Integers) -> Table:
    """The distinct rows.

    Args:
        rows: (n, width), one for each vertex.
        faces: (m, 3), indices of vertices.
    """
    unique, places = np.unique(rounded_rows(rows), axis=0, return_inverse=True)
    return Table(unique, places.reshape(-1)[faces].astype(np.int64))


def rounded_rows(rows: Floats) -> Floats:
    """The rows rounded to nine digits of their largest number; minus zero becomes zero.

    Readers store 32-bit numbers, which have seven digits; the digits below are rounding noise.
    """
    largest = float(np.abs(rows).max(initial=0.0))
    if largest == 0.0:
        return np.zeros_like(rows)
    decimals = min(8 - int(np.floor(np.log10(largest))), _MOST_DECIMALS)
    return np.asarray(np.round(rows, decimals) + 0.0)


def numbers(values: Iterable[float] | Floats) -> str:
    """Numbers separated by spaces, nine digits each, the same on every machine."""
    return " ".join(f"{value:.9g}" for value in np.asarray(values, dtype=float).reshape(-1))


def printed(line: str, rows: Floats | Integers) -> Iterator[str]:
    """The rows as lines, in pieces of many lines each without the last line end.

    Args:
        line: a format of ``%`` for one row; one for many rows at once is ten times faster.
        rows: (n, width).
    """
    for start in range(0, len(rows), _ROWS_AT_ONCE):
        piece = rows[start : start + _ROWS_AT_ONCE]
        yield "\n".join([line] * len(piece)) % tuple(piece.reshape(-1).tolist())
