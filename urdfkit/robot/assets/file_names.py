"""Names of files and packages, compared."""

import os
import re

from urdfkit.core.suggest import TYPO, nearest

_SEPARATORS = str.maketrans("_-.", "   ")


def is_mistyped(wrong: str, right: str) -> bool:
    """True if the name of a file or a package is a typo of another one.

    ``left_arm`` and ``right_arm``, ``link_1`` and ``link_2`` are two names: every word must be
    alike for itself, and all numbers equal.
    """
    if suffix(wrong) != suffix(right) or numbers_in(wrong) != numbers_in(right):
        return False
    words, others = _words(wrong), _words(right)
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
