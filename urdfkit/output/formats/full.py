"""For people who want all of it: every finding with its line of source, calls and notes."""

from collections.abc import Iterator
from itertools import groupby

from urdfkit.lint.grouping import grouped
from urdfkit.lint.report import Report
from urdfkit.output.formats._page import TextPage
from urdfkit.output.formats._summary import crashes, hints, summary


def render(report: Report, *, color: bool = False, width: int = 80) -> str:
    """All findings by file and line, then the crashed rules, the hints, and the summary."""
    return "".join(stream(report, color=color, width=width))


def stream(report: Report, *, color: bool = False, width: int = 80) -> Iterator[str]:
    """The same in parts."""
    page = TextPage(color, width)
    between = ""
    for block in _blocks(report, page):
        yield between + block
        between = "\n"
    yield summary(report, color=color, width=width)


def _blocks(report: Report, page: TextPage) -> Iterator[str]:
    # What is shown as one is in one file, and the findings are in the order of files.
    for _, of_file in groupby(report.diagnostics, key=lambda one: one.span.source.path):
        yield from map(page.finding, grouped(tuple(of_file)))
    yield from crashes(report, page)
    if text := hints(report, page):
        yield text
