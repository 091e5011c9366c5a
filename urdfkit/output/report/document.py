"""The document of a report: plain values that JSON can hold.

Lengths in m, angles in rad, masses in kg, moments in kg·m². A part that cannot be had, for want
of a library or of a robot, is None, and ``missing`` says why.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

from urdfkit import __version__
from urdfkit.core import disk
from urdfkit.core.progress import Progress
from urdfkit.core.record import Record
from urdfkit.core.strict_json import finite
from urdfkit.errors import Unavailable
from urdfkit.lint import rule_index
from urdfkit.lint.check_job import given_targets
from urdfkit.lint.context import Context
from urdfkit.lint.engine import check_read
from urdfkit.lint.grouping import grouped
from urdfkit.lint.loading import context_of
from urdfkit.lint.options import Options
from urdfkit.lint.report import Report
from urdfkit.output.formats import json as as_json
from urdfkit.output.report import physics, tables
from urdfkit.output.report.findings import findings
from urdfkit.robot.element_lookup import ElementLookup
from urdfkit.ros.gazebo.rejection import rejections
from urdfkit.ros.targets import facts_of
from urdfkit.text.diagnostic import Diagnostic, Severity
from urdfkit.text.source import Source, shown, without_directory
from urdfkit.workspace.resolve import Resolver

#: Of the document; a change that could break a reader counts it up.
VERSION = 1

ReportDocument = dict[str, Any]

#: The parts that are computed from the robot, each by a function of its Context.
_PARTS: dict[str, Callable[[Context], object]] = {
    "robot": tables.robot,
    "links": tables.links,
    "joints": tables.joints,
    "gazebo": tables.gazebo,
    "meshes": tables.meshes,
}
#: The parts that take a while.
LONG = ("statics", "standing", "collisions")


class ReportInput(Record):
    """A robot and its findings, as a report needs them."""

    document: ReportDocument  # for all outputs
    context: Context  # the robot
    diagnostics: tuple[Diagnostic, ...]  # what ``urdfkit check`` finds


def describe(
    file: str | os.PathLike[str] | Source,
    options: Options = Options(),
    *,
    quick: bool = False,
    progress: Progress | None = None,
) -> ReportInput:
    """Everything that a report says of a robot.

    Of a robot that cannot be read, only the findings are reported.

    Args:
        file: a URDF or xacro file, or a launch file that describes one robot.
        quick: leave out what takes a while, which is all of `LONG`.
        progress: called with the number of steps done and of all, where it takes a while.

    Raises:
        UnreadableFile: the file is missing or may not be read.
        UnreadableRobot: a launch file describes none, or several.
        ConfigError: the configuration has several variants of the file, or none of this name.
    """
    options = options.with_config()
    source, resolver = Source.of(file), Resolver(options.packages)
    values = options.config.entry(source.path, options.arguments, options.variant).arguments
    targets = given_targets(options)
    context = context_of(
        source, resolver, values, trust=options.trust, cache=options.cache, targets=targets
    )
    report = check_read(options.for_one(context.arguments).resolved(), context)
    reported = ReportInput(_document(context, report), context, tuple(report.diagnostics))
    return reported if quick else completed(reported, progress)


def completed(reported: ReportInput, progress: Progress | None = None) -> ReportInput:
    """The same with what takes a while.

    Args:
        progress: called with the number of steps done and of all.
    """
    long: dict[str, Callable[[Context], object]] = {
        "statics": physics.statics,
        "standing": physics.standing,
        "collisions": partial(physics.collisions, progress=progress),
    }
    parts, missing = _computed(reported.context, long)
    missing = reported.document["missing"] | missing
    return reported._replace(
        document=reported.document | _portable(parts, reported.context) | {"missing": missing}
    )


def _computed(
    context: Context, wanted: Mapping[str, Callable[[Context], object]]
) -> tuple[ReportDocument, dict[str, str]]:
    """Parts of a document, and why some of them cannot be had."""
    parts: ReportDocument = {}
    missing: dict[str, str] = {}
    for name, part in wanted.items():
        try:
            parts[name] = part(context)
        except Unavailable as reason:
            parts[name], missing[name] = None, str(reason)
    return parts, missing


def _document(context: Context, report: Report) -> ReportDocument:
    parts, missing = _computed(context, _PARTS)
    if parts["gazebo"]:
        parts["gazebo"]["rejected"] = [
            {"by": one.reader, "code": one.code, "message": one.message}
            for one in rejections(report.diagnostics, context.gazebo)
        ]
    is_read = context.reading.document is not None
    places = ElementLookup(context.model if is_read else None)
    written = as_json.without_findings(report)
    document = {
        "version": VERSION,
        "urdfkit": __version__,
        "file": shown(context.source.path),
        "arguments": context.arguments,
        "summary": {
            key: written["summary"][key]
            for key in ("error", "warning", "info", "suppressed", "codes", "rules")
        },
        "targets": _targets(report),
        "findings": findings(report.diagnostics, places),
        "gathered": findings(grouped(report.diagnostics), places),
        "skipped": written["skipped"],
        "crashed": written["crashed"],
        **dict.fromkeys(LONG),
        **parts,
        "missing": missing,
    }
    return _portable(document, context)


def _portable(document: ReportDocument, context: Context) -> ReportDocument:
    """What JSON can hold, without the directories of the machine that it was made on.

    Paths in the workspace of the robot begin at the workspace.
    """
    file = disk.real(context.source.path)
    around = (context.resolver.packages.workspace(file), os.path.dirname(file))
    home = os.path.expanduser("~")

    def portable(value: Any) -> Any:
        if isinstance(value, dict):
            return {key: portable(one) for key, one in value.items()}
        if isinstance(value, list | tuple):
            return [portable(one) for one in value]
        if not isinstance(value, str) or os.sep not in value:
            return value
        for directory in around:
            value = without_directory(value, directory)
        return without_directory(value, home, "~/")

    found: ReportDocument = portable(finite(document))
    return found


def _targets(report: Report) -> list[dict[str, Any]]:
    """The verdict for each target program, and why the target was detected."""
    names = [name for _, targets in report.targets for name in targets.names]
    evidence = {
        name: reason
        for _, targets in report.targets
        for name, _, reason in (text.partition(": ") for text in targets.evidence)
    }
    return [_target(name, evidence.get(name, ""), report) for name in names]


def _target(name: str, evidence: str, report: Report) -> dict[str, Any]:
    counts = dict.fromkeys((severity.value for severity in Severity), 0)
    for found in report.diagnostics:
        counts[_severity(found, name).value] += 1
    verdict = "passes"
    if counts["error"]:
        verdict = "fails"
    elif counts["warning"]:
        verdict = "passes with warnings"
    about = facts_of(name).title
    return {"name": name, "about": about, "evidence": evidence, "verdict": verdict, **counts}


def _severity(found: Diagnostic, target: str) -> Severity:
    """How bad a finding is for one program alone."""
    rule = rule_index.get(found.code)
    own = rule.severities.get(target) if found.targets else None
    return own or found.severity
