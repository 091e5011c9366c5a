"""References to links and joints that remain where an argument removes their definitions."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import lru_cache

from urdfkit.core.nested_intervals import NestedIntervals
from urdfkit.lint.rules import Context, Finding, Findings, Location, Related, Severity
from urdfkit.text.comments import blank_comments
from urdfkit.text.document import Attribute, Element
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver

#: Number of boolean arguments whose other value is tried.
_MAX_ARGUMENTS = 8
_OTHER = {"true": "false", "false": "true"}
_TAG = re.compile(rb"""<(/?)xacro:(if|unless)\b((?:[^<>"']|"[^"]*"|'[^']*')*?)(/?)>""")
_VALUE = re.compile(rb"""\bvalue\s*=\s*(["'])(.*?)\1""", re.DOTALL)
#: Conditions that depend on the environment of a robot, not on its parts.
_OF_SIMULATION = re.compile(r"gazebo|gz|ign|sim|^if true$", re.IGNORECASE)


def forgotten_conditions(context: Context) -> Findings:
    """References that break if an argument has its other boolean value."""
    booleans = _booleans(context)
    root = context.document.root
    # The reference of a name in one file may be right, and that in another file wrong.
    suspects = {_key(attribute) for attribute in _suspects(context)} if booleans else set()
    harmless = _harmless(context.source, context.resolver)
    for argument, value in booleans if suspects else ():
        tried = (argument, value, frozenset(suspects))
        if tried in harmless:
            continue
        other = context.expanded_with({**context.arguments, argument: value})
        if other is None:
            continue
        names = {at.value for at in _definitions(other.root)}
        lost = {key for key in suspects if key[0] not in names}
        if not lost:
            harmless.add(tried)
        blocks: dict[object, list[Attribute]] = {}
        for attribute in _references(other.root) if lost else ():
            if _key(attribute) in lost:
                blocks.setdefault(_block(attribute), []).append(attribute)
        for first, *more in blocks.values():
            yield _finding(root, first, len(more), f"{argument} is {value}")
        suspects -= lost


@lru_cache(maxsize=16)
def _harmless(
    source: Source, resolver: Resolver
) -> set[tuple[str, str, frozenset[tuple[str, str]]]]:
    """The arguments of a file, with a value and the suspects, that removed no definition.

    A robot that is checked with several sets of arguments needs no second expansion for each.
    """
    return set()


def _booleans(context: Context) -> list[tuple[str, str]]:
    """The boolean arguments, each with its other value."""
    defaults = context.xacro.defaults
    values = {name: context.arguments.get(name, text) for name, text in defaults.items()}
    others = [(name, _OTHER.get(text.strip().lower())) for name, text in values.items()]
    return [(name, other) for name, other in others if other][:_MAX_ARGUMENTS]


def _suspects(context: Context) -> Iterator[Attribute]:
    """References with fewer conditions than the definition of the same name.

    Those of another package are for one robot of several, as those of a MoveIt configuration.
    """
    root, package = context.document.root, context.resolver.packages.enclosing
    definitions = {at.value: at.element for at in _definitions(root)}
    defined = {name: _conditions(element) for name, element in definitions.items()}
    if not any(defined.values()):
        return
    for attribute in _references(root):
        needed = defined.get(attribute.value)
        if needed and _conditions(attribute.element) < needed:
            user, owner = _path(attribute.element), _path(definitions[attribute.value])
            if user == owner or package(user) == package(owner):
                yield attribute


def _key(attribute: Attribute) -> tuple[str, str]:
    """The name, and the file that refers to it."""
    return attribute.value, _path(attribute.element)


def _path(element: Element) -> str:
    return element.span.source.path


def _definitions(root: Element) -> Iterator[Attribute]:
    for element in root.children:
        if element.tag in ("link", "joint") and "name" in element.attributes:
            yield element.attributes["name"]


def _references(root: Element) -> Iterator[Attribute]:
    """The names of links and joints that joints, ros2_control and Gazebo require."""
    for element in root.children:
        keys = {"joint": ("parent", "child", "mimic"), "ros2_control": ("joint",)}
        for child in element.children if element.tag in keys else ():
            key = {"mimic": "joint", "joint": "name"}.get(child.tag, "link")
            if child.tag in keys[element.tag] and key in child.attributes:
                yield child.attributes[key]
        if element.tag == "gazebo" and "reference" in element.attributes and element.children:
            yield element.attributes["reference"]


def _conditions(element: Element) -> frozenset[str]:
    """The conditions around an element and around the calls that led to it."""
    calls = element.frame.outwards() if element.frame else ()
    places = [element.span, *(frame.call.span for frame in calls)]
    return frozenset(
        condition for place in places for condition in _in_source(place.source).around(place.start)
    )


@lru_cache(maxsize=64)
def _in_source(source: Source) -> NestedIntervals[str]:
    """The conditions of a file, such as ``if ${with_camera}``."""
    conditions: list[tuple[int, int, str]] = []
    opened: list[tuple[int, str]] = []
    for tag in _TAG.finditer(bytes(blank_comments(source.data))):
        if tag.group(1):
            if opened:
                start, text = opened.pop()
                if not _OF_SIMULATION.search(text):
                    conditions.append((start, tag.end(), text))
        elif not tag.group(4):
            value = _VALUE.search(tag.group(3))
            text = value.group(2).decode("utf-8", "replace").strip() if value else ""
            opened.append((tag.start(), f"{tag.group(2).decode()} {text}"))
    return NestedIntervals(conditions)


def _block(attribute: Attribute) -> object:
    """Key of the references that one finding reports."""
    element = attribute.element
    return attribute.value if element.tag == "gazebo" else id(element.parent)


def _finding(root: Element, attribute: Attribute, more: int, condition: str) -> Finding:
    """Finding about a reference to a missing link or joint.

    Args:
        more: the number of other such references in the same block.
    """
    element, name = attribute.element, attribute.value
    defined = next(at for at in _definitions(root) if at.value == name)
    is_gazebo = element.tag == "gazebo"
    block = "joint" if element.tag in ("parent", "child", "mimic") else element.tag
    others = f"; {more} more in the same block" if more and not is_gazebo else ""
    outcome = ": Gazebo ignores the block" if is_gazebo else ""
    kind = defined.element.tag
    return Finding(
        Location(attribute.span, element.frame),
        f"{kind} '{name}' does not exist if {condition}, but <{element.tag}> refers to it{others}"
        f"{outcome}",
        f"put the <{block}> under the same condition as {kind} '{name}'",
        related=(Related(defined.span, "it is defined here"),),
        severity=Severity.INFO if is_gazebo else None,
    )
