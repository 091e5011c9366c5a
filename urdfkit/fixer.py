"""Applying text edits."""

from __future__ import annotations

from collections.abc import Iterable

from urdfkit.diagnostic import Edit


def apply_edits(data: bytes, edits: Iterable[Edit]) -> bytes:
    """The text of a source after some edits of it.

    Args:
        data: of the source that all the edits are in.
        edits: in any order; where two insert at one place, they do so in the order given.

    Raises:
        ValueError: two edits overlap, or one lies outside the text.
    """
    pieces: list[bytes] = []
    done = 0
    for span, text in sorted(edits, key=lambda edit: edit.span[1:]):
        if span.start < done:
            raise ValueError(f"two edits overlap at {span}")
        if not span.start <= span.end <= len(data):
            raise ValueError(f"bytes {span.start} to {span.end} are not in the text")
        pieces += (data[done : span.start], text.encode())
        done = span.end
    return b"".join([*pieces, data[done:]])
