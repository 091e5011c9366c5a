"""The tree for a terminal: a link in each line, behind it the joint that leads to it."""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.diagrams.rows import caption, rows
from urdfkit.mechanics.tree import KinematicTree

#: Deeper links are all drawn at this depth: no terminal is wider.
MAX_DEPTH = 40


def render(tree: KinematicTree) -> str:
    """The tree as text.

    Args:
        tree: of the model.
    """
    return "".join(f"{line}\n" for line in _lines(tree))


def _lines(tree: KinematicTree) -> Iterator[str]:
    bars: list[str] = []  # what stands left of a row at each depth
    for row in rows(tree):
        if row.joint is None:
            yield row.link
            continue
        del bars[row.depth - 1 :]
        corner = "└ " if row.is_last else "├ "
        left = "".join(bars[:MAX_DEPTH])
        again = "  (see above)" if row.is_again else ""
        yield f"{left}{corner}{row.link}  {row.joint.name}: {caption(row.joint)}{again}"
        bars.append("  " if row.is_last else "│ ")
