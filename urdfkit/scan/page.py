"""A human-readable summary of a scan, as text and as a self-contained HTML file."""

from collections.abc import Iterable, Iterator, Sequence
from html import escape

from urdfkit import __version__
from urdfkit.core.words import counted
from urdfkit.scan.summary import FACTS, MAX_EXAMPLES, Summary

_STYLE = """
body { font: 15px/1.5 system-ui, sans-serif; margin: 2em auto; max-width: 70em; padding: 0 1em }
table { border-collapse: collapse; width: 100% } th { text-align: left }
th, td { border-bottom: 1px solid #8884; padding: .25em .75em .25em 0; vertical-align: top }
td.n, th.n { text-align: right } code { overflow-wrap: anywhere } .error { color: #c22 }
.warning { color: #a60 } @media (prefers-color-scheme: dark) {
body { background: #181818; color: #ddd } .error { color: #f77 } .warning { color: #fa4 } }
"""

#: A heading, column names, and rows; numbers are right-aligned.
_Table = tuple[str, Sequence[str], list[tuple[object, ...]]]


def text(summary: Summary) -> Iterator[str]:
    yield from _counts(summary)
    for heading, columns, rows in _tables(summary):
        if rows:
            yield ""
            yield heading
            cells = [[str(cell) for cell in row] for row in [tuple(columns), *rows]]
            widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
            for row, line in zip([columns, *rows], cells, strict=True):
                yield (
                    "  "
                    + "  ".join(
                        cell.rjust(width) if _is_number(raw) else cell.ljust(width)
                        for raw, cell, width in zip(row, line, widths, strict=True)
                    ).rstrip()
                )


def html(summary: Summary, title: str) -> str:
    parts = [
        f'<!doctype html><html lang="en"><meta charset="utf-8"><title>{escape(title)}</title>',
        f"<style>{_STYLE}</style><h1>{escape(title)}</h1>",
        "".join(f"<p>{escape(line)}</p>" for line in _counts(summary)),
    ]
    for heading, columns, rows in _tables(summary):
        if rows:
            parts.append(f"<h2>{escape(heading)}</h2>{_html_table(columns, rows)}")
    return "\n".join([*parts, f"<p>urdfkit {__version__}</p>", ""])


def _counts(summary: Summary) -> Iterator[str]:
    statuses = ", ".join(f"{count} {status}" for status, count in summary.statuses.items())
    yield f"{counted(summary.models, 'model')}: {statuses}"
    yield (
        f"{summary.with_errors} with errors, {summary.with_warnings} with warnings only, "
        f"{summary.clean} without errors and warnings"
    )
    copies = "1 copy" if summary.redundant == 1 else f"{summary.redundant} copies"
    yield f"{copies} of others; {summary.cpu_seconds:.1f} s of processor time"


def _tables(summary: Summary) -> Iterator[_Table]:
    yield (
        "Rules",
        ("models", "rate", "findings", "code", "severity", "rule", "for example"),
        [
            (
                rate.models,
                f"{rate.models / summary.models:.1%}",
                rate.findings,
                rate.code,
                rate.severity,
                rate.rule,
                rate.examples[0],
            )
            for rate in summary.rules
        ],
    )
    yield (
        "Same content",
        ("models", "for example"),
        [(len(group), _listed(group)) for group in summary.duplicates],
    )
    yield (
        "Outliers",
        ("fact", "value", "middle half of the models", "model"),
        [
            (
                outlier.fact,
                f"{outlier.value:.4g} {FACTS[outlier.fact]}".strip(),
                f"{outlier.low:.4g} to {outlier.high:.4g}",
                outlier.model,
            )
            for outlier in summary.outliers
        ],
    )
    yield ("Not checked", ("model", "status", "reason"), list(summary.failures))


def _listed(names: Sequence[str]) -> str:
    return ", ".join(names[:MAX_EXAMPLES]) + (", ..." if len(names) > MAX_EXAMPLES else "")


def _is_number(cell: object) -> bool:
    return isinstance(cell, int)


def _html_table(columns: Sequence[str], rows: list[tuple[object, ...]]) -> str:
    head = "".join(f"<th>{escape(name)}</th>" for name in columns)
    return f"<table><tr>{head}</tr>{''.join(map(_html_row, rows))}</table>"


def _html_row(row: Iterable[object]) -> str:
    cells = []
    for cell in row:
        css_class = "n" if _is_number(cell) else str(cell) if cell in ("error", "warning") else ""
        attribute = f' class="{css_class}"' if css_class else ""
        cells.append(f"<td{attribute}>{escape(str(cell))}</td>")
    return f"<tr>{''.join(cells)}</tr>"
