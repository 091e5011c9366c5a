"""The kinematic tree in several formats; each format is a module with ``render(tree)``."""

from urdfkit.output.diagrams.rows import TreeRow, rows

#: Modules with ``render``.
FORMATS = ("text", "dot", "mermaid", "svg", "json")

__all__ = ["FORMATS", "TreeRow", "rows"]
