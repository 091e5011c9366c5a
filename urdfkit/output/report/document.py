"""The document of a report: plain values that JSON can represent.

Lengths in m, angles in rad, masses in kg, moments in kg·m². A part that cannot be computed,
because a library is missing or the robot cannot be read, is None; ``missing`` has the reason.
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
from urdfkit.lint.loading import context_of, require_robot
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

#: Version of the document; an incompatible change increments it.
VERSION = 1

ReportDocument = dict[str, Any]

#: Functions that compute the parts of the document from a robot's Context.
_PARTS: dict[str, Callable[[Context], object]] = {
    "robot": tables.robot,
    "links": tables.links,
    "joints": tables.joints,
    "gazebo": tables.gazebo,
    "meshes": tables.meshes,
}
#: The slow parts.
SLOW_SECTIONS = ("statics", "standing", "collisions")


class ReportInput(Record):
    """A robot, its findings, and the document that reports them."""

    document: ReportDocument  # for all outputs
    context: Context  # the robot
    diagnostics: tuple[Diagnostic, ...]  # findings of ``urdfkit check``


def describe(
    file: str | os.PathLike[str] | Source,
    options: Options = Options(),
    *,
    quick: bool = False,
    progress: Progress | None = None,
) -> ReportInput:
    """The contents of a report.

    If the robot cannot be read, only its findings are reported.

    Args:
        file: a URDF or xacro file, or a launch file that describes one robot.
        quick: omit the slow parts, `SLOW_SECTIONS`.
        progress: called with the number of finished steps and of all steps of a slow part.

    Raises:
        UnreadableFile: the file is missing or cannot be read.
        UnreadableRobot: the file describes no robot, or a launch file several.
        ConfigError: the configuration has several variants of the file, or lacks this variant.
    """
    options = options.with_config()
    source, resolver = Source.of(file), Resolver(options.packages)
    values = options.config.entry(source.path, options.arguments, options.variant).arguments
    targets = given_targets(options)
    context = context_of(
        source, resolver, values, trust=options.trust, cache=options.cache, targets=targets
    )
    if context.is_bringup or context.reading.document is not None:
        require_robot(context)
    report = check_read(options.for_one(context.arguments).resolved(), context)
    reported = ReportInput(_document(context, report), context, tuple(report.diagnostics))
    return reported if quick else completed(reported, progress)


def completed(reported: ReportInput, progress: Progress | None = None) -> ReportInput:
    """A report with the slow parts.

    Args:
        progress: called with the number of finished steps and of all steps.
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
    context: Context, functions: Mapping[str, Callable[[Context], object]]
) -> tuple[ReportDocument, dict[str, str]]:
    """Parts of a document, and the reasons why parts are missing."""
    parts: ReportDocument = {}
    missing: dict[str, str] = {}
    for name, part in functions.items():
        try:
            parts[name] = part(context)
        except Unavailable as reason:
            parts[name], missing[name] = None, str(reason)
    return parts, missing


def _document(context: Context, report: Report) -> ReportDocument:
    parts, missing = _computed(context, _PARTS)
    if parts["gazebo"]:
        parts["gazebo"]["rejected"] = [
            {"by": rejection.reader, "code": rejection.code, "message": rejection.message}
            for rejection in rejections(report.diagnostics, context.gazebo)
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
        **dict.fromkeys(SLOW_SECTIONS),
        **parts,
        "missing": missing,
    }
    return _portable(document, context)


def _portable(document: ReportDocument, context: Context) -> ReportDocument:
    """The document as JSON can represent it, without directories of this machine.

    Paths in the workspace of the robot are relative to the workspace.
    """
    file = disk.real(context.source.path)
    around = (context.resolver.packages.workspace(file), os.path.dirname(file))
    home = os.path.expanduser("~")

    def portable(value: Any) -> Any:
        if isinstance(value, dict):
            return {key: portable(item) for key, item in value.items()}
        if isinstance(value, list | tuple):
            return [portable(item) for item in value]
        if not isinstance(value, str) or os.sep not in value:
            return value
        for directory in around:
            value = without_directory(value, directory)
        return without_directory(value, home, "~/")

    result: ReportDocument = portable(finite(document))
    return result


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
    for finding in report.diagnostics:
        counts[_severity(finding, name).value] += 1
    verdict = "passes"
    if counts["error"]:
        verdict = "fails"
    elif counts["warning"]:
        verdict = "passes with warnings"
    about = facts_of(name).title
    return {"name": name, "about": about, "evidence": evidence, "verdict": verdict, **counts}


def _severity(finding: Diagnostic, target: str) -> Severity:
    """Severity of a finding for one target."""
    rule = rule_index.get(finding.code)
    own = rule.severities.get(target) if finding.targets else None
    return own or finding.severity
