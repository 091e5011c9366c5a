"""Markdown for the summary of a CI job or a comment on a pull request."""

from collections.abc import Iterator, Sequence

from urdfkit.core.words import counted
from urdfkit.lint.grouping import grouped
from urdfkit.lint.report import Report
from urdfkit.output.formats._paths import posix
from urdfkit.output.formats._summary import summary
from urdfkit.text.diagnostic import Diagnostic, Severity
from urdfkit.text.markdown import escape

#: Most findings in a table. GitHub accepts 1 MiB for all steps of a job.
MAX_ROWS = 200
_WIDE = 10**6  # width at which no line is wrapped


def render(report: Report, *, color: bool = False, width: int = 80) -> str:
    """A heading with the counts, a table of errors and warnings, and a folded table of infos."""
    counts = summary(report, width=_WIDE).strip()
    shown = grouped(report.diagnostics)
    bad = [item for item in shown if item.severity is not Severity.INFO]
    bad.sort(key=lambda item: item.severity.rank)
    infos = [item for item in shown if item.severity is Severity.INFO]
    lines = [f"### urdfkit: {escape(counts)}", ""]
    for crash in report.crashed:
        place = f"{crash.code or 'the check'} crashed on {posix(crash.path)}"
        text = f"{place}: {crash.error}. This is a bug in urdfkit."
        lines += [f"**{escape(text)}**", ""]
    if bad:
        lines += [*_table(bad), ""]
    if infos:
        many = counted(report.count(Severity.INFO), "info")
        lines += [f"<details><summary>{many}</summary>", "", *_table(infos), "", "</details>", ""]
    if report.diagnostics:
        first = (bad or infos)[0].code
        lines += [f"Explain a code: `urdfkit explain {first}`", ""]
    return "\n".join(lines)


def _table(diagnostics: Sequence[Diagnostic]) -> Iterator[str]:
    yield "| | where | what |"
    yield "| --- | --- | --- |"
    for diagnostic in diagnostics[:MAX_ROWS]:
        span = diagnostic.span
        where = f"{posix(span.source.path)}:{span.line}:{span.column}"
        kind = f"{diagnostic.severity.value} **{diagnostic.code}**"
        yield f"| {kind} | <code>{escape(where)}</code> | {_what(diagnostic)} |"
    if len(diagnostics) > MAX_ROWS:
        yield f"| | | and {len(diagnostics) - MAX_ROWS} more |"


def _what(diagnostic: Diagnostic) -> str:
    parts = [escape(diagnostic.message_with_variants)]
    if len(diagnostic.calls) > 1:
        parts[0] += f" (expanded from {len(diagnostic.calls)} places)"
    if diagnostic.help:
        parts.append(f"<sub>{escape(diagnostic.help)}</sub>")
    return "<br>".join(parts)
