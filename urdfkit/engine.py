"""check(): rules over a Subject make a Report."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from urdfkit import rules
from urdfkit.diagnostic import (
    Call,
    Crashed,
    Diagnostic,
    Report,
    Skipped,
)
from urdfkit.document import Attribute, Element, Step
from urdfkit.resolve import Resolver
from urdfkit.rules import Finding, Rule, Written
from urdfkit.source import Source, Span
from urdfkit.subject import Subject, Unavailable

if TYPE_CHECKING:
    from urdfkit.targets import Targets

#: Findings of one rule in one file; more help nobody.
MAX_FINDINGS = 1000


def check(
    *files: str | os.PathLike[str] | Source,
    arguments: Mapping[str, str] | None = None,
    packages: Mapping[str, str] | None = None,
    select: Iterable[str] = (),
    ignore: Iterable[str] = (),
    targets: Iterable[str] = (),
    trust: bool = False,
) -> Report:
    """Check descriptions of robots.

    Args:
        files: URDF or xacro files, or Sources.
        arguments: xacro arguments, as ``name:=value`` gives them on the command line.
        packages: folders of ROS packages by name; they win over every search.
        select: codes, beginnings of codes or names; only these rules run. All if empty.
        ignore: codes, beginnings of codes or names of rules that do not run.
        targets: names of consumers to check for; inferred from each model if empty.
        trust: let expressions of the model run unfenced and read any file.

    Raises:
        UnreadableFile: a file is missing or may not be read.
        UnknownRule: a word of ``select`` or ``ignore`` means no rule.
        UnknownTarget: a name is no target.
    """
    chosen = choose(select, ignore)
    wanted = _given(targets)
    resolver = Resolver(packages or {})
    collector = _Collector()
    names: list[str] = []
    for file in files:
        source = file if isinstance(file, Source) else Source.read(file)
        names.append(source.path)
        subject = Subject(source, resolver, arguments, trust=trust, targets=wanted)
        collector.run(subject, chosen)
    return collector.report(tuple(names))


def _given(names: Iterable[str]) -> Targets | None:
    """The targets that were asked for; None if none were."""
    names = tuple(names)
    if not names:
        return None
    from urdfkit.targets import parse

    return parse(names)


def choose(select: Iterable[str], ignore: Iterable[str]) -> list[str]:
    """The codes that one of ``select`` means and none of ``ignore``.

    Raises:
        UnknownRule: one of the words means no rule. To pass over a slip would check with
            other rules than were asked for, and say nothing.
    """
    selected = {code for word in select for code in rules.matching(word)}
    ignored = {code for word in ignore for code in rules.matching(word)}
    return [
        code for code in rules.codes() if (not selected or code in selected) and code not in ignored
    ]


def applicable(subject: Subject, chosen: Iterable[str]) -> list[Rule]:
    """The rules that may have something to say; the others need not even be imported."""
    reading = subject.reading
    told = {problem.code for problem in reading.problems}
    silent: set[str] = set()
    if reading.xacro is None:
        silent.add("XAC")
        told.add("XAC003")  # the one among them that is about plain files
    if reading.document is None:
        silent |= {"XAC", "URD", "REF", "NAM", "TRE", "JNT", "INE", "GEO", "MSH"}
    else:
        told.update(subject.deviations)
        model = subject.model
        if not model.joints:
            silent.add("JNT")
        if not any(shape.filename for shape in model.shapes):
            silent.add("MSH")
    return [
        rules.get(code)
        for code in chosen
        if code in told
        or not (
            code[:3] in silent or code in rules.TOLD_BY_READING or code in rules.TOLD_BY_GRAMMAR
        )
    ]


class _Collector:
    """Gathers the findings of several subjects into one Report."""

    def __init__(self) -> None:
        self.diagnostics: list[Diagnostic] = []
        self.skipped: list[Skipped] = []
        self.crashed: list[Crashed] = []
        self.ran: set[str] = set()
        self.targets: list[tuple[str, Targets]] = []

    def run(self, subject: Subject, chosen: Iterable[str]) -> None:
        path = subject.source.path
        for rule in applicable(subject, chosen):
            findings: list[Finding] = []
            try:
                for finding in rule.check(subject):
                    findings.append(finding)
                    if len(findings) >= MAX_FINDINGS:
                        break
                self.ran.add(rule.code)
            except Unavailable as reason:
                self.skipped.append(Skipped(rule.code, path, str(reason)))
            except Exception as error:  # a bug in a rule must not hide the other rules
                self.crashed.append(_crash(rule, path, error))
            self.diagnostics += diagnose(rule, findings, _targets(rule, findings, subject))
        if "targets" in vars(subject):
            self.targets.append((path, subject.targets))

    def report(self, files: tuple[str, ...]) -> Report:
        once: dict[tuple[object, ...], Diagnostic] = {}
        for diagnostic in self.diagnostics:
            # Two robots of one run may include the same file; its defect is told once.
            key = (diagnostic.code, diagnostic.span.source.path, *diagnostic.span[1:])
            once.setdefault((*key, diagnostic.message), diagnostic)
        return Report(
            files,
            tuple(sorted(once.values(), key=_reading_order)),
            tuple(self.skipped),
            tuple(self.crashed),
            tuple(sorted(self.ran)),
            tuple(self.targets),
        )


def _crash(rule: Rule, path: str, error: Exception) -> Crashed:
    from traceback import format_exc  # 9 ms

    return Crashed(rule.code, path, f"{type(error).__name__}: {error}", format_exc())


def _reading_order(diagnostic: Diagnostic) -> tuple[str, int, str, str]:
    span = diagnostic.span
    return (span.source.path, span.start, diagnostic.code, diagnostic.message)


def _targets(rule: Rule, findings: list[Finding], subject: Subject) -> tuple[str, ...]:
    """The targets that a rule's findings are weighed for; inferred only where it matters."""
    return subject.targets.names if findings and rule.by_target else ()


def diagnose(
    rule: Rule, findings: Iterable[Finding], targets: tuple[str, ...] = ()
) -> list[Diagnostic]:
    """Stamp findings with their rule; what one macro body caused N times becomes one."""
    groups: dict[tuple[object, ...], list[Finding]] = {}
    for number, finding in enumerate(findings):
        span, via = place(finding)
        key: tuple[object, ...] = (span.source.path, span.start, span.end)
        # Only different calls of one macro are one cause; a plain place can have two defects.
        groups.setdefault(key if via else (*key, number), []).append(finding)
    return [_fold(rule, group, targets) for group in groups.values()]


def _fold(rule: Rule, group: list[Finding], targets: tuple[str, ...]) -> Diagnostic:
    severity, suffering = rule.weigh(targets)
    group.sort(key=lambda finding: -finding.weight)
    worst = group[0]
    calls = tuple(Call(f.message, place(f)[1], _path(f)) for f in group)
    return Diagnostic(
        rule.code,
        rule.name,
        severity,
        worst.confidence,
        worst.message,
        place(worst)[0],
        calls,
        worst.related,
        worst.help or rule.help,
        worst.fix,
        suffering,
    )


def place(finding: Finding) -> tuple[Span, tuple[Step, ...]]:
    """Where a finding is, and the calls that led there."""
    at = finding.at
    if isinstance(at, Written):
        return at.span, at.frame.steps() if at.frame else ()
    return at.span, at.via


def _path(finding: Finding) -> str:
    at = finding.at
    if isinstance(at, Written):
        return ""
    return (at if isinstance(at, (Element, Attribute)) else at.at).path
