"""A plain URDF holds an expression that only xacro understands.

`${...}` and `$(...)` are xacro's. In a plain URDF nobody replaces them: numbers become unreadable
and names keep the text as it stands. The file is a xacro without saying so, or was saved before it
was expanded.

Sources:
    xacro: https://wiki.ros.org/xacro
    measured: 17 of 676 public .urdf files are a xacro
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Severity
from urdfkit.text.grammar import is_expression

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = '<link name="${side}_arm"/>'
GOOD = '<link name="left_arm"/>'


#: The substitutions that xacro has.
_SUBSTITUTION = re.compile(r"\$\(\s*(?:anon|arg|cwd|dirname|env|eval|find|optenv)\b")


@rule(
    "XAC003",
    "unexpanded-expression",
    Severity.ERROR,
    help="expand the file with xacro first; a xacro declares "
    'xmlns:xacro="http://www.ros.org/wiki/xacro"',
)
def check(subject: Subject) -> Iterator[Finding]:
    data = subject.source.data
    if subject.reading.xacro or (b"${" not in data and b"$(" not in data):
        return
    for element in subject.document.root.walk():
        for attribute in element.attributes.values():
            if is_expression(attribute.value):
                yield Finding(attribute, f'{attribute.name}="{attribute.value}" is not expanded')
        if not element.children and _is_of_xacro(element.text):
            yield Finding(element, f"<{element.tag}>{element.text.strip()} is not expanded")


def _is_of_xacro(text: str) -> bool:
    """False for ``$(name)`` alone, a blank in a plugin's settings that a launch file fills in."""
    return is_expression(text) and ("${" in text or _SUBSTITUTION.search(text) is not None)
