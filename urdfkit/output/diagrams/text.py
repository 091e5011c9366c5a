"""The tree as text: a link per line, followed by its parent joint."""

from collections.abc import Iterator

from urdfkit.output.diagrams.rows import captions, rows
from urdfkit.robot.tree import KinematicTree
from urdfkit.text.terminal import printable

#: Deepest level; deeper links are drawn there, as terminals are not wider.
MAX_DEPTH = 40


#: Least number of columns for the description of a joint, at any depth.
LEAST_WIDTH = 40


def render(tree: KinematicTree, width: int = 80) -> str:
    """The tree as text.

    Args:
        width: columns; a longer description of a joint is wrapped.
    """
    return "".join(f"{printable(line)}\n" for line in _lines(tree, width))


def _lines(tree: KinematicTree, width: int) -> Iterator[str]:
    bars: list[str] = []  # text left of a row at each depth
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
    """A line with its parts, wrapped to further lines."""
    for part in parts:
        if len(line) + len(part) + 1 <= width:  # a comma may follow
            line += part
        else:
            yield line + "," * part.startswith(",")
            line = indent + part.lstrip(", ")
    yield line
