"""Number of findings of each rule, the most frequent first."""

from urdfkit.lint.report import Report
from urdfkit.output.formats._page import COLORS, TextPage
from urdfkit.output.formats._summary import summary
from urdfkit.text.diagnostic import Severity


def render(report: Report, *, color: bool = False, width: int = 80) -> str:
    """A table of count, code, severity and name, then the summary."""
    page = TextPage(color, width)
    counts: dict[tuple[str, str, str], int] = {}
    for diagnostic in report.diagnostics:
        key = (diagnostic.code, diagnostic.severity.value, diagnostic.name)
        counts[key] = counts.get(key, 0) + 1
    rows = [
        f"{count:>6}  {code}  {page.paint(f'{severity:<7}', COLORS[Severity(severity)])}  {name}\n"
        for (code, severity, name), count in sorted(counts.items(), key=lambda row: (-row[1], row))
    ]
    return "".join(rows) + summary(report, color=color, width=width)
