"""The tree as an SVG image, without other programs.

Each link has a row, so that trees of any shape are readable and printable.
"""

from collections.abc import Iterator
from html import escape

from urdfkit.output.diagrams.rows import TreeRow, caption, rows
from urdfkit.robot.tree import KinematicTree
from urdfkit.text.terminal import columns, printable

#: Sizes in pixels: height of a row, indentation of a level, margin, and width of a letter.
ROW, LEVEL, MARGIN, LETTER = 30, 26, 16, 7.8

#: Deepest level; deeper links are drawn there.
MAX_DEPTH = 60

_COLOURS = {
    "fixed": "#8a8f98",
    "revolute": "#1f6fb2",
    "continuous": "#0b8a6a",
    "prismatic": "#b5561c",
    "planar": "#8a4fb0",
    "floating": "#8a4fb0",
}
_OTHER = "#c0272d"

_STYLE = (
    "text { font: 13px ui-monospace, 'DejaVu Sans Mono', Menlo, Consolas, monospace; } "
    ".joint { fill: #555; font-size: 12px; } "
    "rect { fill: #fff; stroke-width: 1.5; } "
    "path { fill: none; stroke: #9aa0a8; stroke-width: 1.5; }"
)


def render(tree: KinematicTree) -> str:
    """The tree as an SVG document."""
    tree_rows = list(rows(tree))
    body = list(_body(tree_rows))
    width = max((_right(row) for row in tree_rows), default=0.0) + MARGIN
    height = len(tree_rows) * ROW + 2 * MARGIN
    size = f'width="{width:.0f}" height="{height}" viewBox="0 0 {width:.0f} {height}"'
    return "\n".join(
        [
            f'<svg xmlns="http://www.w3.org/2000/svg" {size} role="img">',
            f"<title>Kinematic tree of {_text(tree.model.name)}</title>",
            f"<style>{_STYLE}</style>",
            '<rect width="100%" height="100%"/>',
            *body,
            "</svg>",
            "",
        ]
    )


def _body(tree_rows: list[TreeRow]) -> Iterator[str]:
    above: list[int] = []  # the row of the open link at each depth
    for number, row in enumerate(tree_rows):
        del above[row.depth :]
        if row.joint is not None:
            yield _line(row, above[row.depth - 1], number)
        above.append(number)
    for number, row in enumerate(tree_rows):
        yield from _box(row, number)


def _line(row: TreeRow, parent: int, number: int) -> str:
    """The line from below the parent's box to the left of the child's box."""
    x = _left(row.depth - 1) + LEVEL / 2
    return f'<path d="M{x:g} {_middle(parent) + 11:g} V{_middle(number):g} H{_left(row.depth):g}"/>'


def _box(row: TreeRow, number: int) -> Iterator[str]:
    x, y = _left(row.depth), _middle(number)
    kind = row.joint.kind if row.joint else "fixed"
    dashed = ' stroke-dasharray="4 3"' if row.is_again else ""
    yield (
        f'<rect x="{x:g}" y="{y - 11:g}" width="{_width(row.link) + 12:g}" height="22" rx="4" '
        f'stroke="{_COLOURS.get(kind, _OTHER)}"{dashed}/>'
    )
    yield f'<text x="{x + 6:g}" y="{y + 4.5:g}">{_text(row.link)}</text>'
    if row.joint is not None:
        label = _text(_label(row))
        at = x + _width(row.link) + 22
        yield f'<text class="joint" x="{at:g}" y="{y + 4:g}">{label}</text>'


def _label(row: TreeRow) -> str:
    assert row.joint is not None
    again = " (see above)" if row.is_again else ""
    return f"{row.joint.name}: {caption(row.joint)}{again}"


def _text(text: str) -> str:
    """A text escaped for XML, without invalid characters."""
    return escape(printable(text), quote=False)


def _left(depth: int) -> float:
    return MARGIN + min(depth, MAX_DEPTH) * LEVEL


def _middle(number: int) -> float:
    return MARGIN + (number + 0.5) * ROW


def _right(row: TreeRow) -> float:
    label = _width(_label(row)) * 12 / 13 + 22 if row.joint else 12.0
    return _left(row.depth) + _width(row.link) + label


def _width(text: str) -> float:
    """Width of a text in pixels; East Asian characters are twice as wide."""
    return LETTER * columns(text)
