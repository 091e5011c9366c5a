"""Numbers as text, for the formats that are text."""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from urdfkit.mesh.geometry import Floats, Integers

#: More would need a power of ten beyond all numbers.
_MOST_DECIMALS = 300


class Table(NamedTuple):
    """Rows without repetition, and which of them each corner of each face has."""

    rows: Floats  # (k, width), sorted
    corners: Integers  # (m, 3), indices of rows


def table(rows: Floats, faces: Integers) -> Table:
    """Each different row once.

    Args:
        rows: (n, width), of the vertices.
        faces: (m, 3), indices of them.
    """
    unique, places = np.unique(rounded_rows(rows), axis=0, return_inverse=True)
    return Table(unique, places.reshape(-1)[faces].astype(np.int64))


def rounded_rows(rows: Floats) -> Floats:
    """The rows to nine digits of their largest number; minus zero is zero.

    A 32-bit number, which is what readers keep, has seven; what lies below is noise of sines.
    """
    largest = float(np.abs(rows).max(initial=0.0))
    if largest == 0.0:
        return np.zeros_like(rows)
    decimals = min(8 - int(np.floor(np.log10(largest))), _MOST_DECIMALS)
    return np.asarray(np.round(rows, decimals) + 0.0)


def numbers(values: Iterable[float] | Floats) -> str:
    """Numbers with spaces between them, nine digits each, the same on every machine."""
    return " ".join(f"{value:.9g}" for value in np.asarray(values, dtype=float).reshape(-1))
