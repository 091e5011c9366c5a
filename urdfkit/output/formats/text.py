"""The default format: errors with their source line, warnings in brief, number of infos."""

from collections import Counter
from collections.abc import Iterator

from urdfkit.core.words import counted, few
from urdfkit.lint.grouping import by_file, grouped, groups
from urdfkit.lint.report import Report
from urdfkit.output.formats._page import TextPage
from urdfkit.output.formats._summary import crashes, hints, summary
from urdfkit.text.diagnostic import Severity

#: Most codes of infos that are named.
MAX_CODES = 6


def stream(report: Report, *, color: bool = False, width: int = 80) -> Iterator[str]:
    """Errors, warnings and crashed rules, then the number of infos, the hints, and the summary."""
    page = TextPage(color, width)
    yield from findings(report, color=color, width=width)
    yield _infos(report, page) + hints(report, page)
    yield summary(report, color=color, width=width)


def findings(report: Report, *, color: bool = False, width: int = 80) -> Iterator[str]:
    """Errors, warnings and crashed rules only."""
    page = TextPage(color, width)
    for error in by_file(report.diagnostics, Severity.ERROR):
        yield from (f"{page.finding(finding)}\n" for finding in grouped(error, brief=True))
    for warning in by_file(report.diagnostics, Severity.WARNING):
        yield from map(page.brief, groups(warning))
    if report.count(Severity.WARNING):
        yield "\n"
    yield from (f"{crash}\n" for crash in crashes(report, page))


def _infos(report: Report, page: TextPage) -> str:
    codes = Counter(item.code for item in report.diagnostics if item.severity is Severity.INFO)
    if not codes:
        return ""
    names = few([code for code, _ in codes.most_common()], MAX_CODES)
    count = counted(codes.total(), "info")
    return page.wrap(f"Not shown: {count} ({names}); --info shows them", indent=2) + "\n"
