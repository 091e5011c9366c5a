"""Comparison of names of files and packages."""

import os
import re

from urdfkit.core.suggest import TYPO, nearest

_SEPARATORS = str.maketrans("_-.", "   ")


def is_mistyped(name: str, candidate: str) -> bool:
    """True if the name of a file or a package is a typo of another one.

    Every word must be similar, and all numbers equal, so that ``left_arm`` and ``right_arm``, or
    ``link_1`` and ``link_2``, are not typos.
    """
    if suffix(name) != suffix(candidate) or numbers_in(name) != numbers_in(candidate):
        return False
    words, others = _words(name), _words(candidate)
    if "".join(words) == "".join(others):
        return True
    return len(words) == len(others) and all(
        word == other or (min(len(word), len(other)) >= 4 and nearest(word, [other], TYPO))
        for word, other in zip(words, others, strict=True)
    )


def numbers_in(name: str) -> list[str]:
    return re.findall(r"\d+", name)


def _words(name: str) -> list[str]:
    return os.path.splitext(name)[0].casefold().translate(_SEPARATORS).split()


def stem(name: str) -> str:
    return os.path.splitext(os.path.basename(name))[0].casefold()


def suffix(name: str) -> str:
    return os.path.splitext(name)[1].lower()
