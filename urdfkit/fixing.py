"""fix(): what has a remedy is mended in the text, round by round, until nothing is left to mend.

A round applies the fixes of a check to the texts in memory and checks again. Files are written
at the end, or not at all.
"""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from itertools import zip_longest
from typing import TYPE_CHECKING

from urdfkit import rewriting
from urdfkit.config import Config
from urdfkit.diagnostic import Diagnostic, Edit, Report
from urdfkit.discovery import affected
from urdfkit.engine import check
from urdfkit.errors import UnreadableFile
from urdfkit.fixer import apply_edits, encoded, overlap
from urdfkit.ownership import Ownership
from urdfkit.record import Record
from urdfkit.resolve import Resolver
from urdfkit.rewriting import Rewrite, on_disk, shown
from urdfkit.source import Source

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from urdfkit.engine import Options

MAX_ROUNDS = 10

#: Fixes that compute from other values of the robot wait until those are settled: a tensor comes
#: from the shapes of its link, which other fixes turn, move and scale.
_LAST = ("INE", "XAC014")

#: A finding in any round: its code, its file and its message, since places move.
_Key = tuple[str, str, str]


class Left(Record):
    """A finding that fixes did not mend, and why.

    Attributes:
        diagnostic: as the last check found it.
        reason: why its fix was not applied; empty if it has none.
    """

    diagnostic: Diagnostic
    reason: str


class Fixes(Record):
    """What mending some descriptions came to; nothing is written before ``write``.

    Attributes:
        files: that change, sorted by path.
        applied: what was mended, as the check of its round found it.
        left: what the last check still found.
        report: of the last check.
    """

    files: tuple[Rewrite, ...]
    applied: tuple[Diagnostic, ...]
    left: tuple[Left, ...]
    report: Report

    def diff(self) -> str:
        """All changes as a unified diff."""
        return "".join(file.diff() for file in self.files)

    def write(self) -> None:
        """Replace the files, each whole or not at all, with the permissions that it has.

        Raises:
            UnwritableFile: a file may not be written, or has changed since it was read.
        """
        rewriting.write(self.files)


def fix(
    *files: str | os.PathLike[str],
    unsafe: bool = False,
    force: bool = False,
    **options: Unpack[Options],
) -> Fixes:
    """Mend what has a remedy in descriptions of robots and in the files that they include.

    >>> fixes = fix("models/gazebo_pkg/urdf/waking_robot_new.xacro")
    >>> [(one.code, one.span.line) for one in fixes.applied]
    [('JNT020', 203), ('JNT020', 234), ('JNT020', 265)]

    Fixes that overlap are applied one after the other. A fix that adds an error, makes a
    description unreadable, or leaves its finding as it was, is dropped.

    Args:
        files: URDF, xacro or launch files, or folders, as of ``check``.
        unsafe: apply the fixes that may change what the robot does, too.
        force: edit files as well that are generated, that git ignores, or that lie outside the
            workspace of ``files``.
        options: of ``check``, which they are given to many times: lists, not iterators.

    Raises:
        UrdfkitError: as of ``check``.
    """
    every: Options = {**options, "select": (), "ignore": ()}
    given = options.get("texts") or {}

    def checked(texts: Mapping[str, bytes]) -> Report:
        now: Options = {**options, "texts": {**given, **texts}}
        return check(*files, **now)

    def watched(texts: Mapping[str, bytes], others: Iterable[str]) -> Report:
        now: Options = {**every, "texts": {**given, **texts}}
        return check(*files, *others, **now)

    resolver = Resolver(options.get("packages"), texts=given)
    is_partial = bool(options.get("select") or options.get("ignore"))
    watch = _Watch(watched, resolver, options.get("config"), is_partial)
    return _Session(checked, watch, resolver, unsafe=unsafe, force=force).run()


