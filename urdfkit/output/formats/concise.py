"""One line per finding, never wrapped: for grep, editors and short lists."""

from collections.abc import Iterator

from urdfkit.lint.report import Report
from urdfkit.output.formats._page import TextPage
from urdfkit.output.formats._summary import crashes, summary

_WIDE = 10**6


def stream(report: Report, *, color: bool = False, width: int = 80) -> Iterator[str]:
    """All findings by file and line, then the crashed rules and the summary."""
    yield from findings(report, color=color)
    yield summary(report, color=color, width=_WIDE)


def findings(report: Report, *, color: bool = False, width: int = 80) -> Iterator[str]:
    """The findings and crashed rules only."""
    page = TextPage(color, _WIDE)
    for finding in report.diagnostics:
        yield f"{page.head(finding._replace(message=finding.message_with_variants))}\n"
    yield from crashes(report, page)
