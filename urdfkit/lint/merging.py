"""Merges the results of all descriptions of a check into one Report."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping

from urdfkit.core import disk
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.lint.finding_store import FindingStore
from urdfkit.lint.plan import Job, Plan
from urdfkit.lint.report import Launched, Report, Skipped, Superseded
from urdfkit.lint.rule_index import NOT_CHECKED
from urdfkit.lint.runner import FileResult
from urdfkit.text.diagnostic import Diagnostic, Edit, Severity
from urdfkit.text.source import shown

if TYPE_CHECKING:
    from urdfkit.ros.targets import Targets

#: A description and its result.
Checked = tuple[Job, FileResult]


def merged_report(
    plan: Plan, checked: Iterable[Checked], unchecked: Iterable[Diagnostic], *, spills: bool = False
) -> Report:
    """The report on all descriptions of a plan.

    Args:
        checked: the descriptions with their results, in the order of the plan.
        spills: store the findings of very many robots on disk, and omit ``errors`` and
            ``proposals``, which only fixes need, from the report.
    """
    merger = _Merger(plan, spills=spills)
    # A skipped description is not reported if it was also checked in another way. The arguments of
    # a launch file may be unknown without running it, and a robot found in a directory may require
    # arguments that a launch file there sets.
    skipped: list[Checked] = []
    for job, result in checked:
        is_unchecked = job.may_fail and not all(map(_is_checked, result.diagnostics))
        if (job.frame or is_unchecked) and _is_skipped(result):
            skipped.append((job, result))
        else:
            merger.add(job, result)
    for job, result in skipped:
        if disk.real(job.path) in merger.read:
            diagnostics = () if job.frame else tuple(filter(_is_checked, result.diagnostics))
            merger.add(job, result._replace(diagnostics=diagnostics, skipped=()))
        else:
            merger.add(job, result)
    merger.findings.add("", "", unchecked)
    return merger.report()


def _is_skipped(result: FileResult) -> bool:
    """True if the whole description was skipped."""
    return any(not skip.code for skip in result.skipped)


def _is_checked(diagnostic: Diagnostic) -> bool:
    return diagnostic.code != NOT_CHECKED


class _Merger:
    """Collects the parts of the results that the report needs."""

    def __init__(self, plan: Plan, *, spills: bool) -> None:
        self.findings = FindingStore(spills=spills)
        self.read: set[str] = set()  # real paths of the descriptions that were not skipped
        self._plan = plan
        self._spills = spills
        self._skipped = list(plan.skipped)
        self._crashed = list(plan.crashed)
        self._ran: set[str] = set()
        self._targets: list[tuple[str, Targets]] = []
        self._same_targets: dict[Targets, Targets] = {}  # most robots share equal targets
        self._suppressed = 0
        self._errors: list[tuple[Diagnostic, ...]] = []
        self._proposals: list[tuple[Edit, ...]] = []
        self._launched: list[Launched] = []
        self._unknown: dict[str, Mapping[str, str]] = {}  # like FileResult.unknown_arguments
        self._superseded: list[Superseded] = []
        self._srdfs: set[str] = set()  # real paths of the SRDFs of the robots

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
            self._superseded.append(result.superseded)
        if result.srdf:
            self._srdfs.add(disk.real(result.srdf))
        if not self._spills:
            self._add_for_fixes(result)

    def _add_for_fixes(self, result: FileResult) -> None:
        findings = (*result.diagnostics, *result.superseded.findings)
        errors = (finding for finding in findings if finding.severity is Severity.ERROR)
        self._errors.append(tuple(errors))
        fixes = [finding.fix for finding in result.diagnostics if finding.fix]
        self._proposals.append(tuple(edit for fix in fixes for edit in fix.edits))

    def report(self) -> Report:
        return Report(
            tuple(dict.fromkeys(job.path for job in self._plan.jobs)),
            self.findings.diagnostics(),
            (*self._skipped, *unread_srdfs(self._plan.srdfs, self._srdfs)),
            tuple(self._crashed),
            tuple(sorted(self._ran)),
            tuple(self._targets),
            self._suppressed,
            errors=tuple(self._errors),
            proposals=tuple(self._proposals),
            launched=tuple(self._launched),
            unknown_arguments=tuple(self._unknown.pop("", {}).items()),
            unknown_in_config=tuple(
                (entry, *item) for entry, names in self._unknown.items() for item in names.items()
            ),
            superseded=tuple(self._superseded),
        )


def unread_srdfs(found: Iterable[str], read: Collection[str]) -> Iterator[Skipped]:
    """The SRDFs of a directory that were not compared with any robot.

    Args:
        read: real paths of those that were.
    """
    for path in found:
        if disk.real(path) not in read:
            yield Skipped("", path, "not compared with any robot that is checked")


def in_reading_order(diagnostics: Iterable[Diagnostic]) -> tuple[Diagnostic, ...]:
    findings = tuple(diagnostics)
    names = {path: shown(path) for path in {finding.span.source.path for finding in findings}}

    def order(finding: Diagnostic) -> tuple[str, int, str, str]:
        name = names[finding.span.source.path]
        return (name, finding.span.start, finding.code, finding.message)

    return tuple(sorted(findings, key=order))
