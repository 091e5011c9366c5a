"""The arguments that a launch file accepts."""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Iterator
from functools import lru_cache

from urdfkit.core.record import Record
from urdfkit.ros.launch.calls import argument, called
from urdfkit.ros.launch.markup import parsed
from urdfkit.text import python_source
from urdfkit.text.document import Element
from urdfkit.text.python_source import CACHE_SIZE
from urdfkit.text.source import Source

#: Actions that declare an argument, of launch and of packages such as moveit_configs_utils.
_DECLARE = re.compile(r"Declare\w*Arg\w*$")
#: Modules whose functions declare nothing.
_PLAIN = frozenset(sys.stdlib_module_names) | frozenset(
    "ament_index_python launch launch_param_builder launch_ros launch_xml lifecycle_msgs "
    "moveit_configs_utils nav2_common numpy rclpy xacro yaml".split()
)


class Signature(Record):
    """The arguments of a launch file."""

    required: frozenset[str]  # names of arguments that must be passed
    optional: frozenset[str]  # names of other arguments
    imports_plainly: bool  # False if functions of other modules may declare more
    is_plain: bool  # True if the file itself declares no other arguments
    includes: bool  # True if it includes other files, which may accept more

    @property
    def names(self) -> frozenset[str]:
        return self.required | self.optional

    @property
    def is_whole(self) -> bool:
        """True if it accepts no other arguments."""
        return self.is_plain and not self.includes


#: A use of an argument in XML.
USE = re.compile(r"\$\((?:arg|var)\s+['\"]?([^\s()$'\"]+)['\"]?\s*\)")

_UNKNOWN = Signature(frozenset(), frozenset(), False, False, False)


@lru_cache(CACHE_SIZE)
def signature(source: Source) -> Signature:
    """The arguments of a launch file; unknown if it cannot be read."""
    if source.path.endswith(".py"):
        try:
            tree = python_source.parse(source.data)
        except SyntaxError:
            return _UNKNOWN
        return of_python(tree)
    document, _ = parsed(source)
    if document is None or document.root.tag != "launch":
        return _UNKNOWN
    required: set[str] = set()
    optional: set[str] = set()
    for element in arguments_in(document.root):
        fixed = {"default", "value", "if", "unless"} & set(element.attributes)
        (optional if fixed else required).add(element.get("name") or "")
    used = _used(document.root)
    optional |= required - used
    includes = any(element.tag == "include" for element in document.root.walk())
    return Signature(frozenset(required & used), frozenset(optional), True, True, includes)


def arguments_in(root: Element) -> Iterator[Element]:
    """The declarations of arguments in XML, without those that an ``<include>`` passes."""
    for element in root.walk():
        inside = element.parent.tag if element.parent else ""
        if element.tag in ("arg", "let") and inside != "include":
            yield element


def _used(root: Element) -> set[str]:
    """The arguments that a launch file uses without a condition, and so requires."""
    used: set[str] = set()
    stack = [root]
    while stack:
        element = stack.pop()
        conditions = [element.attributes[n] for n in ("if", "unless") if n in element.attributes]
        for attribute in conditions or element.attributes.values():
            used.update(USE.findall(attribute.value))
        if not conditions:
            stack += element.children
    return used


def of_python(tree: ast.Module) -> Signature:
    """The arguments that a Python launch file declares."""
    required: set[str] = set()
    optional: set[str] = set()
    imports_plainly = is_plain = _imported(tree) <= _PLAIN
    includes = False
    for node in python_source.nodes(tree):
        if not isinstance(node, ast.Call):
            continue
        name = called(node)
        includes = includes or name == "IncludeLaunchDescription"
        if not declares(node):
            continue
        word = python_source.string(argument(node, 0, "name"))
        if word is None:
            is_plain = False
            continue
        keywords = {keyword.arg for keyword in node.keywords}
        # LAU033 reports `default`, which was meant to be one.
        has_default = not keywords.isdisjoint(("default_value", "default", "condition", None))
        has_default = has_default or len(node.args) > 1
        is_required = name == "DeclareLaunchArgument" and not has_default
        (required if is_required else optional).add(word)
    return Signature(frozenset(required), frozenset(optional), imports_plainly, is_plain, includes)


def declares(call: ast.Call) -> bool:
    """True for an action that creates a launch configuration."""
    name = called(call)
    return name == "SetLaunchConfiguration" or bool(_DECLARE.match(name))


def _imported(tree: ast.Module) -> set[str]:
    """The top-level names of the modules that a program imports."""
    names: set[str] = set()
    for node in python_source.nodes(tree):
        if isinstance(node, ast.Import):
            names.update(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            names.add(node.module or "." if node.level == 0 else ".")
    return {name.partition(".")[0] for name in names}
