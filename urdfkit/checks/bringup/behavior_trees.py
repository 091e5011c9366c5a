"""Behaviour trees that the navigator of Nav2 does not load.

Sources: ``xml_parsing.cpp`` of BehaviorTree.CPP 3 and 4, ``recovery_node.cpp`` of
nav2_behavior_tree.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator

from urdfkit.core.suggest import CLOSE_TYPO, TYPO, did_you_mean, meant, nearest
from urdfkit.errors import PackageNotFound
from urdfkit.lint.rules import Context, Finding, Findings, Severity
from urdfkit.ros.catalog import data
from urdfkit.ros.node_parameters import NodeParameters
from urdfkit.text.document import Document, Element
from urdfkit.text.located_yaml import Value, scalars
from urdfkit.text.source import Source
from urdfkit.text.xml_reader import read_xml

_NAVIGATOR, _LIBRARIES = "bt_navigator", "plugin_lib_names"
#: The beginnings of the names of libraries that come with Nav2.
_OF_NAV2 = ("nav2_", "opennav_docking_")
_IN_PACKAGE = re.compile(r"\$\(find-pkg-share ([\w-]+)\)/(.+)")
#: Tags that name a node by their ID, and attributes of all nodes.
_EXPLICIT, _OF_ALL = ("Action", "Condition", "Control", "Decorator"), ("name", "ID")
_RECOVERY = "RecoveryNode"


def invalid_trees(context: Context, sections: list[NodeParameters]) -> Findings:
    navigators = [section for section in sections if section.name == _NAVIGATOR]
    libraries = [one for node in navigators for one in scalars(node.values.get(_LIBRARIES))]
    is_whole = bool(navigators) and all(one.text.startswith(_OF_NAV2) for one in libraries)
    for source in _trees(context, navigators):
        document, problems = read_xml(source)
        if document and (navigators or _is_of_nav2(document)):
            yield from _in_tree(document, is_whole=is_whole)
        for problem in () if document else problems[:1]:
            yield Finding(problem.span, f"bt_navigator does not read the tree: {problem.message}")


def _trees(context: Context, navigators: list[NodeParameters]) -> Iterator[Source]:
    """The files of behaviour trees that the launch file or the parameters name."""
    paths = [file.path for file in context.launch.files if file.path.endswith(".xml")]
    for node in navigators:
        for name, value in node.values.items():
            match = _IN_PACKAGE.fullmatch(value.text) if isinstance(value, Value) else None
            if match and name.endswith("_bt_xml"):
                try:
                    directory = context.resolver.package(match[1], context.source.path)
                except PackageNotFound:
                    continue
                paths.append(os.path.join(directory, match[2]))
    for path in dict.fromkeys(paths):
        source = context.resolver.readable(path)
        if source and b"<BehaviorTree" in source.data:
            yield source


def _is_of_nav2(document: Document) -> bool:
    """False for the tree of another program, which has nodes of its own."""
    known = _known(document)
    names = {_name(node) for node in _nodes(document)}
    return all(name in known or nearest(name, known, CLOSE_TYPO) for name in names)


def _in_tree(document: Document, *, is_whole: bool) -> Findings:
    root = document.root
    trees = {tree.get("ID") or "": tree for tree in root.all("BehaviorTree")}
    main = root.attributes.get("main_tree_to_execute")
    if main and main.value not in trees and not root.all("include"):
        message = f"no tree is called '{main.value}'{did_you_mean(main.value, trees)}"
        yield Finding(main, message, "write the ID of a <BehaviorTree>")
    ports: dict[str, str] = data("behavior_trees")["ports"]
    nodes = _nodes(document)
    if ports.keys().isdisjoint(map(_name, nodes)):
        return  # the tree of another program
    known = _known(document)
    for node in nodes:
        name = _name(node)
        if name in ports:
            yield from _wrong_ports(node, name, ports[name].split())
            yield from _wrong_children(node, name)
        elif name not in known:
            yield from _unknown(node, name, ports, is_whole=is_whole)


def _nodes(document: Document) -> list[Element]:
    trees = document.root.all("BehaviorTree")
    return [node for tree in trees for node in tree.walk() if node is not tree]


def _known(document: Document) -> set[str]:
    """The names of nodes of Nav2 and BehaviorTree.CPP, and of those that the file defines."""
    root, facts = document.root, data("behavior_trees")
    trees = {tree.get("ID") or "" for tree in root.all("BehaviorTree")}
    own = {model.get("ID") or "" for at in root.all("TreeNodesModel") for model in at.children}
    return {*facts["ports"], *facts["built_in"].split(), *trees, *own, *_EXPLICIT}


def _name(node: Element) -> str:
    return (node.get("ID") or "") if node.tag in _EXPLICIT else node.tag


def _unknown(node: Element, name: str, known: Iterable[str], *, is_whole: bool) -> Findings:
    """A node that no library offers; one of an unknown library only if it is misspelt."""
    suggested = nearest(name, known, TYPO if is_whole else CLOSE_TYPO)
    if is_whole or suggested:
        help = f"write {suggested}" if suggested else f"add its library to {_LIBRARIES}"
        message = f"bt_navigator does not load the tree: unknown node '{name}'{meant(suggested)}"
        yield Finding(node, message, help, severity=Severity.WARNING)


def _wrong_ports(node: Element, name: str, ports: list[str]) -> Findings:
    for key, attribute in node.attributes.items():
        if key not in ports and key not in _OF_ALL and not key.startswith("_"):
            message = f"bt_navigator does not load the tree: {name} has no port '{key}'"
            message += did_you_mean(key, ports)
            help = f"remove it; the ports are {', '.join(ports)}" if ports else "remove it"
            yield Finding(attribute, message, help, severity=Severity.WARNING)


def _wrong_children(node: Element, name: str) -> Findings:
    count, facts = len(node.children), data("behavior_trees")
    if name in facts["decorators"].split():
        expected: int | None = 1
    elif name in facts["controls"].split():
        expected = 2 if name == _RECOVERY else None
    else:
        expected = 0
    if expected is not None and count != expected:
        must = f"must have {expected or 'none'}"
        message = f"bt_navigator does not run the tree: {name} has {count} children, {must}"
        help = "put several of them into a Sequence" if expected and count > expected else ""
        yield Finding(node, message, help)
