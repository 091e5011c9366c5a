"""Outline of a file: the kinematic tree of its links and joints, and other definitions."""

import os
from collections.abc import Iterable

from urdfkit.lsp.markup import Markup, TagNode
from urdfkit.lsp.open_robot import OpenRobot
from urdfkit.robot.joint import Joint
from urdfkit.robot.link import Link
from urdfkit.text.document import Element
from urdfkit.text.source import Span

#: Depth of the outline; deeper joints are listed at this depth.
MAX_DEPTH = 60
#: Limit of the results of a query.
MAX_SYMBOLS = 500
_SYMBOLS = ("link", "joint", "material", "macro", "property", "arg")

_DEFINITIONS = {
    "xacro:macro": "macro",
    "xacro:property": "property",
    "xacro:arg": "argument",
    "material": "material",
    "gazebo": "gazebo",
    "transmission": "transmission",
    "ros2_control": "transmission",
    "group": "group",
    "group_state": "group",
}


class OutlineEntry:
    """An entry of the outline."""

    def __init__(self, name: str, detail: str, kind: str, span: Span) -> None:
        self.name = name or "?"
        self.detail = detail  # shown after the name
        self.kind = kind  # ``robot``, ``link``, ``joint``, ``macro``, ``property`` and so on
        self.span = span  # the element, or the macro call in this file that creates it
        self.children: list[OutlineEntry] = []


def outline(robot: OpenRobot, markup: Markup) -> list[OutlineEntry]:
    top = [_definition(node) for node in markup.nodes if _is_definition(node)]
    if robot.document is None:
        plain = [node for node in markup.nodes if node.name in ("link", "joint") and _is_top(node)]
        return top + [OutlineEntry(node.get("name"), "", node.name, node.span) for node in plain]
    return [*_tree(robot, markup), *top]


def symbols(robots: Iterable[OpenRobot], query: str) -> list[tuple[str, str, Span]]:
    """Kind, name and span of definitions whose names contain the letters of a query in order."""
    defined = (
        (use.kind, name, use.span)
        for robot in robots
        for use in robot.names.all
        if use.is_definition and use.kind in _SYMBOLS
        for name in sorted(robot.names.values(use))
        if _matches(query.lower(), name.lower())
    )
    return sorted(dict.fromkeys(defined), key=lambda use: (len(use[1]), use[1]))[:MAX_SYMBOLS]


def _matches(query: str, name: str) -> bool:
    letters = iter(name)
    return all(letter in letters for letter in query)


def _is_definition(node: TagNode) -> bool:
    return node.name in _DEFINITIONS and (_is_top(node) or node.name.startswith("xacro:"))


def _is_top(node: TagNode) -> bool:
    return node.parent is not None and node.parent.name in ("robot", "xacro:if", "xacro:unless")


def _definition(node: TagNode) -> OutlineEntry:
    name = node.get("name") or node.get("reference") or node.name
    detail = node.get("value") or node.get("default") or node.get("params")
    return OutlineEntry(name, " ".join(detail.split())[:80], _DEFINITIONS[node.name], node.span)


def _tree(robot: OpenRobot, markup: Markup) -> list[OutlineEntry]:
    """The links and joints that a file creates, as a tree."""
    model, tree = robot.context.model, robot.context.tree
    tops: list[OutlineEntry] = []
    visited: set[str] = set()
    names = [*(link.name for link in tree.roots), *model.links_by_name]  # the latter for loops
    stack = [(name, tops, 0) for name in reversed(names)]
    while stack:
        name, siblings, depth = stack.pop()
        if name in visited:
            continue
        visited.add(name)
        siblings = _add(siblings if depth < MAX_DEPTH else tops, model.links_by_name[name], markup)
        below = [(joint.child, _add(siblings, joint, markup)) for joint in tree.children[name]]
        stack += [(child.value, inner, depth + 2) for child, inner in reversed(below) if child]
    for joint in model.joints:
        ends = tree.ends(joint)
        if ends is None or ends[0] == ends[1]:
            _add(tops, joint, markup)
    return tops


def _add(siblings: list[OutlineEntry], part: Link | Joint, markup: Markup) -> list[OutlineEntry]:
    """Add an entry if the file creates the part; return the list for its children."""
    span = _span_in_file(part.at, markup)
    if span is None:
        return siblings
    if isinstance(part, Link):
        entry = OutlineEntry(part.name, f"{part.mass:g} kg" if part.mass else "", "link", span)
    else:
        entry = OutlineEntry(part.name, part.kind, "joint", span)
    siblings.append(entry)
    return entry.children


def _span_in_file(element: Element, markup: Markup) -> Span | None:
    """The span in a file that creates an element: the element, or the outermost call."""
    path = os.path.realpath(markup.source.path)
    for step in element.via:
        if step.kind != "include" and os.path.realpath(step.span.source.path) == path:
            return step.span
    if os.path.realpath(element.span.source.path) == path:
        return element.tag_at.whole_span
    return None