class _Watch:
    """Looks at what fixes may break beyond the findings that they are for.

    That is other robots of the workspace that include a file, and what the rules say that were
    not asked for.

    Args:
        check: all rules over the robots and some others.
        resolver, config: of the check.
        is_partial: True if the findings to fix are those of some rules only.
    """

    def __init__(
        self,
        check: Callable[[Mapping[str, bytes], Iterable[str]], Report],
        resolver: Resolver,
        config: Config | None,
        is_partial: bool,
    ) -> None:
        self._check = check
        self._resolver = resolver
        self._config = config or Config()
        self._is_partial = is_partial

    def harm(
        self, before: Mapping[str, bytes], after: Mapping[str, bytes], known: Iterable[str]
    ) -> str:
        """What forbids the change from some texts to others; empty if nothing does.

        Args:
            before: texts in the place of those on disk.
            after: likewise.
            known: the descriptions that were checked already, with the rules asked for.
        """
        changed = [path for path, text in after.items() if before.get(path) != text]
        others = self._others(changed, known)
        if not others and not self._is_partial:
            return ""
        return _harm(self._check(before, others), self._check(after, others))

    def _others(self, changed: Iterable[str], known: Iterable[str]) -> list[str]:
        """Robots that changed files are part of, and that were not asked for."""
        try:
            found = affected(changed, self._config, self._resolver)
        except UnreadableFile:  # a folder with too many files to look at
            return []
        asked = set(map(os.path.realpath, known))
        others = dict.fromkeys(os.path.relpath(robot.file) for robot in found.robots)
        return [file for file in others if os.path.realpath(file) not in asked]


class _Session:
    """The texts as they are after some rounds.

    Args:
        check: the robots, with some texts in the place of those on disk.
        watch: looks at everything else.
        resolver: knows workspaces.
        unsafe, force: as of ``fix``.
    """

    def __init__(
        self,
        check: Callable[[Mapping[str, bytes]], Report],
        watch: _Watch,
        resolver: Resolver,
        *,
        unsafe: bool,
        force: bool,
    ) -> None:
        self._check = check
        self._watch = watch
        self._unsafe = unsafe
        self._force = force
        self._resolver = resolver
        self._ownership = Ownership((), resolver)
        self._originals: dict[str, Rewrite] = {}
        self._texts: dict[str, bytes] = {}
        self._dropped: dict[_Key, str] = {}
        self._applied: list[Diagnostic] = []

    def run(self) -> Fixes:
        """Round after round, as long as there is something to mend."""
        report = self._check({})
        self._ownership = Ownership(report.files, self._resolver)
        for _ in range(MAX_ROUNDS):
            chosen = self._chosen(report)
            if not chosen:
                break
            report = self._round(report, chosen)
        files = [
            original._replace(after=self._texts[real])
            for real, original in self._originals.items()
            if self._texts.get(real, original.before) != original.before
        ]
        left = tuple(Left(one, self._reason(one)) for one in report.diagnostics)
        return Fixes(tuple(sorted(files)), tuple(self._applied), left, report)

    def _chosen(self, report: Report) -> list[Diagnostic]:
        """The findings to mend in one round: of fixes that overlap, the first."""
        ready = [one for one in report.diagnostics if one.fix and not self._reason(one)]
        settled = [one for one in ready if not one.code.startswith(_LAST)]
        chosen: list[Diagnostic] = []
        taken: dict[str, list[Edit]] = {}
        for diagnostic in settled or ready:
            edits = _edits(diagnostic)
            if all(_fits(edit, taken.get(_real(edit.span.source), ())) for edit in edits):
                chosen.append(diagnostic)
                for edit in edits:
                    taken.setdefault(_real(edit.span.source), []).append(edit)
        return chosen

    def _reason(self, diagnostic: Diagnostic) -> str:
        """Why the fix of a finding is not applied; empty if it may be, or there is none."""
        if diagnostic.fix is None:
            return ""
        if not (diagnostic.fix.safe or self._unsafe):
            return "unsafe"
        if key := self._dropped.get(_key(diagnostic)):
            return key
        reasons = (self._refusal(edit.span.source) for edit in diagnostic.fix.edits)
        return next(filter(None, reasons), "")

    def _refusal(self, source: Source) -> str:
        """Why a file is not edited; empty if it may be."""
        real = _real(source)
        if real not in self._originals:
            before = self._resolver.text(source.path) or on_disk(source.path)
            if before is None:
                return "there is no such file"
            self._originals[real] = Rewrite(shown(source.path), before, before)
        if source.undecodable is not None:
            return "the file has bytes that are no text"
        original = self._originals[real].before
        now = self._texts.get(real, original)
        if _encoded(source.data, source, original) != now:
            return f"its encoding, {source.encoding}, cannot be kept"
        return "" if self._force else self._ownership.refusal(source)

    def _round(self, report: Report, chosen: list[Diagnostic]) -> Report:
        """Apply as many fixes as do no harm; the report on the texts after them."""
        kept: list[Diagnostic] = []
        texts, latest = self._texts, report
        batches = [chosen]
        while batches:
            batch = batches.pop()
            trial = {**self._texts, **self._edited([*kept, *batch])}
            after = self._check(trial)
            harm = (
                _harm(report, after)
                or _useless(report, after, [*kept, *batch])
                or self._watch.harm(self._texts, trial, report.files)
            )
            if not harm:
                kept += batch
                texts, latest = trial, after
            elif len(batch) > 1:  # which one does it?
                middle = len(batch) // 2
                batches += [batch[middle:], batch[:middle]]
            else:
                self._dropped[_key(batch[0])] = harm
        self._texts = texts
        self._applied += kept
        return latest

    def _edited(self, diagnostics: Iterable[Diagnostic]) -> dict[str, bytes]:
        """The bytes of the files that some fixes edit, after them."""
        edits: dict[str, dict[tuple[int, int, str], Edit]] = {}
        for diagnostic in diagnostics:
            for edit in _edits(diagnostic):
                # Two robots may tell the same of a file that both include.
                identity = (edit.span.start, edit.span.end, edit.text)
                edits.setdefault(_real(edit.span.source), {})[identity] = edit
        texts = {}
        for real, parts in edits.items():
            source = next(iter(parts.values())).span.source
            data = apply_edits(source.data, parts.values())
            texts[real] = _encoded(data, source, self._originals[real].before) or source.data
        return texts


