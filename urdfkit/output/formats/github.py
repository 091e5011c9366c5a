"""Annotations of a GitHub workflow: GitHub shows every finding at its line of the pull request.

Source of the format: GitHub's documentation of workflow commands.
"""

from collections.abc import Iterator

from urdfkit.lint.report import Report
from urdfkit.output.formats._paths import in_repository, posix
from urdfkit.text.diagnostic import Diagnostic, Severity

_COMMANDS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "notice"}


def stream(report: Report, *, color: bool = False, width: int = 80) -> Iterator[str]:
    """A line for every finding, and for every rule that crashed."""
    for diagnostic in report.diagnostics:
        yield f"{_annotation(diagnostic)}\n"
    for crash in report.crashed:
        text = _data(f"{posix(crash.path)}: {crash.error}")
        yield f"::error title=urdfkit {crash.code or 'check'}::{text}\n"


def _annotation(diagnostic: Diagnostic) -> str:
    span = diagnostic.span
    line, column = span.source.position(span.start)
    end_line, end_column = span.source.position(span.end)
    path = in_repository(span.source.path)
    properties = f"file={_property(path)},line={line},endLine={end_line}"
    if end_line == line:  # GitHub accepts columns only in a single line
        properties += f",col={column},endColumn={end_column}"
    title = _property(f"{diagnostic.code} {diagnostic.name}")
    return (
        f"::{_COMMANDS[diagnostic.severity]} {properties},title={title}::{_data(diagnostic.text)}"
    )


def _data(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _data(text).replace(":", "%3A").replace(",", "%2C")
