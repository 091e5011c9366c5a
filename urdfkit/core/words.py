"""Numbers of things, and several names, in a sentence."""

from collections.abc import Sequence


def counted(number: int, thing: str) -> str:
    """``1 triangle``, ``12 triangles``."""
    return f"{number} {thing}{'' if number == 1 else 's'}"


def more_like_this(number: int) -> str:
    """The end of a message about several findings: ``(and 3 more like this)``; empty for none."""
    return f" (and {number} more like this)" if number else ""


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
