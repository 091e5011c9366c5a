"""A comparison as Markdown, for a pull request."""

from collections.abc import Iterable, Iterator
from math import degrees

from urdfkit.core.words import spaced
from urdfkit.output.comparison import KINDS, Comparison, portable
from urdfkit.text.diagnostic import Diagnostic
from urdfkit.text.markdown import code, escape, fitted, table


def render(comparison: Comparison, *, width: int = 80) -> str:
    """A summary, then a section for each kind."""
    return portable(fitted([_head(comparison), *_sections(comparison)]), comparison)


def _head(comparison: Comparison) -> str:
    words = [kind for kind in KINDS if kind in comparison.kinds]
    what = f"differs in {', '.join(words)}" if words else "no differences beyond the tolerances"
    return f"### urdfkit diff\n\n{code(comparison.before)} → {code(comparison.after)}: **{what}**\n"


def _sections(comparison: Comparison) -> Iterator[str]:
    if comparison.total_differs:
        old, new = comparison.whole.mass, comparison.whole_after.mass
        rows = [["mass / kg", f"{old:g}", f"{new:g}", f"{new - old:+.4g}"]]
        if centers := comparison.centers:
            moved = f"{1000 * comparison.center_moved:.4g} mm"
            rows.append(["centre of mass / m", *(spaced(center, 4) for center in centers), moved])
        yield _section("Total", table(["", "before", "after", "change"], rows))
    for kind in KINDS:
        changes = [change for change in comparison.differences if change.kind == kind]
        if changes:
            rows = [
                [f"{change.what} {code(change.name)}", escape(change.text)] for change in changes
            ]
            title = "Joint frames" if kind == "frames" else kind.capitalize()
            yield _section(title, table(["", "what"], rows))
    if comparison.moved:
        rows = [
            [
                code(m.link),
                f"{1000 * m.distance:.3f}",
                f"{degrees(m.angle):.3f}",
                "moved with its parent" * m.carried,
            ]
            for m in comparison.moved
        ]
        header = ["link", "mm", "deg", ""]
        yield _section("Links that moved, all joints at zero", table(header, rows))
    for title, findings in (
        ("New findings", comparison.new_findings),
        ("Fixed findings", comparison.fixed_findings),
    ):
        if findings:
            yield _section(title, table(["", "where", "what"], _findings(findings)))
    for note in comparison.notes:
        yield f"Note: {note}\n"


def _findings(findings: Iterable[Diagnostic]) -> Iterator[list[str]]:
    for finding in findings:
        what = f"{finding.severity.value} {finding.code}"
        yield [what, code(str(finding.span)), escape(finding.message)]


def _section(title: str, body: str) -> str:
    return f"#### {title}\n\n{body}"
