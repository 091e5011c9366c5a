"""Suggestions for misspelt words and names."""

import os
import re
from collections.abc import Collection, Iterable

from urdfkit.core import disk

#: Least similarity (`difflib` ratio, 0 to 1) of a word to be suggested, of a file name, of a word
#: that is assumed to be the same, misspelt, and of such a word among names that are much alike.
SIMILAR, SIMILAR_FILE, TYPO, CLOSE_TYPO = 0.6, 0.7, 0.8, 0.93

#: Least similarity of two names without their common suffix: ``caster_link`` is not ``base_link``,
#: nor is ``laser_link``, which begins with another letter.
_WITHOUT_SUFFIX, _OF_ANOTHER_INITIAL = 0.65, 0.75

#: Least similarity of two words at the same place in a name: ``cam_link``, ``camera_link``.
_MIN_WORD_SIMILARITY = 0.4

#: Candidates that are compared again without their common suffix.
_MAX_COMPARED = 3

#: Least similarity of two words of file names.
_SIMILAR_WORD = 0.75

#: Longer words are not compared: they are not typos of a name, and it would take time.
_MAX_LENGTH = 200

#: Parts of names that distinguish siblings.
_SIDES = frozenset("left right front rear back upper lower inner outer fl fr rl rr l r".split())

#: Words for the kind of the named thing, which people omit.
_KINDS = frozenset(("link", "joint", "frame", "name"))
_KIND_SUFFIX = rf"_({'|'.join(sorted(_KINDS))})_?\d*$"

#: Beginnings of names that say the opposite: ``max_linear_speed`` is not ``min_speed``.
_OPPOSITES = {"min": "max", "max": "min"}

#: What parts the words of a file name.
_SEPARATOR = r"[._-]"

#: A word in a name, as in base_link or hackBaseline.
_WORD = r"[^\W_]?[^\W_A-Z]+|[A-Z]+"


def nearest(word: str, known: Iterable[str], cutoff: float = SIMILAR) -> str | None:
    """The known word most similar to ``word``, ignoring case; None if none is similar."""
    text = word[:_MAX_LENGTH].casefold()
    spellings = {candidate.casefold(): candidate for candidate in known}
    spellings = {key: spellings[key] for key in spellings if _may_be_similar(text, key, cutoff)}
    if not spellings:
        return None
    from difflib import get_close_matches  # 1 ms, and most unknown words resemble none

    close = get_close_matches(text, spellings, _MAX_COMPARED, cutoff)
    for candidate in sorted(close, key=lambda key: not _differs_in_kind(text, key)):
        stem, other = _without_common_suffix(text, candidate)
        least = _WITHOUT_SUFFIX if stem[:1] == other[:1] else _OF_ANOTHER_INITIAL
        least = least if cutoff else 0  # the nearest of all, however different
        short, long = sorted((stem, other), key=len)
        is_longer = long.startswith(f"{short}_")
        if stem == text or is_longer or get_close_matches(stem, [other], 1, least):
            return spellings[candidate]
    return None


def _may_be_similar(word: str, other: str, cutoff: float) -> bool:
    """False if two words have too few letters in common, in any order."""
    letters = len(word) + len(other)
    if 2 * min(len(word), len(other)) < cutoff * letters:
        return False
    common = sum(min(word.count(letter), other.count(letter)) for letter in set(word))
    return 2 * common >= cutoff * letters


def _differs_in_kind(word: str, other: str) -> bool:
    """True for ``arm`` and ``arm_link``."""
    short, long = sorted((word, other), key=len)
    return long.removeprefix(short + "_") in _KINDS


def _without_common_suffix(word: str, other: str) -> tuple[str, str]:
    """Two names without a common suffix such as ``_link``, which does not make them similar.

    It may have a number: ``finger_joint1`` and ``laser_joint``.
    """
    own, others = re.search(_KIND_SUFFIX, word), re.search(_KIND_SUFFIX, other)
    if own and others and own[1] == others[1] and own.start() and others.start():
        return word[: own.start()], other[: others.start()]
    return word, other


def is_typo(word: str, other: str) -> bool:
    """True if two words are equal, or differ by one letter or two swapped neighbours.

    Names that differ in digits are siblings, not typos.
    """
    if abs(len(word) - len(other)) > 1:
        return False
    start = 0
    while word[start : start + 1] == other[start : start + 1] != "":
        start += 1
    end = 0
    while end < min(len(word), len(other)) - start and word[-1 - end] == other[-1 - end]:
        end += 1
    left, right = word[start : len(word) - end], other[start : len(other) - end]
    is_small = max(len(left), len(right)) <= 1 or (len(left) == 2 and left == right[::-1])
    return is_small and not any(map(str.isdigit, left + right))


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """``; did you mean 'arm'?``, or nothing if no known word is similar."""
    return hint_for(nearest(word, known))


