"""The navigator of Nav2 cannot load its behaviour tree, or the tree calls what no server has.

- A behaviour tree has no full path (warning), or the default one calls a behaviour that is not in
  `behavior_plugins` (warning).
- A behaviour tree has a node or a port that Nav2 does not have (warnings), a decorator without
  exactly one child, or the name of a tree that is not there.

Sources:
    Nav2, behaviour trees: https://docs.nav2.org/behavior_trees/index.html
    BehaviorTree.CPP, xml_parsing.cpp: https://github.com/BehaviorTree/BehaviorTree.CPP/blob/master/src/xml_parsing.cpp
    Nav2, recovery_node.cpp: https://github.com/ros-navigation/navigation2/blob/main/nav2_behavior_tree/plugins/control/recovery_node.cpp
"""

import os
import re
from collections.abc import Iterable, Iterator

from urdfkit.checks.bringup.read_parameters import read_sections, whole_sections
from urdfkit.core.suggest import CLOSE_TYPO, TYPO, did_you_mean, hint_for, nearest
from urdfkit.errors import PackageNotFound
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.samples import nav2_launch
from urdfkit.ros.node_parameters import NodeParameters
from urdfkit.text.document import Document, Element
from urdfkit.text.located_yaml import Value, scalar, scalars
from urdfkit.text.source import Source
from urdfkit.text.xml_reader import read_xml

NAME = "launch/navigation.launch.py"
BAD = nav2_launch("nav2_bt_navigator", "bt_navigator", '"../navigation.yaml"')
GOOD = BAD.replace("navigation.yaml", "sound.yaml")
_NAVIGATION = b"bt_navigator:\n  ros__parameters: {default_nav_to_pose_bt_xml: '%s/wait.xml'}\n"
FILES = {
    "navigation.yaml": _NAVIGATION % b"trees",
    "sound.yaml": _NAVIGATION % b"$(find-pkg-share arm)/trees",
    "trees/wait.xml": b'<root BTCPP_format="4"><BehaviorTree ID="Main"><Wait/>'
    b"</BehaviorTree></root>",
    "package.xml": b"<package><name>arm</name></package>",
}

_NAVIGATOR, _LIBRARIES = "bt_navigator", "plugin_lib_names"
#: The beginnings of the names of libraries that come with Nav2.
_OF_NAV2 = ("nav2_", "opennav_docking_")
_IN_PACKAGE = re.compile(r"\$\(find-pkg-share ([\w-]+)\)/(.+)")
#: Tags that name a node by their ID, and attributes of all nodes.
_EXPLICIT, _OF_ALL = ("Action", "Condition", "Control", "Decorator"), ("name", "ID")
_RECOVERY = "RecoveryNode"
_TREES = ("default_nav_to_pose_bt_xml", "default_nav_through_poses_bt_xml")
_BEHAVIORS, _TREE = "behavior_plugins", b"bt_xml"


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    sections = read_sections(context)
    yield from _invalid_trees(context, sections)
    yield from _missing_in_default_trees(context, sections)
    for section in whole_sections(sections):
        yield from _relative_trees(section)


def _invalid_trees(context: Context, sections: list[NodeParameters]) -> Findings:
    """Trees that cannot be read, or have nodes, ports or children that Nav2 does not have."""
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
        message = f"bt_navigator does not load the tree: unknown node '{name}'{hint_for(suggested)}"
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


def _missing_in_default_trees(context: Context, sections: list[NodeParameters]) -> Findings:
    """What the default trees of the navigator call and no server offers."""
    navigators = [node for node in sections if node.name == _NAVIGATOR]
    is_default = all(node.values.keys().isdisjoint(_TREES) for node in navigators)
    if len(navigators) != 1 or not is_default or _TREE in context.source.data:
        return
    called: dict[str, str] = data("nodes")["default_trees"]
    for parameter, names in called.items():
        servers = [node for node in sections if parameter in node.values]
        listed = scalars(servers[0].values[parameter]) if len(servers) == 1 else []
        missing = [name for name in names.split() if name not in {value.text for value in listed}]
        if listed and missing:
            stops = "stops" if parameter == _BEHAVIORS else "aborts its goals"
            yield Finding(
                listed[0].span,
                f"'bt_navigator' {stops}: its default behaviour tree calls '{missing[0]}', which "
                f"is not in {parameter}",
                f"add {missing[0]}, or set {_TREES[0]} to a tree without it",
                severity=Severity.WARNING,
            )


def _relative_trees(node: NodeParameters) -> Findings:
    """Behaviour trees without a directory, which the navigator does not find."""
    for key in _TREES if node.name == _NAVIGATOR else ():
        value = scalar(node.values, key)
        text = value.text if value else ""
        is_file = text.endswith(".xml") and "$" not in text
        if value and is_file and not os.path.isabs(text):
            yield Finding(
                value.span,
                f"'{node.name}' does not find '{text}': {key} is not the full path of a file",
                "write $(find-pkg-share PACKAGE)/PATH, or omit it for the default tree",
                severity=Severity.WARNING,
            )
