"""The format of start tags: attributes in a fixed order, on as few lines as possible."""

import re
from collections.abc import Iterator
from functools import cache

from urdfkit.text import schema
from urdfkit.text.editing.edits import STEP
from urdfkit.text.tokens import Token

MACRO = "xacro:macro"
#: First attributes of xacro tags; the order for URDF tags comes from its grammar.
_XACRO_ORDER = {
    MACRO: ("name", "params"),
    "xacro:property": ("name", "value"),
    "xacro:arg": ("name", "default"),
    "xacro:include": ("filename",),
}
#: The upper triangle of the inertia tensor; one line for each row of the matrix.
_TENSOR = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")


def start_tag(token: Token, close: str, indent: str, width: int, *, is_foreign: bool) -> str:
    """A formatted start tag, its further lines aligned with its first attribute.

    Args:
        close: its end, ``>`` or ``/>``.
        indent: spaces before it, which the result does not contain.
        width: columns of a line.
        is_foreign: True for elements of other programs, whose attributes keep their order.
    """
    pairs = list(_attributes(token, is_foreign=is_foreign))
    attributes = [f"{name}={value}" for name, value in pairs]
    one_line = " ".join((f"<{token.name}", *attributes)) + close
    if token.name == MACRO:
        one_line = one_line.replace("\n", " ")
    if not attributes or len(indent) + len(one_line) <= width:
        return one_line
    hang = len(indent) + len(token.name) + 2
    if hang > width // 2:
        hang = len(indent) + 2 * len(STEP)
    first = f"{indent}<{token.name} "
    available = width - len(close)
    if token.name.startswith("xacro:") and token.name not in _XACRO_ORDER:
        rows = [[attribute] for attribute in attributes]  # the parameters of a macro call
    elif tuple(name for name, _ in pairs) == _TENSOR:
        rows = [attributes[:3], attributes[3:5], attributes[5:]]
    else:
        if token.name == MACRO:
            attributes = [_wrapped(name, value, hang, available) for name, value in pairs]
        rows = _rows(attributes, len(first), hang, available)
    lines = [" ".join(row) for row in rows]
    return (first + f"\n{' ' * hang}".join(lines)).lstrip() + close


def _attributes(token: Token, *, is_foreign: bool) -> Iterator[tuple[str, str]]:
    """Names and quoted values, in the order of the format."""
    pairs = token.pairs
    order = () if is_foreign else _order().get(token.name, ())
    known = sorted((pair for pair in pairs if pair[0] in order), key=lambda a: order.index(a[0]))
    for name, text in (*known, *(pair for pair in pairs if pair[0] not in order)):
        value = text
        if name in vectors() and not is_foreign:
            value = _vector(text)
        elif (token.name, name) == (MACRO, "params"):
            value = "\n".join(map(" ".join, parameters(text) or [[text]]))
        yield name, f"'{value}'" if '"' in value else f'"{value}"'


def _wrapped(name: str, value: str, hang: int, width: int) -> str:
    """An attribute of a macro; its parameters keep their lines, aligned with the first parameter.

    Args:
        hang: columns before it.
        width: columns of a line.
    """
    rows: list[str] = []
    hang += len(name) + 2
    for line in parameters(value[1:-1]) if name == "params" else ():
        rows.append("")
        for word in line:
            if rows[-1] and hang + len(f"{rows[-1]} {word}") >= width:
                rows.append("")
            rows[-1] += f" {word}" if rows[-1] else word
    text = f"\n{' ' * hang}".join(rows)
    return f"{name}={value[0]}{text}{value[0]}" if rows else f"{name}={value}"


def _rows(attributes: list[str], first: int, hang: int, width: int) -> list[list[str]]:
    """Attributes on as few lines as possible, with the same number on each line if they fit.

    Args:
        first: columns before the attributes of the first line.
        hang: columns before the attributes of the other lines.
        width: columns of a line.
    """
    rows = [attributes[:1]]
    for attribute in attributes[1:]:
        used = (first if len(rows) == 1 else hang) + len(" ".join(rows[-1]))
        if used + 1 + len(attribute) > width:
            rows.append([attribute])
        else:
            rows[-1].append(attribute)
    size = -(-len(attributes) // len(rows))
    even = [attributes[at : at + size] for at in range(0, len(attributes), size)]
    return even if all(max(first, hang) + len(" ".join(row)) <= width for row in even) else rows


_VECTOR = re.compile(r"\s*[-+.\deE]+(?:\s+[-+.\deE]+)*\s*")


def _vector(value: str) -> str:
    """Numbers separated by one space, each as written; any other value unchanged."""
    return " ".join(value.split()) if _VECTOR.fullmatch(value) else value


_PARAMETER = re.compile(r"""(?:'[^'\n]*'|"[^"\n]*"|[^\s'"])+""")


def parameters(value: str) -> list[list[str]]:
    """The parameters of a macro, line by line; empty if they cannot be split safely.

    White space between them has no meaning in xacro. White space in quotes belongs to a default,
    and a line end in quotes is a space.
    """
    lines = value.split("\n")
    if any(map(_rest, lines)):
        lines = [" ".join(lines)]
    if "&" in value or _rest(lines[0]):
        return []
    return [words for line in lines if (words := _PARAMETER.findall(line))]


def _rest(line: str) -> str:
    """The text that is not a parameter: an unclosed quote."""
    return _PARAMETER.sub("", line).strip()


@cache
def _grammars() -> dict[str, schema.Grammar]:
    return dict(schema.elements())


@cache
def container_tags() -> frozenset[str]:
    """Tags of URDF elements that contain elements, and no text that a parser reads."""
    return frozenset(tag for tag, grammar in _grammars().items() if grammar.children)


@cache
def _order() -> dict[str, tuple[str, ...]]:
    """The order of the known attributes of each tag."""
    return {tag: tuple(grammar.attributes) for tag, grammar in _grammars().items()} | _XACRO_ORDER


@cache
def vectors() -> frozenset[str]:
    """Names of attributes with several numbers."""
    return frozenset(
        name
        for grammar in _grammars().values()
        for name, rule in grammar.attributes.items()
        if schema.LENGTHS.get(rule.type, 1) > 1
    )
