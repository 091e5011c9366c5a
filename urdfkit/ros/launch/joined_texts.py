"""Texts and paths of several parts, some of which may be known only at run time."""

import os
from collections.abc import Iterable

from urdfkit.core import disk

#: Greatest length of a text: lists of lists double it at each level.
_MAX_LENGTH = 100_000


def joined(parts: Iterable[str | None]) -> str | None:
    """Concatenated texts; None if one of them is unknown, or if the result is too long."""
    texts = _all_known(parts)
    text = None if texts is None else "".join(texts)
    return None if text is None or len(text) > _MAX_LENGTH else text


def joined_path(parts: Iterable[str | None]) -> str | None:
    """Joined path; an absolute part drops the parts before it.

    An argument whose default is empty is the name of a directory that the caller has to pass: None,
    unless the path exists without it.
    """
    texts = _all_known(parts)
    if texts is None:
        return None
    path = os.path.join("", *texts)
    is_open = "" in texts[1:-1] and os.path.isabs(path) and not disk.exists(path)
    return None if is_open else path


def _all_known(parts: Iterable[str | None]) -> list[str] | None:
    texts = list(parts)
    known = [text for text in texts if text is not None]
    return known if len(known) == len(texts) else None
