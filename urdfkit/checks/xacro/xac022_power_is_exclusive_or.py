"""An expression has `^` where a power is meant.

Expressions are Python, where `^` is the exclusive or of two integers: `${2^3}` is 1, not 8, and
`${10^-3}` is -9. With a fraction on one side xacro refuses it; with integers on both, the robot
gets the wrong number and nobody is told. A power is written `**`.

Sources:
    xacro, math expressions: https://github.com/ros/xacro/wiki#math-expressions
    Python, binary bitwise operations: https://docs.python.org/3/reference/expressions.html#binary-bitwise-operations
    measured: none of 3800 public xacro files has it.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Location, Need, rule
from urdfkit.text.diagnostic import Edit, Fix, Severity
from urdfkit.text.source import Source, Span

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="size" value="2"/>
  <link name="floor">
    <visual>
      <geometry><box size="${size^3} 1 0.1"/></geometry>
    </visual>
  </link>
</robot>
"""
FIXED = GOOD = BAD.replace("size^3", "size**3")

_COMMENT = rb"(?s)<!--.*?-->"
_EXPRESSION = rb"\$\{([^{}]*\^[^{}]*)\}"


@rule(
    "XAC022",
    "power-is-exclusive-or",
    Severity.WARNING,
    needs=(Need.XACRO,),
    help="write ** for a power",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for source in subject.xacro.sources:
        if b"^" in source.data:
            yield from _in_source(source)


def _in_source(source: Source) -> Iterator[Finding]:
    data = re.sub(_COMMENT, lambda match: b" " * len(match.group()), source.data)
    for match in re.finditer(_EXPRESSION, data):
        expression = match.group(1).decode("utf-8", "replace")
        if _has_power(expression):
            signs = (place.start() for place in re.finditer(rb"\^", match.group(1)))
            edits = [
                Edit(Span(source, at, at + 1), "**") for at in map(match.start(1).__add__, signs)
            ]
            yield Finding(
                Location(Span(source, match.start(), match.end())),
                f"the ^ in {_as_read(expression)} is an exclusive or, and no power",
                fix=Fix(f"write {expression.replace('^', '**')}", tuple(edits)),
            )


def _as_read(expression: str) -> str:
    """Without the escapes of XML."""
    from html import unescape  # whose table takes 1 ms to load

    return unescape(expression).strip()


def _has_power(expression: str) -> bool:
    """True for a ``^`` with an integer over 1, or below 0, on its right."""
    try:
        tree = ast.parse(_as_read(expression), mode="eval")
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return False
    return any(
        isinstance(node, ast.BinOp) and isinstance(node.op, ast.BitXor) and _is_exponent(node)
        for node in ast.walk(tree)
    )


def _is_exponent(power: ast.BinOp) -> bool:
    first = power.right
    while isinstance(first, ast.BinOp):  # of 2^3 * 4, whose right side is a product
        first = first.left
    try:
        value = ast.literal_eval(first)
    except ValueError:
        return False
    return type(value) is int and value not in (0, 1)
