"""The tree for a terminal: a link in each line, behind it the joint that leads to it."""

from collections.abc import Iterator

from urdfkit.output.diagrams.rows import captions, rows
from urdfkit.robot.tree import KinematicTree
from urdfkit.text.terminal import printable

#: Deeper links are all drawn at this depth: no terminal is wider.
MAX_DEPTH = 40


#: Columns for the description of a joint at least, however deep it is in the tree.
LEAST_WIDTH = 40


def render(tree: KinematicTree, width: int = 80) -> str:
    """The tree as text.

    Args:
        width: columns; a longer description of a joint is wrapped.
    """
    return "".join(f"{printable(line)}\n" for line in _lines(tree, width))


def _lines(tree: KinematicTree, width: int) -> Iterator[str]:
    bars: list[str] = []  # what stands left of a row at each depth
    for row in rows(tree):
        if row.joint is None:
            yield row.link
            continue
        del bars[row.depth - 1 :]
        corner = "└ " if row.is_last else "├ "
        left = "".join(bars[:MAX_DEPTH])
        kind, *others = captions(row.joint)
        parts = [f"  {row.joint.name}: {kind}", *(f", {other}" for other in others)]
        parts += ["  (see above)"] * row.is_again
        bars.append("  " if row.is_last else "│ ")
        below = "│ " if tree.children[row.link] and not row.is_again else "  "
        yield from _filled(
            f"{left}{corner}{row.link}",
            parts,
            f"{left}{bars[-1]}{below}  ",
            max(width, len(left) + LEAST_WIDTH),
        )


def _filled(line: str, parts: list[str], indent: str, width: int) -> Iterator[str]:
    """A line and what goes behind it, in further lines where there is no room."""
    for part in parts:
        if len(line) + len(part) + 1 <= width:  # a comma may follow
            line += part
        else:
            yield line + "," * part.startswith(",")
            line = indent + part.lstrip(", ")
    yield line
