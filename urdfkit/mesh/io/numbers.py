"""Parsing of the numbers in text mesh files."""

from collections.abc import Iterator

import numpy as np

from urdfkit.mesh.geometry import Floats, Integers

#: Characters that are split into words at once; a word takes ten times its length in memory.
_BLOCK = 1 << 20


def floats(text: str) -> Floats:
    """The words of a text as numbers; nan for other words."""
    pieces = [_floats(piece) for piece in _pieces(text)]
    return np.concatenate(pieces) if pieces else np.zeros(0)


def integers(text: str) -> Integers:
    """The words of a text as integers; -1 for other words."""
    if text.isascii() and not text.encode().translate(None, b"0123456789 \t\r\n"):
        # Ten times as fast, but returns -1 for an empty text.
        return np.fromstring(text, dtype=np.int64, sep=" ") if text.strip() else _NO_INTEGERS
    pieces = [_integers(piece) for piece in _pieces(text)]
    return np.concatenate(pieces) if pieces else _NO_INTEGERS


_NO_INTEGERS: Integers = np.zeros(0, dtype=np.int64)


def _pieces(text: str) -> Iterator[str]:
    """The text in pieces that end between words."""
    start = 0
    while start < len(text):
        end = min(start + _BLOCK, len(text))
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
