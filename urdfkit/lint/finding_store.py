"""The findings of a check, each once, with the robots that it is found in."""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import islice

from urdfkit.core import disk
from urdfkit.core.memo import Memo
from urdfkit.core.static_typing import IO, overload
from urdfkit.text.diagnostic import Diagnostic, Severity
from urdfkit.text.source import shown

#: Files whose findings are kept in memory during the check, where others may go to disk.
IN_MEMORY = 100
#: Files whose findings a report holds in memory.
MAX_REPORTED = 500

#: A name in quotes; a path or file name in quotes has a dot.
_NAME = re.compile(r"'[^'.]*'")

#: The findings of one rule at one place that differ by names only, by message: each with the
#: robots that it is found in, by path and variant.
_Alike = dict[str, tuple[Diagnostic, list[tuple[str, str]]]]

#: The findings of a file, by the code of the rule, the place (first and last byte) and the message
#: without names.
_OfFile = dict[tuple[str, int, int, str], _Alike]


class FindingStore:
    """Findings by file, each once.

    Two robots of one run may include the same file, each in its own words; its defect is reported
    once.

    Args:
        spills: write the findings of files that were not met for long to a temporary file.
    """

    def __init__(self, *, spills: bool) -> None:
        self.counts = dict.fromkeys(Severity, 0)  # how many findings of each severity
        self._spills = spills
        self._memory: dict[str, _OfFile] = {}  # met last at the end
        self._disk: dict[str, int] = {}  # where each begins
        self._spilled: IO[bytes] | None = None
        #: The files by the name that they are shown by, which may be several.
        self._files: dict[str, tuple[str, ...]] = {}
        self._variants: dict[str, set[str]] = {}  # the names of those of a description
        self._paths: Memo[str, tuple[str, str]] = Memo()

    def __del__(self) -> None:
        if self._spilled is not None:
            self._spilled.close()

    def add(self, path: str, variant: str, diagnostics: Iterable[Diagnostic]) -> None:
        """Add what is found in a description with one set of arguments."""
        if variant:
            self._variants.setdefault(path, set()).add(variant)
        by_file: dict[str, dict[tuple[str, int, int, str], list[Diagnostic]]] = {}
        for one in diagnostics:
            groups = by_file.setdefault(one.span.source.path, {})
            key = (one.code, *one.span[1:], _NAME.sub("''", one.message))
            groups.setdefault(key, []).append(one)
        for file, groups in by_file.items():
            of_file = self._opened(file)
            for key, group in groups.items():
                self._add_group(of_file.setdefault(key, {}), group, (path, variant))
        while self._spills and len(self._memory) > IN_MEMORY:
            self._spill(next(iter(self._memory)))

    def _add_group(self, known: _Alike, group: list[Diagnostic], robot: tuple[str, str]) -> None:
        """Add findings of one robot that differ by names only.

        In another robot, or with other arguments, the same element has other names: a finding that
        this robot lacks is the same one with other names.
        """
        messages = {one.message for one in group}
        renamed = [name for name, (one, _) in known.items() if name not in messages and one.element]
        for one in group:
            message = one.message
            if message not in known and renamed and one.element:
                message = renamed.pop(0)
            first, robots = known.get(message, (one, []))
            if robots:
                self.counts[first.severity] -= 1
            worst = _merged(first, one)
            self.counts[worst.severity] += 1
            known[message] = (worst, [*robots, robot])

    def _opened(self, path: str) -> _OfFile:
        """The findings of a file, for additions."""
        file, name = self._real_and_shown(path)
        of_file = self._memory[file] = self._of_file(file)
        files = self._files.get(name, ())
        if file not in files:
            self._files[name] = (*files, file)
        return of_file

    def _real_and_shown(self, path: str) -> tuple[str, str]:
        """A path without links, and as it is shown; worked out once for all findings of a file."""
        if path not in self._paths:
            self._paths[path] = disk.real(path), shown(path)
        return self._paths[path]

    def diagnostics(self) -> Sequence[Diagnostic]:
        """All findings, by file, place, code and message; nothing is added afterwards."""
        is_long = self._spills and len(self._files) > MAX_REPORTED
        return StoredFindings(self) if is_long else tuple(self.in_order())

    def in_order(self) -> Iterator[Diagnostic]:
        """As ``diagnostics``, one after another."""
        for name, files in sorted(self._files.items()):
            groups = (group for file in files for group in self._peek(file).values())
            found = [pair for group in groups for pair in group.values()]
            names = {one.span.source.path: "" for one, _ in found}
            names = {path: shown(path) for path in names}
            found = [pair for pair in found if names[pair[0].span.source.path] == name]
            found.sort(key=lambda pair: (pair[0].span.start, pair[0].code, pair[0].message))
            for one, found_in in found:
                variants = _partial(found_in, self._variants)
                yield one._replace(variants=variants) if variants else one

    def _of_file(self, file: str) -> _OfFile:
        """The findings of a file, which are then to be put at the end of those in memory."""
        if file in self._disk:
            of_file = self._peek(file)
            del self._disk[file]
            return of_file
        return self._memory.pop(file, {})

    def _peek(self, file: str) -> _OfFile:
        if file not in self._disk:
            return self._memory[file]
        import pickle

        assert self._spilled is not None
        self._spilled.seek(self._disk[file])
        of_file: _OfFile = pickle.load(self._spilled)
        return of_file

    def _spill(self, file: str) -> None:
        import pickle
        import tempfile

        if self._spilled is None:
            self._spilled = tempfile.TemporaryFile()  # noqa: SIM115 - as long as the findings
        self._disk[file] = self._spilled.seek(0, 2)
        pickle.dump(self._memory.pop(file), self._spilled)


class StoredFindings(Sequence[Diagnostic]):
    """The findings of very many robots, read from disk again each time they are gone through."""

    def __init__(self, store: FindingStore) -> None:
        self.counts = store.counts  # how many findings of each severity
        self._store = store

    def __len__(self) -> int:
        return sum(self.counts.values())

    def __iter__(self) -> Iterator[Diagnostic]:
        return self._store.in_order()

    @overload
    def __getitem__(self, index: int) -> Diagnostic: ...
    @overload
    def __getitem__(self, index: slice) -> Sequence[Diagnostic]: ...
    def __getitem__(self, index: int | slice) -> Diagnostic | Sequence[Diagnostic]:
        if isinstance(index, slice):
            numbers = index.indices(len(self))
            return tuple(islice(self, *numbers))
        return next(islice(self, range(len(self))[index], None))


def _merged(first: Diagnostic, other: Diagnostic) -> Diagnostic:
    """One finding in two robots: the worse one, with the calls of the other, if they differ."""
    if other.severity.rank < first.severity.rank:  # with other arguments it is an error
        first, other = other, first
    known = {call.message for call in first.calls}
    calls = tuple(call for call in other.calls if call.message not in known)
    both = first.variants and other.variants
    variants = tuple(dict.fromkeys(first.variants + other.variants)) if both else ()
    if not calls and variants == first.variants:
        return first
    return first._replace(calls=first.calls + calls, variants=variants)


def _partial(found_in: list[tuple[str, str]], variants: Mapping[str, set[str]]) -> tuple[str, ...]:
    """The names of variants with a finding; none if it is in all those of some robot."""
    names: dict[str, dict[str, None]] = {}
    for path, name in found_in:
        names.setdefault(path, {})[name] = None
    if any("" in own or len(own) == len(variants[path]) for path, own in names.items()):
        return ()
    return tuple(dict.fromkeys(name for own in names.values() for name in own))
