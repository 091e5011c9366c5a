"""Substitutions of ROS 2 that compare, combine or choose texts, and expressions of Python.

Source: ``launch/substitutions`` of ros2/launch.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from urdfkit.xacro.budget import Budget, deadline
from urdfkit.xacro.expressions import evaluate as evaluate_in
from urdfkit.xacro.sandbox import Sandbox

#: Length of the longest result of an expression.
MAX_RESULT = 4096
#: The names in a ``PythonExpression``: of the module math, and the builtins that are used.
_NAMES = {name: value for name, value in vars(math).items() if not name.startswith("_")} | {
    builtin.__name__: builtin for builtin in (abs, bool, float, int, len, max, min, round, str)
}
#: Texts that YAML reads as booleans.
_BOOLEANS = {"true": True, "yes": True, "on": True, "false": False, "no": False, "off": False}
#: Texts that ``EqualsSubstitution`` compares as booleans.
_COMPARED = {"true": True, "1": True, "false": False, "0": False}


def evaluated(expression: str, names: Mapping[str, Any] = _NAMES) -> str | None:
    """The result of an expression of Python as text; None if it is unknown.

    It is evaluated in the sandbox of xacro's expressions.
    """
    try:
        result = evaluate_in(expression.strip(), names, Sandbox(Budget(deadline())))
    except Exception:  # an expression may raise any exception
        return None
    is_text = isinstance(result, (str, bool, int, float)) and len(str(result)) <= MAX_RESULT
    return str(result) if is_text else None


def computed(name: str, texts: Sequence[str | None]) -> str | None:
    """The result of a substitution; None if it is unknown.

    Args:
        name: as in a launch file of XML: ``equals``, ``if``.
        texts: its arguments; None if known only at run time.
    """
    compute = _SUBSTITUTIONS.get(name)
    try:
        return compute(*texts) if compute else None
    except TypeError:  # too many arguments, or too few
        return None


def _equals(left: str | None, right: str | None) -> str | None:
    if left is None or right is None:
        return None
    one, other = _COMPARED.get(left.lower()), _COMPARED.get(right.lower())
    if one is not None and other is not None:
        return _text(one is other)
    try:
        return _text(math.isclose(float(left), float(right)))
    except ValueError:
        return _text(left == right)


def _not(value: str | None) -> str | None:
    truth = _boolean(value)
    return None if truth is None else _text(not truth)


def _all(*values: str | None) -> str | None:
    return _decided(values, by=False)


def _any(*values: str | None) -> str | None:
    return _decided(values, by=True)


def _decided(values: Sequence[str | None], *, by: bool) -> str | None:
    """One such value decides; the other result needs all of them to be known."""
    truths = [_boolean(value) for value in values]
    if by in truths:
        return _text(by)
    return None if None in truths else _text(not by)


def _if(condition: str | None, value: str | None = "", otherwise: str | None = "") -> str | None:
    truth = _boolean(condition)
    return None if truth is None else value if truth else otherwise


def _boolean(text: str | None) -> bool | None:
    return _BOOLEANS.get((text or "").lower())


def _text(value: bool) -> str:
    return str(value).lower()


_SUBSTITUTIONS: dict[str, Callable[..., str | None]] = {
    "eval": lambda text: None if text is None else evaluated(text),
    "equals": _equals,
    "not-equals": lambda left, right: _not(_equals(left, right)),
    "not": _not,
    "and": _all,
    "or": _any,
    "all": _all,
    "any": _any,
    "if": _if,
}
