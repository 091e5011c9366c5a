"""Several names in a sentence."""

from __future__ import annotations

from collections.abc import Sequence


def few(names: Sequence[str], most: int) -> str:
    """``a, b``, or of more names ``a, b and 3 more``."""
    more = f" and {len(names) - most} more" if len(names) > most else ""
    return ", ".join(names[:most]) + more


def listed(names: Sequence[str], most: int | None = None) -> str:
    """``a``, ``a and b``, ``a, b and c``; of more names than ``most``, ``a, b and 3 more``."""
    if most is not None and len(names) > most:
        return few(names, most)
    *first, last = names
    return f"{', '.join(first)} and {last}" if first else last
