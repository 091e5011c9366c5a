"""Types of ROS 2 parameters in a YAML file.

Parameters are typed when a node starts: an integer is rejected if the node declares a ``double``,
and quotes turn every value into a string.
Source: ``rcl_yaml_param_parser/src/parse.c`` of ros2/rcl.
"""

import re

from urdfkit.text.located_yaml import Node, Value, is_template

#: The types in the words of messages.
TYPES = {
    "bool": "true or false",
    "int": "an integer",
    "double": "a number with a decimal point",
    "string": "a string",
    "bool_array": "a list of booleans",
    "int_array": "a list of integers",
    "double_array": "a list of numbers with a decimal point",
    "string_array": "a list of strings",
}
_BOOLS = frozenset(
    "y Y yes Yes YES n N no No NO true True TRUE false False FALSE on On ON off Off OFF".split()
)
#: A word that a launch file of Nav2 replaces (``value_rewrites``), such as KEEPOUT_ZONE_ENABLED.
_REPLACED = re.compile(r"[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+$")
_INT = re.compile(r"[-+]?(0[xX][0-9a-fA-F]+|[0-9]+)$")
_DOUBLE = re.compile(
    r"[-+]?(([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?|\.?(inf|nan|infinity))$", re.IGNORECASE
)


def type_of(node: Value | list[Node]) -> str | None:
    """``bool``, ``int``, ``double``, ``string``, or an array of them; None if it is unknown.

    Empty, tagged, substituted and replaced values, and lists of mixed types, are unknown.
    """
    if isinstance(node, Value):
        return _of_scalar(node)
    kinds = {type_of(item) if isinstance(item, Value) else None for item in node}
    (kind,) = kinds if len(kinds) == 1 else (None,)
    return None if kind is None else f"{kind}_array"


def _of_scalar(value: Value) -> str | None:
    if value.tag or not value.text or is_template(value.text) or _REPLACED.match(value.text):
        return None
    if value.span.text[:1] in ("'", '"', "|", ">"):
        return "string"
    if value.text in _BOOLS:
        return "bool"
    if _INT.match(value.text):
        return "int"
    return "double" if _DOUBLE.match(value.text) else "string"


def is_not_positive(value: Value) -> bool:
    """True for a number that is zero or less."""
    number = number_of(value)
    return number is not None and number <= 0


def number_of(value: Value) -> float | None:
    """The number that a value is read as; None for other values."""
    if _of_scalar(value) not in ("int", "double") or value.text.lower().startswith("0x"):
        return None
    return float(value.text.lower().replace(".inf", "inf").replace(".nan", "nan"))


def correction(node: Node, expected: str) -> str:
    """A help text for a value that must have another type."""
    if isinstance(node, Value) and expected in ("double", "int"):
        try:
            number = float(node.text.replace(",", "."))
        except ValueError:
            pass
        else:
            if expected == "double":
                return f"write {number}"
            if number.is_integer():
                return f"write {int(number)}"
    return f"write {TYPES[expected]}"
