"""The results of all descriptions of a check as one Report."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from urdfkit.core import disk
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.lint.finding_store import FindingStore
from urdfkit.lint.plan import Job, Plan
from urdfkit.lint.report import Launched, Report, Superseded
from urdfkit.lint.rule_index import NOT_CHECKED
from urdfkit.lint.runner import FileResult
from urdfkit.text.diagnostic import Diagnostic, Edit, Severity
from urdfkit.text.source import shown

if TYPE_CHECKING:
    from urdfkit.ros.targets import Targets

#: A description, and what the rules say about it.
Checked = tuple[Job, FileResult]


def merged_report(
    plan: Plan, checked: Iterable[Checked], unchecked: Iterable[Diagnostic], *, spills: bool = False
) -> Report:
    """The report on all descriptions of a plan.

    Args:
        checked: the descriptions with their results, in the order of the plan.
        spills: of very many robots, keep the findings on disk, and in the report nothing that only
            fixes need: no errors and no proposals.
    """
    merger = _Merger(plan, spills=spills)
    # That a robot is not checked as a launch file starts it is nothing to report if it is checked
    # otherwise: what a launch file gives it is not always known without running it. Nor is it that
    # one of a directory lacks arguments by itself, which a launch file there gives it.
    skipped: list[Checked] = []
    for job, result in checked:
        is_unchecked = job.found and not all(map(_is_checked, result.diagnostics))
        if (job.frame or is_unchecked) and _is_skipped(result):
            skipped.append((job, result))
        else:
            merger.add(job, result)
    for job, result in skipped:
        kept, reasons = result.diagnostics, result.skipped
        if disk.real(job.path) in merger.read:
            kept, reasons = () if job.frame else tuple(filter(_is_checked, kept)), ()
        merger.add(job, result._replace(diagnostics=kept, skipped=reasons))
    merger.findings.add("", "", unchecked)
    return merger.report()


def _is_skipped(result: FileResult) -> bool:
    """True of a description that was skipped as a whole."""
    return any(not skip.code for skip in result.skipped)


def _is_checked(one: Diagnostic) -> bool:
    return one.code != NOT_CHECKED


class _Merger:
    """Gathers the results of descriptions, and keeps no more of them than the report needs."""

    def __init__(self, plan: Plan, *, spills: bool) -> None:
        self.findings = FindingStore(spills=spills)  # all of them
        self.read: set[str] = set()  # the real paths of the descriptions that were not skipped
        self._plan = plan
        self._spills = spills
        self._skipped = list(plan.skipped)
        self._crashed = list(plan.crashed)
        self._ran: set[str] = set()
        self._targets: list[tuple[str, Targets]] = []
        self._same_targets: dict[Targets, Targets] = {}  # most robots have those of others
        self._suppressed = 0
        self._errors: list[tuple[Diagnostic, ...]] = []
        self._proposals: list[tuple[Edit, ...]] = []
        self._launched: list[Launched] = []
        self._unknown: dict[str, Mapping[str, str]] = {}  # as of one result
        self._silenced: list[Superseded] = []

    def add(self, job: Job, result: FileResult) -> None:
        self.findings.add(job.path, job.name, result.diagnostics)
        if not job.codes and not _is_skipped(result):
            self.read.add(disk.real(job.path))
        self._skipped += result.skipped
        self._crashed += result.crashed
        self._ran |= result.ran
        if result.targets is not None:
            targets = self._same_targets.setdefault(result.targets, result.targets)
            self._targets.append((job.path, targets))
        self._suppressed += result.suppressed
        self._launched += job.launched
        for entry, new in result.unknown_arguments.items():
            names = self._unknown.setdefault(entry, new)
            self._unknown[entry] = {name: names[name] for name in names if name in new}
        if result.superseded.findings:
            self._silenced.append(result.superseded)
        if not self._spills:
            self._add_for_fixes(result)

    def _add_for_fixes(self, result: FileResult) -> None:
        every = (*result.diagnostics, *result.superseded.findings)
        self._errors.append(tuple(one for one in every if one.severity is Severity.ERROR))
        fixes = [one.fix for one in result.diagnostics if one.fix]
        self._proposals.append(tuple(edit for fix in fixes for edit in fix.edits))

    def report(self) -> Report:
        return Report(
            tuple(dict.fromkeys(job.path for job in self._plan.jobs)),
            self.findings.diagnostics(),
            tuple(self._skipped),
            tuple(self._crashed),
            tuple(sorted(self._ran)),
            tuple(self._targets),
            self._suppressed,
            errors=tuple(self._errors),
            proposals=tuple(self._proposals),
            launched=tuple(self._launched),
            unknown_arguments=tuple(self._unknown.pop("", {}).items()),
            unknown_in_config=tuple(
                (entry, *one) for entry, names in self._unknown.items() for one in names.items()
            ),
            superseded=tuple(self._silenced),
        )


def in_reading_order(diagnostics: Iterable[Diagnostic]) -> tuple[Diagnostic, ...]:
    found = tuple(diagnostics)
    names = {path: shown(path) for path in {one.span.source.path for one in found}}

    def order(one: Diagnostic) -> tuple[str, int, str, str]:
        return (names[one.span.source.path], one.span.start, one.code, one.message)

    return tuple(sorted(found, key=order))