def hint_for(suggested: str | None) -> str:
    """``; did you mean 'arm'?``, or nothing without a suggestion."""
    return f"; did you mean '{suggested}'?" if suggested else ""


def nearest_file(path: str) -> str | None:
    """Name of the file next to a missing file that has the most similar name; same suffix."""
    directory, name = os.path.split(path)
    return nearest_file_name(name, disk.names_or_empty(directory))


def nearest_file_name(name: str, known: Iterable[str]) -> str | None:
    """The known file name most similar to ``name``; None if none is similar, or of its suffix.

    ``arm.urdf`` may be made of ``arm.urdf.xacro``, which is the nearest then. Next is ``ARM.urdf``,
    then a name with other separators: ``arm.gazebo.xacro`` for ``arm_gazebo.xacro``.
    Suffixes make no names similar: ``start_cameras.launch.xml`` is not ``start_driver.launch.xml``,
    and different ones make them different: ``arm.srdf.xacro`` is not ``arm.ros2_control.xacro``.
    Nor do common words: ``chomp_planning.yaml`` is not ``ompl_planning.yaml``. Other numbers make
    them different, too: ``dg4f.xacro``, a hand of four fingers, is not ``dg5f.xacro``.
    """
    names = sorted(known)
    if (expanded := f"{name}.xacro") in names:
        return expanded
    folded = name.casefold()
    if same := next((other for other in names if other.casefold() == folded), None):
        return same
    joined = re.sub(_SEPARATOR, "", folded)
    if same := next((n for n in names if re.sub(_SEPARATOR, "", n.casefold()) == joined), None):
        return same
    kind = os.path.splitext(name)[1]
    stem, _, suffix = name.partition(".")
    stems: dict[str, str] = {}
    for other in names:
        first, _, rest = other.partition(".")
        is_of_kind = _is_of_kind(suffix, rest) and not _differ_in_numbers(stem, first)
        if is_of_kind and (rest == suffix or first not in stems):
            stems[first] = other
    for _ in range(_MAX_COMPARED):
        suggested = nearest(stem, stems)
        if suggested is None or has_similar_words(stem, suggested, kind[1:]):
            return stems[suggested] if suggested else None
        del stems[suggested]
    return None


def _differ_in_numbers(name: str, other: str) -> bool:
    numbers, others = (
        re.findall(r"(?<=[a-z])\d+(?=[a-z])", one.casefold()) for one in (name, other)
    )
    return len(numbers) == len(others) and numbers != others


def _is_of_kind(suffix: str, other: str) -> bool:
    """True for suffixes that a file may have instead: ``.xacro`` for ``.urdf.xacro``."""
    *parts, last = suffix.split(".")
    *others, other_last = other.split(".")
    if last != other_last:
        return False
    return not (parts and others) or nearest(parts[-1], others[-1:]) is not None


def has_similar_words(name: str, other: str, kind: str = "") -> bool:
    """True if each word of the name with fewer words is similar to one of the other, or begins it.

    So are names that differ in ``_`` or ``-`` alone. The kind of file, as in ``rviz.rviz``, says
    nothing.
    """
    few, many = sorted((_file_words(name), _file_words(other)), key=len)
    telling = [word for word in few if word != kind]
    if telling and all(any(_is_similar_word(word, one) for one in many) for word in telling):
        return True
    return nearest("".join(few), ["".join(many)], CLOSE_TYPO) is not None


def _file_words(name: str) -> list[str]:
    return [word for word in re.split(r"[\W_]+", name.casefold()) if word]


def _is_similar_word(word: str, other: str) -> bool:
    if word.isdigit() or other.isdigit():
        return word == other
    return (
        word.startswith(other)
        or other.startswith(word)
        or nearest(word, [other], _SIMILAR_WORD) is not None
    )


