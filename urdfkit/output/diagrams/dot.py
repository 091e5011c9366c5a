"""The tree for Graphviz."""

from urdfkit.output.diagrams.rows import caption, rows
from urdfkit.robot.tree import KinematicTree


def render(tree: KinematicTree) -> str:
    """The tree in the language of Graphviz: links are nodes, joints are edges."""
    lines = [f"digraph {_quoted(tree.model.name)} {{", "  node [shape=box];"]
    lines += [f"  {_quoted(name)};" for name in tree.children]
    lines += [
        f"  {_quoted(row.parent)} -> {_quoted(row.link)}"
        f" [label={_quoted(row.joint.name, caption(row.joint))}];"
        for row in rows(tree)
        if row.joint
    ]
    return "\n".join([*lines, "}"]) + "\n"


def _quoted(*lines: str) -> str:
    """A quoted string; each of several lines is centred."""
    escaped = (line.replace("\\", "\\\\").replace('"', '\\"') for line in lines)
    return '"{}"'.format("\\n".join(escaped))
