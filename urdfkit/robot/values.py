"""Numbers in attribute values, as URDF parsers read them."""

from math import isfinite

from urdfkit.core.spatial import Vector


def number(text: str | None) -> float | None:
    """A finite number as URDF parsers read it, or None."""
    values = numbers(text)
    return values[0] if values and len(values) == 1 else None


def numbers(text: str | None) -> tuple[float, ...] | None:
    """Finite numbers separated by white space, or None."""
    if text is None or "_" in text:  # Python alone reads 1_000
        return None
    try:
        values = tuple(map(float, text.split()))
    except ValueError:
        return None
    return values if all(map(isfinite, values)) else None


def vector(text: str | None) -> Vector | None:
    """Three finite numbers, or None."""
    values = numbers(text)
    return (values[0], values[1], values[2]) if values and len(values) == 3 else None
