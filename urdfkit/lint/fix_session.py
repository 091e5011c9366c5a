"""Rounds of a fix session: apply fixes to texts in memory, check, keep or drop them."""

from __future__ import annotations

from bisect import bisect_left, insort
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from urdfkit.core.record import Record
from urdfkit.lint import rule_index
from urdfkit.lint.fix_checker import Checker, FindingKey, finding_key, real_path
from urdfkit.lint.fix_guard import (
    UNCHECKED,
    RegressionGuard,
    Robots,
    ineffective,
    regression,
    unchecked,
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
#: For text that several robots or variants share, of which not all have the finding.
_CONFLICTING = "skipped: another robot uses this text and is correct as it is"
#: First and last byte of an edit, and its text.
_Piece = tuple[int, int, str]


class Fixes(Record):
    """The result of ``fix``; nothing is written before ``write``.

    Attributes:
        files: changed files, sorted by path.
        applied: the fixed findings, from the check of their round.
        left: findings of the last check.
        report: report of the last check.
        meshes: meshes generated for missing and broken files.
        not_generated: missing and broken files for which no mesh could be generated.
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
    """Runs the rounds of ``fix`` on texts in memory.

    Args:
        codes: codes of the rules whose findings are to be fixed.
        named: codes of the rules whose infos are to be fixed.
        unsafe, force: see ``fix``.
    """

    def __init__(
        self,
        checker: Checker,
        codes: Iterable[str],
        named: Iterable[str],
        *,
        unsafe: bool,
        force: bool,
    ) -> None:
        self._checker = checker
        self._guard = RegressionGuard(checker)
        self._codes = frozenset(codes)
        self._named = frozenset(named)
        self._unsafe = unsafe
        self._force = force
        self._reasons = self._reasons_for(())
        self._texts: dict[str, bytes] = {}
        self._dropped: dict[FindingKey, str] = {}
        self._applied: list[Diagnostic] = []

    def run(self, *, only_files: bool = False) -> Fixes:
        """Apply the fixes that cause no regression.

        Other robots that include the files are checked once, at the end. Only if that shows a
        regression, they are checked at every step, to find the fix that causes it.

        Args:
            only_files: True to omit the final check if something was fixed, see ``changes``.
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
        left = tuple(UnappliedFix(finding, self._reason(finding)) for finding in report.diagnostics)
        return Fixes(tuple(sorted(changed)), tuple(self._applied), left, report)

    def _fix(self, *, is_careful: bool) -> Report:
        """Run rounds until there is nothing to fix; the last report."""
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
        """The findings to fix in one round; only the first of those with overlapping fixes."""
        ready = [
            finding
            for finding in report.diagnostics
            if finding.fix and finding.code in self._codes and not self._reason(finding)
        ]
        independent = [finding for finding in ready if not _waits(rule_index.get(finding.code))]
        chosen: list[Diagnostic] = []
        chosen_pieces: dict[str, list[_Piece]] = {}
        for finding in independent or ready:
            edits = [(real_path(edit.span.source), _piece(edit)) for edit in _edits(finding)]
            if all(_fits(piece, chosen_pieces.get(path, [])) for path, piece in edits):
                chosen.append(finding)
                for path, piece in edits:
                    insort(chosen_pieces.setdefault(path, []), piece)
        return chosen

    def _reason(self, diagnostic: Diagnostic) -> str:
        """Why the fix of a finding is not applied; empty if it may be, or there is none."""
        reason = self._reasons.of(diagnostic, self._texts)
        return reason or self._dropped.get(finding_key(diagnostic), "")

    def _round(self, report: Report, chosen: list[Diagnostic], *, is_careful: bool) -> Report:
        """Apply the fixes that cause no regression; the report on the resulting texts."""
        conflicting = self._guard.conflicts(chosen, self._texts, report)
        self._dropped.update(dict.fromkeys(conflicting, _CONFLICTING))
        chosen = [finding for finding in chosen if finding_key(finding) not in conflicting]
        applied: list[Diagnostic] = []
        texts, latest = self._texts, report
        batches = [chosen] if chosen else []
        while batches:
            batch = batches.pop()
            trial = {**self._texts, **self._edited([*applied, *batch])}
            after = self._checker.guard(trial)
            is_broken = all(finding.severity is Severity.ERROR for finding in batch)
            reason = regression(
                latest, after, *map(self._robots, (texts, trial)), may_reveal=is_broken
            ) or ineffective(report, after, [*applied, *batch])
            if is_careful:
                reason = reason or self._guard.regression(
                    texts, trial, report.files, may_reveal=is_broken
                )
            lost = unchecked(latest, after, may_reveal=is_broken)
            if not reason:
                applied += batch
                texts, latest = trial, after
            elif len(batch) == 1:
                self._dropped[finding_key(batch[0])] = reason
            elif harmful := self._harmful(batch, applied, texts, lost):
                self._dropped |= harmful
                batches.append([one for one in batch if finding_key(one) not in harmful])
            else:
                batches += _halves(batch)
        self._texts = texts
        self._applied += applied
        return latest

    def _harmful(
        self,
        batch: list[Diagnostic],
        applied: list[Diagnostic],
        texts: Mapping[str, bytes],
        robots: list[str],
    ) -> dict[FindingKey, str]:
        """The fixes of a batch with which some robots cannot be checked any more, and the reasons.

        Only these robots are checked, which of many takes a fraction of the time.

        Args:
            applied: fixes that ``texts`` contains.
        """
        before = self._checker.guard(texts, robots) if robots else None
        kept: list[Diagnostic] = []
        harmful: dict[FindingKey, str] = {}
        parts = [batch] if before else []
        while before and parts:
            part = parts.pop()
            trial = {**self._texts, **self._edited([*applied, *kept, *part])}
            after = self._checker.guard(trial, robots)
            is_broken = all(finding.severity is Severity.ERROR for finding in part)
            if not (lost := unchecked(before, after, may_reveal=is_broken)):
                kept += part
            elif len(part) == 1:
                harmful[finding_key(part[0])] = UNCHECKED.format(lost[0])
            else:
                parts += _halves(part)
        return harmful

    def _robots(self, texts: Mapping[str, bytes]) -> Robots:
        return lambda: self._checker.robots(texts)

    def _edited(self, diagnostics: Iterable[Diagnostic]) -> dict[str, bytes]:
        """The contents of the files that fixes edit, after the edits, by real path."""
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


def _halves(batch: list[Diagnostic]) -> list[list[Diagnostic]]:
    """Both halves of a batch, the first one last, which is tried first."""
    middle = len(batch) // 2
    return [batch[middle:], batch[:middle]]


def _waits(rule: Rule) -> bool:
    """True for a rule whose fixes depend on the fixes of other rules.

    An inertia tensor is computed from the shapes of its link, whose poses and scales other fixes
    change; a missing link may be one whose name is in a misspelt attribute.
    """
    return rule.computes_fix or rule.reports_missing


def _fits(piece: _Piece, others: list[_Piece]) -> bool:
    """True if an edit overlaps none of others, which are sorted, or equals one of them."""
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
