"""Tags and attributes of launch files in XML, of ROS 1 and of ROS 2: ``catalog/launch.json``."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from functools import cache

from urdfkit.core.record import Record
from urdfkit.core.suggest import TYPO, is_typo, nearest
from urdfkit.ros.catalog import data, record
from urdfkit.ros.launch.components import wrong_component
from urdfkit.text.diagnostic import Problem, Severity
from urdfkit.text.document import Attribute, CallFrame, Element

#: Substitutions of the other ROS version.
_SUBSTITUTIONS = {
    1: {"find-pkg-share": "find", "var": "arg"},
    2: {"find": "find-pkg-share", "arg": "var", "optenv": "env"},
}
_CONDITIONS = frozenset(("if", "unless"))
#: Tags that apply to the nodes after them.
SCOPES = (
    "push-ros-namespace", "push_ros_namespace", "set_parameter", "set_parameters_from_file",
    "set_remap", "set_use_sim_time",
)  # fmt: skip
#: Tags of a node in ROS 2, and what applies to several nodes.
_OF_NODES = {"remap": "set_remap from=... to=.../", "param": "set_parameter name=... value=.../"}
#: Tags that those apply to.
_STARTING = ("group", "include", "load_composable_node", "node", "node_container")
#: The tags in a node, where others are unknown.
_CHILDREN: dict[int, dict[str, tuple[str, ...]]] = {
    1: {"node": ("remap", "param", "rosparam", "env")},
    2: {"node": ("remap", "param", "env"), "composable_node": ("remap", "param", "extra_arg")},
}
#: An argument in an expression of ROS 1.
_EVAL_OF_ROS_1 = re.compile(r"""\$\(eval\b[^$]*?\barg\(\s*["'](\w+)["']\s*\)""")

#: Attributes of namespaces, of rosmon, and for separators of lists in ROS 2.
_OF_OTHERS = re.compile(r":|^rosmon-|-sep$")


class _Dialect(Record):
    """The tags and attributes of a ROS version."""

    attributes: dict[str, str]  # of each tag; ``!`` follows required attributes
    words: dict[str, str]  # valid values of attributes, by ``tag/@name``
    #: Names of attributes of the other ROS version, by ``tag/@name``.
    translated: dict[str, str]
    marks: tuple[str, ...]  # texts by which a file is recognised

    def names(self, tag: str) -> set[str]:
        return {word.rstrip("!") for word in self.attributes.get(tag, "").split()}


@cache
def _dialect(ros: int) -> _Dialect:
    return record(_Dialect, data("launch")[f"ros{ros}"])


def dialect(root: Element, of_package: Callable[[], int | None]) -> int | None:
    """The ROS version of a launch file, 1 or 2; None if unknown.

    A file with tags of both is one that is not yet changed to the version of its package; if that
    is unknown, the version of most of its tags counts.
    """
    votes = {1: 0, 2: 0}
    for element in root.walk():
        values = [attribute.value for attribute in element.attributes.values()]
        for ros, other in ((1, 2), (2, 1)):
            own, tag = _dialect(ros), element.tag
            names = own.names(tag) - _dialect(other).names(tag)
            votes[ros] += tag in own.attributes and tag not in _dialect(other).attributes
            votes[ros] += len(names.intersection(element.attributes))
            votes[ros] += sum(mark in value for value in values for mark in own.marks)
    likely = None if votes[1] == votes[2] else max(votes, key=lambda ros: votes[ros])
    return of_package() or likely if all(votes.values()) or likely is None else likely


def wrong_tags(element: Element, ros: int, frame: CallFrame | None) -> Iterator[Problem]:
    """Unknown, missing and invalid attributes of an element, and an unknown tag."""
    own = _dialect(ros)
    row = own.attributes.get(element.tag)
    if row is None:
        yield from _unknown_tag(element, ros, frame)
        return
    for word in row.split():
        name = word.rstrip("!")
        if word.endswith("!") and not _is_written(element, name, own):
            message = f"<{element.tag}> has no {name}"
            help = f'write {name}="..."'
            yield Problem("LAU010", element.span, message, help, frame, severity=Severity.ERROR)
    if element.tag == "composable_node":
        yield from _component(element, frame)
    if element.tag != "launch":  # whose attributes are not read
        yield from _misplaced(element, frame) if ros == 2 else _given_twice(element, frame)
        yield from _attributes(element, ros, frame)


def _component(element: Element, frame: CallFrame | None) -> Iterator[Problem]:
    plugin = element.attributes.get("plugin")
    wrong = wrong_component(element.get("pkg"), plugin.value) if plugin is not None else None
    if plugin is not None and wrong:
        yield Problem("LAU038", plugin.span, *wrong, frame, severity=Severity.ERROR)


def _unknown_tag(element: Element, ros: int, frame: CallFrame | None) -> Iterator[Problem]:
    """A tag of the other ROS version, or a misspelt one."""
    other = data("launch")["moved_tags"][str(3 - ros)].get(element.tag)
    if other:
        message, help = f"ROS {ros} has no <{element.tag}>", f"write {other}"
        severity = Severity.ERROR if ros == 2 else Severity.WARNING
        yield Problem("LAU010", element.span, message, help, frame, severity=severity)
    elif suggested := nearest(element.tag, _dialect(ros).attributes, TYPO):
        message = f"unknown tag <{element.tag}>"
        yield Problem("LAU010", element.span, message, f"did you mean <{suggested}>?", frame)
    elif element.parent is not None and element.parent.tag in _CHILDREN[ros]:
        message = f"unknown tag <{element.tag}> in <{element.parent.tag}>"
        help = "write one of " + ", ".join(f"<{tag}>" for tag in _CHILDREN[ros][element.parent.tag])
        yield Problem("LAU010", element.span, message, help, frame)


def _attributes(element: Element, ros: int, frame: CallFrame | None) -> Iterator[Problem]:
    """Unknown attributes, and those whose value is not allowed."""
    own = _dialect(ros)
    known = own.names(element.tag)
    for attribute in element.attributes.values():
        name = attribute.name
        yield from _substitutions(attribute, ros, frame)
        path = f"{element.tag}/@{name}"
        yield from _condition(attribute, frame)
        words = own.words.get(path, "").split()
        if words and attribute.value.lower() not in words and "$" not in attribute.value:
            message = f"<{element.tag}>: {name} is '{attribute.value}'"
            yield Problem("LAU010", attribute.span, message, f"write {' or '.join(words)}", frame)
        if name in known or name in _CONDITIONS or _OF_OTHERS.search(name):
            continue
        suggested = own.translated.get(path) or nearest(name, known)
        known_list = "known attributes: " + ", ".join(sorted(known))
        help = f"did you mean {suggested}?" if suggested else known_list
        if suggested and not suggested.replace("-", "_").isidentifier():
            help = f"write {suggested}"
        message = f"unknown attribute '{name}' of <{element.tag}> in ROS {ros}"
        yield Problem("LAU010", attribute.span, message, help, frame)


def _misplaced(element: Element, frame: CallFrame | None) -> Iterator[Problem]:
    """What belongs to a node in ROS 2, or to an include, in another place."""
    parent = element.parent.tag if element.parent is not None else ""
    if parent in ("launch", "group", "include") and element.tag in _OF_NODES:
        message = f"<{element.tag}> is not in a <node>: ROS 2 stops at it"
        help = f"write <{_OF_NODES[element.tag]}>, or move it into the node"
        yield Problem("LAU010", element.span, message, help, frame, severity=Severity.ERROR)
    if parent in _CHILDREN[2] and element.tag not in _CHILDREN[2][parent]:
        message = f"unknown tag <{element.tag}> in <{parent}>: ROS 2 stops at it"
        words = ", ".join(f"<{tag}>" for tag in _CHILDREN[2][parent])
        help = "write <param>" if element.tag == "arg" else f"write one of {words}"
        yield Problem("LAU010", element.span, message, help, frame, severity=Severity.ERROR)
    yield from _without_value(element, frame)
    value = element.attributes.get("value")
    if element.tag == "arg" and parent in ("launch", "group") and value is not None:
        message = "<arg> has a value, but is not in an <include>: ROS 2 stops at it"
        help = "write default=..., or <let> for a value that callers do not change"
        yield Problem("LAU010", value.span, message, help, frame, severity=Severity.ERROR)


def _condition(attribute: Attribute, frame: CallFrame | None) -> Iterator[Problem]:
    """A condition with words around its substitution, which launch does not compare."""
    text = attribute.value
    outside = re.sub(r"\$\([^()]*\)", "", text)
    if (
        attribute.name in _CONDITIONS
        and outside.strip()
        and outside != text
        and "$(" not in outside
    ):
        message = f"<{attribute.element.tag}>: {attribute.name} is '{text}', not a boolean"
        help = "write the whole condition in $(eval ...)"
        yield Problem("LAU010", attribute.span, message, help, frame, severity=Severity.ERROR)


def _without_value(element: Element, frame: CallFrame | None) -> Iterator[Problem]:
    """An argument of an include in ROS 2 without a value."""
    parent = element.parent
    is_passed = element.tag == "arg" and parent is not None and parent.tag == "include"
    if is_passed and "value" not in element.attributes:
        message = "<arg> of an <include> has no value"
        help = "write value=" + ("... in place of default=..." if element.get("default") else "...")
        yield Problem("LAU010", element.span, message, help, frame, severity=Severity.ERROR)


def _given_twice(element: Element, frame: CallFrame | None) -> Iterator[Problem]:
    """An argument with a value and a default, which roslaunch rejects."""
    default = element.attributes.get("default")
    if element.tag == "arg" and default is not None and "value" in element.attributes:
        message = f"argument '{element.get('name')}' has a value and a default"
        help = "keep the default if callers may set it, else the value"
        yield Problem("LAU010", default.span, message, help, frame, severity=Severity.ERROR)


def _substitutions(attribute: Attribute, ros: int, frame: CallFrame | None) -> Iterator[Problem]:
    """Substitutions that exist only in the other ROS version."""
    for other, own in _SUBSTITUTIONS[ros].items() if "$(" in attribute.value else ():
        if f"$({other} " in attribute.value:
            message, help = f"ROS {ros} has no $({other} ...)", f"write $({own} ...)"
            at = attribute.span
            yield Problem("LAU010", at, message, help, frame, severity=Severity.ERROR)
    if ros == 2 and (match := _EVAL_OF_ROS_1.search(attribute.value)):
        message = "ROS 2's $(eval ...) has no arg(), but takes the text of other substitutions"
        help = f"write $(var {match.group(1)}) in the expression, in quotes if it is a text"
        at = attribute.span
        yield Problem("LAU010", at, message, help, frame, severity=Severity.ERROR)


def without_effect(parent: Element, frame: CallFrame | None) -> Iterator[Problem]:
    """Tags of ROS 2 that apply to the nodes after them, behind the last node."""
    children = list(parent.children)
    while children and children[-1].tag in SCOPES:
        last = children.pop()
        if any(child.tag in _STARTING for child in children):
            message = f"<{last.tag}> has no effect: it applies to the tags after it"
            yield Problem("LAU037", last.span, message, "move it above the nodes", frame)


def _is_written(element: Element, name: str, own: _Dialect) -> bool:
    """True if an attribute, or a typo of it, which is reported instead, exists."""
    return any(
        other == name
        or own.translated.get(f"{element.tag}/@{other}") == name
        or is_typo(other, name)
        or nearest(other, [name], TYPO)
        for other in element.attributes
    )
