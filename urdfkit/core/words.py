"""Counts, lists of names and vectors in messages."""

from collections.abc import Iterable, Sequence


def counted(number: int, thing: str) -> str:
    """``1 triangle``, ``12 triangles``."""
    return f"{number} {thing}{'' if number == 1 else 's'}"


def more_like_this(number: int) -> str:
    """The end of a message about several findings: ``(and 3 more like this)``; empty for none."""
    return f" (and {number} more like this)" if number else ""


def few(names: Sequence[str], most: int) -> str:
    """``a, b``; with more names than ``most``: ``a, b and 3 more``."""
    more = f" and {len(names) - most} more" if len(names) > most else ""
    return ", ".join(names[:most]) + more


def listed(names: Sequence[str], most: int | None = None) -> str:
    """``a``, ``a and b``, ``a, b and c``; with more than ``most``: ``a, b and 3 more``."""
    if most is not None and len(names) > most:
        return few(names, most)
    *first, last = names
    return f"{', '.join(first)} and {last}" if first else last


def spaced(values: Iterable[float], digits: int = 6) -> str:
    """``0.1 0 -2``: a vector in URDF, rounded to significant digits."""
    return " ".join(f"{value:.{digits}g}" for value in values)


def rounded(values: Iterable[float], places: int) -> str:
    """The same, rounded to decimal places, without ``-0``."""
    return spaced(round(value, places) + 0.0 for value in values)
