"""Numbers in the text of mesh files."""

from collections.abc import Iterator

import numpy as np

from urdfkit.mesh.geometry import Floats, Integers

#: Characters of a text that are split into words at once; a word needs ten times its length.
_AT_ONCE = 1 << 20


def floats(text: str) -> Floats:
    """The numbers of a text; what is none becomes nan."""
    pieces = [_floats(piece) for piece in _pieces(text)]
    return np.concatenate(pieces) if pieces else np.zeros(0)


def integers(text: str) -> Integers:
    """The whole numbers of a text; what is none becomes -1."""
    if text.isascii() and not text.encode().translate(None, b"0123456789 \t\r\n"):
        # Reads nothing as -1, and is ten times as fast.
        return np.fromstring(text, dtype=np.int64, sep=" ") if text.strip() else _NO_INTEGERS
    pieces = [_integers(piece) for piece in _pieces(text)]
    return np.concatenate(pieces) if pieces else _NO_INTEGERS


_NO_INTEGERS: Integers = np.zeros(0, dtype=np.int64)


def _pieces(text: str) -> Iterator[str]:
    """The text in parts that end between two words."""
    start = 0
    while start < len(text):
        end = min(start + _AT_ONCE, len(text))
        while end < len(text) and not text[end].isspace():
            end += 1
        yield text[start:end]
        start = end


def _floats(text: str) -> Floats:
    words = text.split()
    try:
        return np.array(words, dtype=np.float64)
    except ValueError:
        return np.array([_float(word) for word in words])


def _float(word: str) -> float:
    try:
        return float(word)
    except ValueError:
        return float("nan")


def _integers(text: str) -> Integers:
    values = _floats(text)
    whole = np.isfinite(values) & (np.abs(values) < 2**53)
    return np.where(whole, values, -1).astype(np.int64)
