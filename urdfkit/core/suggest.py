"""The word that was probably meant."""

import os
import re
from collections.abc import Collection, Iterable

from urdfkit.core import disk

#: Least ratios of common letters, from 0 to 1: of a word that is worth offering, of the name of a
#: file, and of a word that is taken for the same, misspelt.
SIMILAR, SIMILAR_FILE, TYPO = 0.6, 0.7, 0.8

#: The same of two names without their common end: ``caster_link`` is no typo of ``base_link``.
_WITHOUT_END = 0.65

#: Least ratio of a word in a name and the one in its place: ``cam_link``, ``camera_link``.
_RELATED = 0.4

#: Candidates, of which the first is taken that is like a word without a common end, too.
_COMPARED = 3

#: Longer words are no typos of a name, and comparing them takes time.
_LONGEST = 200

#: Parts of names that distinguish siblings.
_SIDES = frozenset("left right front rear back upper lower inner outer fl fr rl rr l r".split())

#: What a name may say of the thing that has it, and people leave out.
_KINDS = frozenset(("link", "joint", "frame", "name"))

#: A word in a name, as in base_link or hackBaseline.
_WORD = r"[^\W_]?[^\W_A-Z]+|[A-Z]+"


def nearest(word: str, known: Iterable[str], cutoff: float = SIMILAR) -> str | None:
    """The known word most like ``word``, upper and lower case alike; None if none is like it."""
    text = word[:_LONGEST].casefold()
    spellings = {candidate.casefold(): candidate for candidate in known}
    spellings = {one: spellings[one] for one in spellings if _may_be_like(text, one, cutoff)}
    if not spellings:
        return None
    from difflib import get_close_matches  # 1 ms, and most unknown words are like no other

    close = get_close_matches(text, spellings, _COMPARED, cutoff)
    for found in sorted(close, key=lambda found: not _differs_in_kind(text, found)):
        one, other = _without_common_end(text, found)
        if one == text or get_close_matches(one, [other], 1, min(cutoff, _WITHOUT_END)):
            return spellings[found]
    return None


def _may_be_like(word: str, other: str, cutoff: float) -> bool:
    """False if two words have too few letters in common, in whatever order."""
    letters = len(word) + len(other)
    if 2 * min(len(word), len(other)) < cutoff * letters:
        return False
    common = sum(min(word.count(one), other.count(one)) for one in set(word))
    return 2 * common >= cutoff * letters


def _differs_in_kind(word: str, other: str) -> bool:
    """True for ``arm`` and ``arm_link``."""
    short, long = sorted((word, other), key=len)
    return long.removeprefix(short + "_") in _KINDS


def _without_common_end(word: str, other: str) -> tuple[str, str]:
    """Two names without the kind of thing that both end in: ``_link`` makes no names alike."""
    one, _, end = word.rpartition("_")
    if one and end in _KINDS and other.endswith("_" + end):
        return one, other[: -len(end) - 1]
    return word, other


def is_typo(word: str, other: str) -> bool:
    """True if two words differ in one letter, or in two that changed places, or not at all.

    Digits are not compared as letters: they distinguish siblings.
    """
    if abs(len(word) - len(other)) > 1:
        return False
    start = 0
    while word[start : start + 1] == other[start : start + 1] != "":
        start += 1
    end = 0
    while end < min(len(word), len(other)) - start and word[-1 - end] == other[-1 - end]:
        end += 1
    one, two = word[start : len(word) - end], other[start : len(other) - end]
    is_small = max(len(one), len(two)) <= 1 or (len(one) == 2 and one == two[::-1])
    return is_small and not any(map(str.isdigit, one + two))


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """``; did you mean 'arm'?``, or nothing if no known word is like ``word``."""
    found = nearest(word, known)
    return f"; did you mean '{found}'?" if found else ""


def nearest_file(path: str) -> str | None:
    """The file in the directory of a missing file whose name is most like it, with its suffix."""
    directory, name = os.path.split(path)
    stem, suffix = os.path.splitext(name)
    siblings = map(os.path.splitext, disk.names(directory) if disk.is_directory(directory) else ())
    suggested = nearest(stem, [other for other, kind in siblings if kind == suffix])
    return suggested and suggested + suffix


class Suggester:
    """Suggests known names for unknown ones, with bounded work.

    Siblings are not typos of one another: ``wheel_5`` does not suggest ``wheel_4`` or
    ``wheel_b``, ``left_arm`` not ``right_arm``, ``base_imu_link`` not ``base_link``,
    ``rl_wheel_link`` not ``caster_wheel_link``. A word in front changes the meaning, too:
    ``baseline`` does not suggest ``hackBaseline``.
    """

    #: Unknown names that get a suggestion, and known ones that each is compared with.
    MAX_WORDS = 50
    MAX_KNOWN = 5000

    def __init__(self, known: Collection[str], cutoff: float = TYPO) -> None:
        self._cutoff = cutoff
        known = known if len(known) <= self.MAX_KNOWN else ()
        # A name with a space is itself the mistake (NAM004).
        self._known = [one for one in known if not any(map(str.isspace, one))]
        self._found: dict[str, str] = {}

    def hint(self, word: str) -> str:
        """``; did you mean 'arm'?``, or nothing if the name is no typo."""
        found = self.suggested(word)
        return f"; did you mean '{found}'?" if found else ""

    def suggested(self, word: str) -> str:
        """The known name of which a name is a typo; empty if there is none."""
        if word not in self._found:
            if len(self._found) >= self.MAX_WORDS:
                return ""
            self._found[word] = self._likely(word)
        return self._found[word]

    def _likely(self, word: str) -> str:
        """The known name; a namespace that both have in front makes no names alike."""
        space, slash, name = word.rpartition("/")
        if slash and name in self._known:
            return name
        space += slash
        inside = [one.removeprefix(space) for one in self._known if one.startswith(space)]
        found = nearest(name, inside, self._cutoff)
        return space + found if found and not _are_siblings(name, found) else ""


def _are_siblings(word: str, other: str) -> bool:
    sides, others = _sides(word), _sides(other)
    return (
        bool(sides and others and sides != others)
        or _numbers(sides) != _numbers(others)
        or _has_more_words(word, other)
        or _has_another_word(word, other)
    )


def _has_more_words(word: str, other: str) -> bool:
    """True if one name is the other with more words than those that say what has it."""
    words, others = _words(word), _words(other)
    if {"link", "joint"} <= words ^ others:
        return True  # a link is no joint
    if len(others) > 1 and others < words:
        return not words - others <= _KINDS
    is_cut_short = other.casefold().startswith(word.casefold())
    return words < others and not (others - words <= _KINDS or is_cut_short)


def _has_another_word(word: str, other: str) -> bool:
    """True if one word of the names differs, and has hardly a letter of the other."""
    pairs = list(zip(word.casefold().split("_"), other.casefold().split("_"), strict=False))
    apart = [pair for pair in pairs if pair[0] != pair[1]]
    if len(pairs) < 2 or word.count("_") != other.count("_") or len(apart) != 1:
        return False
    (one, another), *_ = apart
    return nearest(one, [another], _RELATED) is None


def _words(name: str) -> set[str]:
    parts = name.split("_") if name.islower() or name.isupper() else re.findall(_WORD, name)
    return {part.casefold() for part in parts}


def _numbers(sides: list[str]) -> list[str]:
    return [side for side in sides if side.isdigit()]


def _sides(name: str) -> list[str]:
    parts = re.findall(r"[a-z]+|\d+", name.casefold())
    return [part for part in parts if part in _SIDES or part.isdigit()]