class Suggester:
    """Suggests known names for unknown ones, with bounded work.

    Names of siblings are not typos of each other: ``wheel_5`` does not suggest ``wheel_4`` or
    ``wheel_b``, ``left_arm`` not ``right_arm``, ``base_imu_link`` not ``base_link``,
    ``rl_wheel_link`` not ``caster_wheel_link``, ``baseline`` not ``hackBaseline``.
    """

    #: Most unknown names that get a suggestion, and most known names they are compared with.
    MAX_WORDS = 50
    MAX_KNOWN = 5000

    def __init__(self, known: Collection[str], cutoff: float = TYPO) -> None:
        self._cutoff = cutoff
        known = known if len(known) <= self.MAX_KNOWN else ()
        # A name with a space is a mistake itself (NAM004).
        self._known = [name for name in known if not any(map(str.isspace, name))]
        self._found: dict[str, str] = {}

    def hint(self, word: str) -> str:
        """``; did you mean 'arm'?``, or nothing if the name is not a typo."""
        return hint_for(self.suggested(word))

    def suggested(self, word: str) -> str:
        """The known name that a misspelt name stands for; empty if there is none."""
        if word not in self._found:
            if len(self._found) >= self.MAX_WORDS:
                return ""
            self._found[word] = self._likely(word)
        return self._found[word]

    def _likely(self, word: str) -> str:
        """The known name; a common namespace does not make names similar."""
        if known := self._in_another_namespace(word) or self._with_kind(word):
            return known
        if known := self._with_equal_words(word):
            return known
        space, slash, name = word.rpartition("/")
        space += slash
        inside = [known.removeprefix(space) for known in self._known if known.startswith(space)]
        if opposite := _OPPOSITES.get(name[:3].casefold()):
            inside = [known for known in inside if known[:3].casefold() != opposite]
        suggestion = nearest(name, inside, self._cutoff)
        return space + suggestion if suggestion and not _are_siblings(name, suggestion) else ""

    def _with_kind(self, word: str) -> str:
        """The known name that has the kind of thing as a further word: ``lidar_link``."""
        names = (f"{word}_{kind}" for kind in ("link", "frame", "joint"))
        return next((name for name in names if name in self._known), "")

    def _with_equal_words(self, word: str) -> str:
        """The only known name with the words in another order, or parted otherwise.

        As ``wheel_left_joint`` for ``left_wheel_joint``, and ``joint_1`` for ``joint1``.
        """
        for key in (_letters, _sorted_words):
            equal = [known for known in self._known if key(known) == key(word)]
            if len(equal) == 1:
                return equal[0]
        return ""

    def _in_another_namespace(self, word: str) -> str:
        """The only known name that differs in its namespace alone; empty if there is none."""
        space, _, name = word.rpartition("/")
        equal = [known for known in self._known if known.rpartition("/")[2] == name]
        if len(equal) != 1:
            return ""
        other = equal[0].rpartition("/")[0]
        return "" if space and other and _are_siblings(space, other) else equal[0]


def _are_siblings(word: str, other: str) -> bool:
    sides, others = _sides(word), _sides(other)
    return (
        bool(sides and others and sides != others)
        or _numbers(sides) != _numbers(others)
        or _has_more_words(word, other)
        or _has_another_word(word, other)
    )


def _has_more_words(word: str, other: str) -> bool:
    """True if one name has words that the other lacks, other than the kind of thing."""
    words, others = _words(word), _words(other)
    if {"link", "joint"} <= words ^ others:
        return True  # a link is not a joint
    if len(others) > 1 and others < words:
        return not words - others <= _KINDS
    is_cut_short = other.casefold().startswith(word.casefold())
    if words < others:
        return not (others - words <= _KINDS or is_cut_short)
    own, misspelt = words - others, others - words
    # Of ``front_rotation`` and ``frnt`` one is no typo.
    return len(own) > len(misspelt) > 0 and all(nearest(each, own) for each in misspelt)


def _has_another_word(word: str, other: str) -> bool:
    """True if the names differ in one word, by nearly all of its letters."""
    pairs = list(zip(word.casefold().split("_"), other.casefold().split("_"), strict=False))
    different = [pair for pair in pairs if pair[0] != pair[1]]
    if len(pairs) < 2 or word.count("_") != other.count("_") or len(different) != 1:
        return False
    ((left, right),) = different
    return nearest(left, [right], _MIN_WORD_SIMILARITY) is None


def _words(name: str) -> set[str]:
    parts = name.split("_") if name.islower() or name.isupper() else re.findall(_WORD, name)
    return {part.casefold() for part in parts}


def _letters(name: str) -> str:
    return name.replace("-", "").replace("_", "").casefold()


def _sorted_words(name: str) -> tuple[list[str], list[str]]:
    """The words of a name; sides and numbers keep their order, which tells siblings apart."""
    return sorted(name.casefold().split("_")), _sides(name)


def _numbers(sides: list[str]) -> list[str]:
    return [side for side in sides if side.isdigit()]


def _sides(name: str) -> list[str]:
    parts = re.findall(r"[a-z]+|\d+", name.casefold())
    return [part for part in parts if part in _SIDES or part.isdigit()]
