"""The rounds of a fix: fixes are applied to texts in memory, checked, and kept or dropped."""

from __future__ import annotations

from bisect import bisect_left, insort
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from urdfkit.core.record import Record
from urdfkit.lint import rule_index
from urdfkit.lint.fix_guard import (
    Checker,
    FindingKey,
    RegressionGuard,
    Robots,
    ineffective,
    key_of,
    real_path,
    regression,
)
from urdfkit.lint.fix_reasons import FixReasons, UnappliedFix, encoded_as
from urdfkit.lint.report import Report
from urdfkit.lint.rules import Rule
from urdfkit.text.diagnostic import Diagnostic, Edit, Severity
from urdfkit.text.editing import rewriting
from urdfkit.text.editing.apply import apply_edits
from urdfkit.text.editing.rewriting import Rewrite

if TYPE_CHECKING:
    from urdfkit.robot.assets.placeholder_meshes import GeneratedMesh, NotGenerated


MAX_ROUNDS = 10
#: Robots, or variants of one, share the text and not the finding.
_CONFLICTING = "skipped: another robot uses this text and is correct as it is"
#: First and last byte of an edit, and its text.
_Piece = tuple[int, int, str]


class Fixes(Record):
    """The outcome of fixing some descriptions; nothing is written before ``write``.

    Attributes:
        files: that change, sorted by path.
        applied: the findings that were fixed, as the check of their round found them.
        left: what the last check still found.
        report: of the last check.
        meshes: that were made for missing and broken files.
        not_generated: missing and broken files for which none could be generated.
    """

    files: tuple[Rewrite, ...]
    applied: tuple[Diagnostic, ...]
    left: tuple[UnappliedFix, ...]
    report: Report
    meshes: tuple[GeneratedMesh, ...] = ()
    not_generated: tuple[NotGenerated, ...] = ()

    def diff(self) -> str:
        """All changes as a unified diff."""
        return "".join(file.diff() for file in self.files)

    def write(self) -> None:
        """Replace the files, each whole or not at all, and write the meshes.

        Raises:
            UnwritableFile: a file may not be written, or has changed since it was read.
        """
        rewriting.write(self.files)
        for mesh in self.meshes:
            mesh.write()


