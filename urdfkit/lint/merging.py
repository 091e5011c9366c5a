"""The results of all descriptions of a check as one Report."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator

from urdfkit.core import disk
from urdfkit.lint.plan import Job, Plan
from urdfkit.lint.report import Report
from urdfkit.lint.runner import FileResult
from urdfkit.text.diagnostic import Diagnostic, Severity
from urdfkit.text.source import shown

#: A description, and what the rules say about it.
Checked = tuple[Job, FileResult]


def merged_report(plan: Plan, checked: list[Checked], unchecked: Iterable[Diagnostic]) -> Report:
    """The report on all descriptions of a plan.

    Args:
        plan: of the check.
        checked: the descriptions with their results, in the order of the plan.
        unchecked: findings about what nothing was checked of.
    """
    checked = _launched_once(checked)
    results = [result for _, result in checked]
    files = Counter(job.path for job in plan.jobs)
    return Report(
        tuple(files),
        in_reading_order((*_distinct(checked), *unchecked)),
        (*plan.skipped, *(skip for result in results for skip in result.skipped)),
        (*plan.crashed, *(crash for result in results for crash in result.crashed)),
        tuple(sorted({code for result in results for code in result.ran})),
        tuple((job.path, result.targets) for job, result in checked if result.targets is not None),
        sum(result.suppressed for result in results),
        errors=tuple(
            tuple(
                one
                for one in (*result.diagnostics, *result.silenced.findings)
                if one.severity is Severity.ERROR
            )
            for result in results
        ),
        proposals=tuple(
            tuple(edit for d in result.diagnostics if d.fix for edit in d.fix.edits)
            for result in results
        ),
        launched=tuple(one for job, _ in checked for one in job.launched),
        unknown_arguments=tuple(
            one
            for one in (results[0].unknown_arguments.items() if results else ())
            if all(one[0] in result.unknown_arguments for result in results)
        ),
        silenced=tuple(result.silenced for result in results if result.silenced.findings),
    )


def _launched_once(checked: list[Checked]) -> list[Checked]:
    """The results, without that a robot is not checked as a launch file starts it.

    What a launch file gives it is not always known without running it. It is enough that the
    robot is checked otherwise.
    """
    read = {
        disk.real(job.path) for job, result in checked if all(skip.code for skip in result.skipped)
    }
    return [
        (job, result._replace(diagnostics=(), skipped=()))
        if job.frame
        and any(not skip.code for skip in result.skipped)
        and disk.real(job.path) in read
        else (job, result)
        for job, result in checked
    ]


def _distinct(checked: list[Checked]) -> Iterator[Diagnostic]:
    """The findings, each once, with the variants of the robot that it is found in.

    Two robots of one run may include the same file, each in its own words; its defect is reported
    once.
    """
    once: dict[tuple[object, ...], Diagnostic] = {}
    found_in: dict[tuple[object, ...], list[Job]] = {}
    files_of: dict[str, str] = {}
    for job, result in checked:
        for diagnostic in result.diagnostics:
            path = diagnostic.span.source.path
            file = files_of.get(path) or files_of.setdefault(path, disk.real(path))
            key = (diagnostic.code, file, *diagnostic.span[1:], diagnostic.message)
            once.setdefault(key, diagnostic)
            found_in.setdefault(key, []).append(job)
    variants: dict[str, set[str]] = {}
    for job, _ in checked:
        variants.setdefault(job.path, set()).add(job.name)
    for jobs, diagnostic in zip(found_in.values(), once.values(), strict=True):
        names = _partial(jobs, variants)
        yield diagnostic._replace(variants=names) if names else diagnostic


def _partial(found_in: list[Job], variants: dict[str, set[str]]) -> tuple[str, ...]:
    """The names of variants with a finding; none if it is in all those of some robot."""
    names: dict[str, dict[str, None]] = {}
    for job in found_in:
        names.setdefault(job.path, {})[job.name] = None
    if any("" in own or len(own) == len(variants[path] - {""}) for path, own in names.items()):
        return ()
    return tuple(dict.fromkeys(name for own in names.values() for name in own))


def in_reading_order(diagnostics: Iterable[Diagnostic]) -> tuple[Diagnostic, ...]:
    """By file, place, code and message."""
    found = tuple(diagnostics)
    names = {path: shown(path) for path in {one.span.source.path for one in found}}

    def order(one: Diagnostic) -> tuple[str, int, str, str]:
        return (names[one.span.source.path], one.span.start, one.code, one.message)

    return tuple(sorted(found, key=order))
