"""Every finding with its source line, macro calls and notes."""

from collections.abc import Iterator
from itertools import chain

from urdfkit.lint.grouping import by_file, grouped
from urdfkit.lint.report import Report
from urdfkit.output.formats._page import TextPage
from urdfkit.output.formats._summary import crashes, hints, summary


def stream(report: Report, *, color: bool = False, width: int = 80) -> Iterator[str]:
    """All findings by file and line, then the crashed rules, the hints, and the summary."""
    between = ""
    for block in findings(report, color=color, width=width):
        yield block
        between = "\n"
    if text := hints(report, TextPage(color, width)):
        yield between + text
    yield summary(report, color=color, width=width)


def findings(report: Report, *, color: bool = False, width: int = 80) -> Iterator[str]:
    """The findings and crashed rules only."""
    page = TextPage(color, width)
    between = ""
    for block in chain(_findings(report, page), crashes(report, page)):
        yield between + block
        between = "\n"


def _findings(report: Report, page: TextPage) -> Iterator[str]:
    for of_file in by_file(report.diagnostics):
        yield from map(page.finding, grouped(of_file))