def _harm(before: Report, after: Report) -> str:
    """What forbids the fixes between two checks; empty if nothing does.

    Errors of rules that could not look before were there, but hidden.
    """
    if lost := {(s.path, s.code) for s in after.skipped} - {
        (s.path, s.code) for s in before.skipped
    }:
        path = min(lost)[0]
        return f"dropped: with it, {path} could not be checked any more"
    hidden = {skipped.code for skipped in before.skipped}
    for now, old in zip_longest(after.errors, before.errors, fillvalue=()):
        if added := sorted((Counter(now) - Counter(old)).keys() - hidden):
            return f"dropped: it would add {added[0]}"
    if len(after.crashed) > len(before.crashed):
        return f"dropped: with it, rule {after.crashed[-1].code} fails"
    return ""


def _useless(before: Report, after: Report, applied: list[Diagnostic]) -> str:
    """Says so if a fix left its finding as it was; it would be applied for ever."""
    expected = Counter(map(_key, before.diagnostics))
    expected.subtract(Counter(map(_key, applied)))
    now = Counter(map(_key, after.diagnostics))
    stays = any(now[key] > expected[key] for key in map(_key, applied))
    return "dropped: the finding stays" if stays else ""


def _fits(edit: Edit, others: Iterable[Edit]) -> bool:
    """True if an edit and others of the same file can be made at once; the same one is one."""
    return not any(
        overlap(edit, one) and edit[0][1:] + edit[1:] != one[0][1:] + one[1:] for one in others
    )


def _edits(diagnostic: Diagnostic) -> tuple[Edit, ...]:
    assert diagnostic.fix is not None
    return diagnostic.fix.edits


def _key(diagnostic: Diagnostic) -> _Key:
    return (diagnostic.code, _real(diagnostic.span.source), diagnostic.message)


def _real(source: Source) -> str:
    return os.path.realpath(source.path)


def _encoded(text: bytes, source: Source, original: bytes) -> bytes | None:
    """A text in the encoding of its file; None if that lacks a character, or is no encoding."""
    try:
        return encoded(text, source.encoding, original)
    except (UnicodeError, LookupError):
        return None
