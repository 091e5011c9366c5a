"""Other values of the arguments of a launch file, which choose other nodes.

They are the choices that the file declares, and what its conditions compare an argument with.
"""

import ast
import re
from collections.abc import Iterator

from urdfkit.ros.launch import is_python
from urdfkit.ros.launch.calls import argument
from urdfkit.ros.launch.markup import parsed
from urdfkit.ros.launch.signature import arguments_in, declares
from urdfkit.text import python_source
from urdfkit.text.source import Source

#: Most other values, with each of which a launch file is read once more.
MAX_ALTERNATIVES = 4

_VALUE = r"['\"]([\w.-]+)\\?['\"]"
#: Comparisons of an argument with a text, in XML and in Python.
_COMPARED = (
    r"\$\((?:var|arg) '?(\w+)'?\)\\?['\"]?\s*==\s*\\?" + _VALUE,
    r"LaunchConfigurationEquals\(\s*['\"](\w+)['\"]\s*,\s*" + _VALUE,
    r"EqualsSubstitution\(\s*LaunchConfiguration\(\s*['\"](\w+)['\"]\s*\)\s*,\s*" + _VALUE,
    r"LaunchConfiguration\(\s*['\"](\w+)['\"]\s*\)\s*,\s*['\"]+\s*==\s*" + _VALUE,
)
_BOOLEANS = ("true", "false")


def alternatives(source: Source) -> list[tuple[str, str]]:
    """Names and values of arguments whose default is another value."""
    declared = {name: (default, values) for name, default, values in _declared(source)}
    text = source.data.decode("utf-8", "replace")
    compared = [pair for pattern in _COMPARED for pair in re.findall(pattern, text)]
    chosen = [(name, value) for name, (_, values) in declared.items() for value in values]
    found = dict.fromkeys(chosen + compared)
    others = [
        (name, value)
        for name, value in found
        if name in declared and value != declared[name][0] and value.lower() not in _BOOLEANS
    ]
    return others[:MAX_ALTERNATIVES]


def _declared(source: Source) -> Iterator[tuple[str, str, list[str]]]:
    """The arguments with a literal default: name, default and choices."""
    if is_python(source):
        yield from _of_python(source)
        return
    document, _ = parsed(source)
    for element in arguments_in(document.root) if document else ():
        default = element.get("default")
        if default is not None and element.tag == "arg":
            choices = [choice.get("value") or "" for choice in element.all("choice")]
            yield element.get("name") or "", default, choices


def _of_python(source: Source) -> Iterator[tuple[str, str, list[str]]]:
    try:
        tree = python_source.parse(source.data, source.path)
    except SyntaxError:
        return
    for call in python_source.nodes(tree):
        if isinstance(call, ast.Call) and declares(call):
            name = python_source.string(argument(call, 0, "name"))
            default = python_source.string(argument(call, 1, "default_value"))
            listed = argument(call, None, "choices")
            items = listed.elts if isinstance(listed, (ast.List, ast.Tuple)) else []
            choices = [text for item in items if (text := python_source.string(item))]
            if name and default is not None:
                yield name, default, choices
