"""Store of the findings of a check without duplicates, each with its robots."""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import lru_cache
from itertools import islice

from urdfkit.core import disk
from urdfkit.core.memo import LIMIT
from urdfkit.core.static_typing import IO, overload
from urdfkit.text.diagnostic import Diagnostic, Severity
from urdfkit.text.source import shown

#: Number of files whose findings stay in memory during the check; others may go to disk.
IN_MEMORY = 100
#: Number of files whose findings a report contains in memory.
MAX_REPORTED = 500

#: A suggestion, and a name in quotes; a path or file name in quotes has a dot.
_NAME = re.compile(r"; did you mean '[^']*'\?|'[^'.]*'")

#: Findings of one rule at one place that differ in names only, by message; each with its robots
#: as path and variant.
_Group = dict[str, tuple[Diagnostic, list[tuple[str, str]]]]

#: Findings of a file, by code of the rule, place (first and last byte) and message without names.
_FileFindings = dict[tuple[str, int, int, str], _Group]


class FindingStore:
    """Findings by file, without duplicates.

    Robots of one run may include the same file by different paths; a defect in it is reported once.

    Args:
        spills: write the findings of the least recently used files to a temporary file.
    """

    def __init__(self, *, spills: bool) -> None:
        self.counts = dict.fromkeys(Severity, 0)  # number of findings of each severity
        self._spills = spills
        self._memory: dict[str, _FileFindings] = {}  # by real path; most recently used last
        self._disk: dict[str, int] = {}  # offset in the temporary file, by real path
        self._spilled: IO[bytes] | None = None
        self._files: dict[str, tuple[str, ...]] = {}  # real paths by displayed path
        self._variants: dict[str, set[str]] = {}  # names of variants by path of the description
        #: The real path and the displayed path of a file; cached, for files with many findings.
        self._real_and_shown = lru_cache(LIMIT)(lambda path: (disk.real(path), shown(path)))

    def __del__(self) -> None:
        if self._spilled is not None:
            self._spilled.close()

    def add(self, path: str, variant: str, diagnostics: Iterable[Diagnostic]) -> None:
        """Add the findings of a description with one set of arguments."""
        if variant:
            self._variants.setdefault(path, set()).add(variant)
        by_file: dict[str, dict[tuple[str, int, int, str], list[Diagnostic]]] = {}
        for finding in diagnostics:
            groups = by_file.setdefault(finding.span.source.path, {})
            key = (finding.code, *finding.span[1:], _NAME.sub("", finding.message))
            groups.setdefault(key, []).append(finding)
        for file, groups in by_file.items():
            file_findings = self._opened(file)
            for key, group in groups.items():
                self._add_group(file_findings.setdefault(key, {}), group, (path, variant))
        while self._spills and len(self._memory) > IN_MEMORY:
            self._spill(next(iter(self._memory)))

    def _add_group(self, known: _Group, group: list[Diagnostic], robot: tuple[str, str]) -> None:
        """Add findings of one robot that differ in names only.

        The same element may have another name in another robot or with other arguments. A new
        message is therefore merged into a known message that this robot does not have.
        """
        messages = {finding.message for finding in group}
        renamed = [
            message
            for message, (finding, _) in known.items()
            if message not in messages and finding.element
        ]
        for finding in group:
            message = finding.message
            if message not in known and renamed and finding.element:
                message = renamed.pop(0)
            first, robots = known.get(message, (finding, []))
            if robots:
                self.counts[first.severity] -= 1
            worst = _merged(first, finding)
            self.counts[worst.severity] += 1
            known[message] = (worst, [*robots, robot])

    def _opened(self, path: str) -> _FileFindings:
        """The findings of a file, loaded into memory."""
        file, name = self._real_and_shown(path)
        file_findings = self._memory[file] = self._pop(file)
        files = self._files.get(name, ())
        if file not in files:
            self._files[name] = (*files, file)
        return file_findings

    def diagnostics(self) -> Sequence[Diagnostic]:
        """All findings, sorted by file, place, code and message; call it after the last ``add``."""
        is_long = self._spills and len(self._files) > MAX_REPORTED
        return StoredFindings(self) if is_long else tuple(self.in_order())

    def in_order(self) -> Iterator[Diagnostic]:
        """An iterator over ``diagnostics``, which reads one file at a time."""
        for name, files in sorted(self._files.items()):
            groups = (group for file in files for group in self._peek(file).values())
            pairs = [pair for group in groups for pair in group.values()]
            names = {path: shown(path) for path in {one.span.source.path for one, _ in pairs}}
            pairs = [pair for pair in pairs if names[pair[0].span.source.path] == name]
            pairs.sort(key=lambda pair: (pair[0].span.start, pair[0].code, pair[0].message))
            for finding, robots in pairs:
                variants = _partial(robots, self._variants)
                yield finding._replace(variants=variants) if variants else finding

    def _pop(self, file: str) -> _FileFindings:
        """Remove the findings of a file from memory or disk and return them."""
        if file in self._disk:
            file_findings = self._peek(file)
            del self._disk[file]
            return file_findings
        return self._memory.pop(file, {})

    def _peek(self, file: str) -> _FileFindings:
        if file not in self._disk:
            return self._memory[file]
        import pickle

        assert self._spilled is not None
        self._spilled.seek(self._disk[file])
        file_findings: _FileFindings = pickle.load(self._spilled)
        return file_findings

    def _spill(self, file: str) -> None:
        import pickle
        import tempfile

        if self._spilled is None:
            self._spilled = tempfile.TemporaryFile()  # noqa: SIM115 - closed in __del__
        self._disk[file] = self._spilled.seek(0, 2)
        pickle.dump(self._memory.pop(file), self._spilled)


class StoredFindings(Sequence[Diagnostic]):
    """The findings of very many robots; each iteration reads them from disk."""

    def __init__(self, store: FindingStore) -> None:
        self.counts = store.counts  # number of findings of each severity
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
    """One finding in two robots: the more severe one, with the macro calls of both."""
    if other.severity.rank < first.severity.rank:  # severities may depend on arguments
        first, other = other, first
    known = {call.message for call in first.calls}
    calls = tuple(call for call in other.calls if call.message not in known)
    both = first.variants and other.variants
    variants = tuple(dict.fromkeys(first.variants + other.variants)) if both else ()
    if not calls and variants == first.variants:
        return first
    return first._replace(calls=first.calls + calls, variants=variants)


def _partial(robots: list[tuple[str, str]], variants: Mapping[str, set[str]]) -> tuple[str, ...]:
    """The names of the variants with a finding; empty if all variants of some robot have it."""
    names: dict[str, dict[str, None]] = {}
    for path, name in robots:
        names.setdefault(path, {})[name] = None
    if any("" in own or len(own) == len(variants[path]) for path, own in names.items()):
        return ()
    return tuple(dict.fromkeys(name for own in names.values() for name in own))
