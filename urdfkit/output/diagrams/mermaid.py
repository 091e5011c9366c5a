"""The tree as a Mermaid flow chart, which GitHub and GitLab draw in Markdown."""

from urdfkit.output.diagrams.rows import caption, rows
from urdfkit.robot.tree import KinematicTree
from urdfkit.text.terminal import printable


def render(tree: KinematicTree) -> str:
    """The tree as a flow chart: links are nodes, joints are edges."""
    numbers = {name: f"n{number}" for number, name in enumerate(tree.children)}
    lines = ["flowchart TD"]
    lines += [f"  {number}[{_quoted(name)}]" for name, number in numbers.items()]
    lines += [
        f"  {numbers[row.parent]} -->|{_quoted(f'{row.joint.name}: {caption(row.joint)}')}| "
        f"{numbers[row.link]}"
        for row in rows(tree)
        if row.joint
    ]
    return "\n".join(lines) + "\n"


def _quoted(text: str) -> str:
    """A quoted string; special characters of Mermaid and HTML become entities."""
    special = {'"': "#quot;", "#": "#35;", "<": "#lt;", ">": "#gt;", "`": "#96;", "\\": "#92;"}
    return '"{}"'.format("".join(special.get(letter, letter) for letter in printable(text)))
