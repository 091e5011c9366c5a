"""The word that was probably meant."""

from __future__ import annotations

from collections.abc import Iterable

#: Longer words are no slips of a name, and comparing them takes time.
_LONGEST = 200


def nearest(word: str, known: Iterable[str], likeness: float = 0.6) -> str | None:
    """The known word most like ``word``, upper and lower case alike; None if none is like it.

    ``likeness`` is the least ratio of common letters, from 0 to 1.
    """
    from difflib import get_close_matches  # 1 ms, and needed after a slip only

    spellings = {candidate.casefold(): candidate for candidate in known}
    found = get_close_matches(word[:_LONGEST].casefold(), spellings, n=1, cutoff=likeness)
    return spellings[found[0]] if found else None


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """``; did you mean 'arm'?``, or nothing if no known word is like ``word``."""
    found = nearest(word, known)
    return f"; did you mean '{found}'?" if found else ""