class FixSession:
    """The texts as they are after some rounds.

    Args:
        asked: codes of the rules whose findings are to be fixed.
        unsafe, force: as of ``fix``.
    """

    def __init__(
        self,
        checker: Checker,
        asked: Iterable[str],
        named: Iterable[str],
        *,
        unsafe: bool,
        force: bool,
    ) -> None:
        self._checker = checker
        self._guard = RegressionGuard(checker)
        self._asked = frozenset(asked)
        self._named = frozenset(named)
        self._unsafe = unsafe
        self._force = force
        self._reasons = self._reasons_for(())
        self._texts: dict[str, bytes] = {}
        self._dropped: dict[FindingKey, str] = {}
        self._applied: list[Diagnostic] = []

    def run(self, *, only_files: bool = False) -> Fixes:
        """Apply what can be applied.

        Other robots that include the files are checked once, at the end; only if that shows a
        regression, they are checked with every step, to find the fix that causes it.

        Args:
            only_files: as ``changes`` needs it.
        """
        try:
            return self._run(only_files=only_files)
        finally:
            self._checker.workers.end()

    def _run(self, *, only_files: bool) -> Fixes:
        report = self._fix(is_careful=False)
        if self._guard.regression({}, self._texts, report.files, may_reveal=False):
            self._texts, self._dropped, self._applied = {}, {}, []
            report = self._fix(is_careful=True)
        if not (only_files and self._applied):
            report = self._checker.report(self._texts)
        changed = [
            original._replace(after=self._texts[real])
            for real, original in self._reasons.originals.items()
            if self._texts.get(real, original.before) != original.before
        ]
        left = tuple(UnappliedFix(one, self._reason(one)) for one in report.diagnostics)
        return Fixes(tuple(sorted(changed)), tuple(self._applied), left, report)

    def _fix(self, *, is_careful: bool) -> Report:
        """Round after round, as long as there is something to fix; the last report."""
        report = self._checker.guard({})
        self._reasons = self._reasons_for(report.files)
        for _ in range(MAX_ROUNDS):
            chosen = self._chosen(report)
            if not chosen:
                break
            report = self._round(report, chosen, is_careful=is_careful)
        return report

    def _reasons_for(self, files: Iterable[str]) -> FixReasons:
        return FixReasons(
            files, self._checker.resolver, self._named, unsafe=self._unsafe, force=self._force
        )

    def _chosen(self, report: Report) -> list[Diagnostic]:
        """The findings to fix in one round: of fixes that overlap, the first."""
        ready = [
            one
            for one in report.diagnostics
            if one.fix and one.code in self._asked and not self._reason(one)
        ]
        settled = [one for one in ready if not _waits(rule_index.get(one.code))]
        chosen: list[Diagnostic] = []
        taken: dict[str, list[_Piece]] = {}
        for diagnostic in settled or ready:
            edits = [(real_path(e.span.source), _piece(e)) for e in _edits(diagnostic)]
            if all(_fits(piece, taken.get(path, [])) for path, piece in edits):
                chosen.append(diagnostic)
                for path, piece in edits:
                    insort(taken.setdefault(path, []), piece)
        return chosen

    def _reason(self, diagnostic: Diagnostic) -> str:
        """Why the fix of a finding is not applied; empty if it may be, or there is none."""
        return self._reasons.of(diagnostic, self._texts) or self._dropped.get(
            key_of(diagnostic), ""
        )

    def _round(self, report: Report, chosen: list[Diagnostic], *, is_careful: bool) -> Report:
        """Apply all fixes without a regression; the report on the texts after them."""
        conflicting = self._guard.conflicts(chosen, self._texts, report)
        self._dropped.update(dict.fromkeys(conflicting, _CONFLICTING))
        chosen = [one for one in chosen if key_of(one) not in conflicting]
        kept: list[Diagnostic] = []
        texts, latest = self._texts, report
        batches = [chosen] if chosen else []
        while batches:
            batch = batches.pop()
            trial = {**self._texts, **self._edited([*kept, *batch])}
            after = self._checker.guard(trial)
            is_broken = all(one.severity is Severity.ERROR for one in batch)
            reason = regression(
                latest, after, *map(self._robots, (texts, trial)), may_reveal=is_broken
            ) or ineffective(report, after, [*kept, *batch])
            if is_careful:
                reason = reason or self._guard.regression(
                    texts, trial, report.files, may_reveal=is_broken
                )
            if not reason:
                kept += batch
                texts, latest = trial, after
            elif len(batch) > 1:  # which one does it?
                middle = len(batch) // 2
                batches += [batch[middle:], batch[:middle]]
            else:
                self._dropped[key_of(batch[0])] = reason
        self._texts = texts
        self._applied += kept
        return latest

    def _robots(self, texts: Mapping[str, bytes]) -> Robots:
        return lambda: self._checker.robots(texts)

    def _edited(self, diagnostics: Iterable[Diagnostic]) -> dict[str, bytes]:
        """The bytes of the files that some fixes edit, after them."""
        edits: dict[str, dict[_Piece, Edit]] = {}
        for diagnostic in diagnostics:
            for edit in _edits(diagnostic):
                # Two robots may have the same finding in a file that both include.
                edits.setdefault(real_path(edit.span.source), {})[_piece(edit)] = edit
        texts = {}
        for real, parts in edits.items():
            source = next(iter(parts.values())).span.source
            data = apply_edits(source.data, parts.values())
            original = self._reasons.originals[real].before
            texts[real] = encoded_as(source, data, original) or source.data
        return texts


def _waits(rule: Rule) -> bool:
    """True of a rule whose fixes follow from what the others write.

    A tensor comes from the shapes of its link, which are turned, moved and scaled; a link that is
    missing may be one whose name stands in a misspelt attribute.
    """
    return rule.computes_fix or rule.reports_missing


def _fits(piece: _Piece, others: list[_Piece]) -> bool:
    """True if an edit can be made together with others, which are sorted; the same one is one."""
    start, end, _ = piece
    after = bisect_left(others, (start, -1, ""))
    for other in others[max(0, after - 1) : after + 2]:
        overlaps = start == other[0] or (start < other[1] and other[0] < end)
        if overlaps and piece != other:
            return False
    return True


def _piece(edit: Edit) -> _Piece:
    return (edit.span.start, edit.span.end, edit.text)


def _edits(diagnostic: Diagnostic) -> tuple[Edit, ...]:
    assert diagnostic.fix is not None
    return diagnostic.fix.edits
