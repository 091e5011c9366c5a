"""Equal rows and connected components."""

import numpy as np
from numpy.typing import NDArray

from urdfkit.mesh.geometry import Integers


def distinct(rows: Integers) -> tuple[Integers, Integers, Integers]:
    """Equal rows of small integers.

    As ``np.unique`` over rows, but with one number for each row, which sorts ten times as fast.

    Args:
        rows: (m, k), not negative.

    Returns:
        The index of the first of each group of equal rows; the group of each row; and the size of
        each group.
    """
    keys = rows[:, 0]
    for column in rows.T[1:]:
        _, keys = np.unique(keys, return_inverse=True)  # so that the product stays small
        keys = keys * (int(column.max(initial=0)) + 1) + column
    return equal_numbers(keys)


def equal_numbers(numbers: Integers | NDArray[np.uint64]) -> tuple[Integers, Integers, Integers]:
    """Equal numbers, in ascending order.

    As ``np.unique``, which sorts stably to find the first of each group: several times as slow.

    Returns:
        The index of the first of each group of equal numbers; the group of each number; and the
        size of each group.
    """
    order = np.argsort(numbers)
    ordered = numbers[order]
    is_first = np.ones(len(numbers), dtype=bool)
    np.not_equal(ordered[1:], ordered[:-1], out=is_first[1:])
    starts = np.flatnonzero(is_first)
    which = np.empty(len(numbers), dtype=np.int64)
    which[order] = np.cumsum(is_first) - 1
    first = np.minimum.reduceat(order, starts) if len(starts) else starts
    return first.astype(np.int64), which, np.diff(starts, append=len(numbers)).astype(np.int64)


def components(number: int, links: Integers) -> Integers:
    """Connected components: the smallest index in the component of each node, (number,).

    Each round joins every component to its smallest neighbour, which at least halves the number of
    joined ones in two rounds. scipy has this function, but takes longer to import than this one to
    run.

    Args:
        links: (k, 2), connected nodes.
    """
    label = np.arange(number)
    first, second = np.ascontiguousarray(links.T)
    while len(first):
        first, second = label.take(first), label.take(second)
        is_apart = first != second
        first, second = first[is_apart], second[is_apart]
        np.minimum.at(label, np.maximum(first, second), np.minimum(first, second))
        while not np.array_equal(label, least := label.take(label)):
            label = least
    return label
