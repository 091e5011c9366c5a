"""For people: errors with their line of source, warnings in brief, infos counted."""

from collections import Counter
from collections.abc import Iterator
from itertools import groupby

from urdfkit.core.words import counted, few
from urdfkit.lint.grouping import grouped, groups
from urdfkit.lint.report import Report
from urdfkit.output.formats._page import TextPage
from urdfkit.output.formats._summary import crashes, hints, summary
from urdfkit.text.diagnostic import Diagnostic, Severity

#: Codes of infos that are named.
MAX_CODES = 6


def render(report: Report, *, color: bool = False, width: int = 80) -> str:
    """Errors, warnings, how many infos, then the crashed rules, the hints, and the summary."""
    return "".join(stream(report, color=color, width=width))


def stream(report: Report, *, color: bool = False, width: int = 80) -> Iterator[str]:
    """Like `render`, in parts."""
    page = TextPage(color, width)
    yield from findings(report, color=color, width=width)
    yield _infos(report, page) + hints(report, page)
    yield summary(report, color=color, width=width)


def findings(report: Report, *, color: bool = False, width: int = 80) -> Iterator[str]:
    """Errors, warnings and crashed rules alone."""
    page = TextPage(color, width)
    for error in _of(report, Severity.ERROR):
        yield from (f"{page.finding(one)}\n" for one in grouped(error))
    for warning in _of(report, Severity.WARNING):
        yield from map(page.brief, groups(warning))
    if report.count(Severity.WARNING):
        yield "\n"
    yield from (f"{crash}\n" for crash in crashes(report, page))


def _of(report: Report, severity: Severity) -> Iterator[tuple[Diagnostic, ...]]:
    """The findings of a severity, file by file: what is shown as one is in one file."""
    found = (one for one in report.diagnostics if one.severity is severity)
    for _, of_file in groupby(found, key=lambda one: one.span.source.path):
        yield tuple(of_file)


def _infos(report: Report, page: TextPage) -> str:
    codes = Counter(one.code for one in report.diagnostics if one.severity is Severity.INFO)
    if not codes:
        return ""
    names = few([code for code, _ in codes.most_common()], MAX_CODES)
    count = counted(codes.total(), "info")
    return page.wrap(f"Not shown: {count} ({names}); --info shows them", indent=2) + "\n"
