"""A comparison as one HTML file that opens offline, with images of both states."""

from math import degrees

from urdfkit.output.comparison import KINDS, Comparison, portable
from urdfkit.output.report.html import render_plain
from urdfkit.output.report.translations import Translator

#: Rows of one table.
MAX_ROWS = 400


def render(comparison: Comparison, *, width: int = 80, language: str = "en") -> str:
    """A summary, images, and a table for each kind of difference.

    Args:
        width: ignored, as a browser wraps lines.
        language: of headings and other fixed texts: ``en`` or ``zh``.
    """
    by_kind = {
        kind: [change for change in comparison.differences if change.kind == kind] for kind in KINDS
    }
    page = render_plain(
        "diff.html.j2",
        Translator(language),
        comparison=comparison,
        differs=[kind for kind in KINDS if kind in comparison.kinds],
        sections=[(kind, found[:MAX_ROWS]) for kind, found in by_kind.items() if found],
        moved=[
            (move.link, 1000 * move.distance, degrees(move.angle), move.carried)
            for move in comparison.moved[:MAX_ROWS]
        ],
        findings=[
            (title, found[:MAX_ROWS])
            for title, found in (
                ("New findings", comparison.new_findings),
                ("Fixed findings", comparison.fixed_findings),
            )
            if found
        ],
    )
    return portable(page, comparison)
