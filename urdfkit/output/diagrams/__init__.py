"""The kinematic tree in several formats, one in each module; each has ``render(tree)``."""

from urdfkit.output.diagrams.rows import TreeRow, rows

#: Modules of this package that have ``render``.
FORMATS = ("text", "dot", "mermaid", "svg", "json")

__all__ = ["FORMATS", "TreeRow", "rows"]
