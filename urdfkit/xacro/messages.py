"""Messages and help for xacro's errors."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from itertools import islice

from urdfkit.core.static_typing import Any
from urdfkit.core.suggest import did_you_mean
from urdfkit.text.source import STANDARD_INPUT, shown, why_unreadable
from urdfkit.xacro.definitions import Definitions
from urdfkit.xacro.dom import Node
from urdfkit.xacro.errors import CALLED_WITHOUT, NO_PARAMETER, BrokenYaml, MessageText
from urdfkit.xacro.expressions import Scope
from urdfkit.xacro.missing_files import missing_file
from urdfkit.xacro.undefined_names import UNDEFINED, undefined_name, unknown_macro

_FROM_STANDARD_INPUT = (
    "paths in standard input are relative to the current directory: run urdfkit there, or pass "
    "--stdin-filename FILE"
)

_NO_KEY = re.compile(r"The yaml dictionary has no key '([^']*)'")
_UNKNOWN_MACRO = re.compile(r"unknown macro name: (?:xacro:)?(\S+)")
_PARAMETER = re.compile(r'Invalid parameter "([^"]*)"')
_WITHOUT_VALUE = re.compile(r"Undefined parameters \[([^\]]*)\]")
_BLOCK_TOO_MANY = re.compile(r'Unused block "([^"]*)"')
_NO_BLOCK = re.compile(r'Undefined block "([^"]*)"')
_CONDITION = re.compile(r'Xacro conditional "(.*)" evaluated to "(.*)", which is not', re.DOTALL)
_UNCLOSED = re.compile(r"invalid expression: (\$[{(].*)", re.DOTALL)
#: Most characters of a value in a help.
_MAX_TEXT = 40


#: Operators of other languages in an expression, and those of Python.
_SIGNS = (
    (r"&&|\|\|", "write and, or, not: && and || are not Python"),
    (r"!(?!=)", "write not: ! is not Python"),
    (r"(?<![=!<>:])=(?!=)", "write == to compare"),
    (r"\?.*:", "write A if CONDITION else B: ? and : are not Python"),
)

#: Errors of tags and properties in the words of xacro, the message for each, and the help.
_OF_TAGS = (
    (
        r"xacro:arg: missing attribute 'default'",
        "<xacro:arg> has no 'default'",
        'add default="...", or delete the tag: $(arg NAME) then needs a value from outside',
    ),
    (r"(xacro:\w+): missing attribute '([\w:]+)'", r"<\1> has no '\2'", r'add \2="..."'),
    (
        r"circular variable definition: ([^\n]*)(?s:.*)",
        r"properties refer to one another: \1",
        "give one of them a value without the others",
    ),
    (
        r"Property names must be valid python identifiers: (.*)",
        r"'\1' cannot be the name of a property",
        "write letters, digits and _, and no digit first",
    ),
    (r"(\$\((\w+) \.\.\.\) takes one name, not \d+)", r"\1", r"write $(\2 NAME)"),
)
#: Errors of an expression that values of other names cause.
_OF_VALUES = (ArithmeticError, AttributeError, LookupError, TypeError, ValueError)
#: Most names whose values a help tells.
_MAX_NAMES = 4
_LARGE = 10**15

#: How xacro's error for a reserved name begins.
_DUNDER = "Property names must not start with double underscore"


def explain(defined: Definitions, error: BaseException, cause: BaseException) -> MessageText:
    """The message for an error of an expression, a call or a tag.

    Args:
        cause: the innermost error.
    """
    if isinstance(cause, FileNotFoundError) and cause.filename:
        missing = missing_file(os.fspath(cause.filename))
        is_relative = STANDARD_INPUT in defined.sources and not os.path.isabs(cause.filename)
        return missing._replace(help=_FROM_STANDARD_INPUT) if is_relative else missing
    if isinstance(cause, OSError) and cause.filename:
        path = os.fspath(cause.filename)
        reason, _, help = why_unreadable(path, cause).partition("; ")
        return MessageText(f"{shown(path)}: {reason}", help)
    if isinstance(cause, SyntaxError):
        help = next((help for sign, help in _SIGNS if re.search(sign, cause.text or "")), "")
        help = help or "write a valid Python expression"
        return MessageText(f"not an expression: {cause.msg}", help)
    if isinstance(cause, BrokenYaml):
        where = cause.span.source.path
        return MessageText(f"{where} is not valid YAML: {cause.reason}", "correct the file")
    if isinstance(cause, KeyError):
        return MessageText(f"key {cause} does not exist", "correct the key, or its source")
    text = str(cause).split("\nwhen evaluating expression")[0].strip()
    if isinstance(cause, AttributeError) and (message := _attribute_error(text, cause)):
        return message
    if isinstance(cause, NameError) and (match := UNDEFINED.search(text)):
        return undefined_name(defined, text, match.group(1))
    if match := _UNKNOWN_MACRO.search(text):
        return unknown_macro(defined, match.group(1))
    if help := _help_for(text, cause):
        return MessageText(text, help)
    message = _call_error(text, macro_of(error)) or _tag_error(text)
    return message or MessageText(text.replace("\n", "; ") or type(cause).__name__)


def _tag_error(text: str) -> MessageText | None:
    """The message for an error of a tag or a property."""
    for pattern, message, help in _OF_TAGS:
        if match := re.fullmatch(pattern, text):
            return MessageText(match.expand(message), match.expand(help))
    return None


def _attribute_error(text: str, cause: AttributeError) -> MessageText | None:
    """The message for a missing key of a YAML file, or a scope without a parent."""
    if match := _NO_KEY.match(text):
        hint = did_you_mean(match.group(1), _keys(cause))
        return MessageText(text, f"correct the key, or add it to the YAML file{hint}")
    if "'_setitem'" in text:
        message = 'scope="parent" is used outside of a macro, where there is no parent scope'
        return MessageText(message, "delete the scope")
    return None


def _keys(cause: AttributeError) -> list[str]:
    """The keys of the dictionary that raised an error."""
    trace = cause.__traceback__
    while trace is not None and trace.tb_next is not None:
        trace = trace.tb_next
    raised_by = trace.tb_frame.f_locals.get("self") if trace else None
    return [str(key) for key in raised_by] if isinstance(raised_by, dict) else []


def _help_for(text: str, cause: BaseException) -> str:
    """How to fix a reserved name, or an expression that fails with its values; else empty."""
    if text.startswith(_DUNDER):
        return "rename the property where it is defined and used"
    if not isinstance(cause, _OF_VALUES):
        return ""
    values = dict(islice(_values_in(cause), _MAX_NAMES))
    if isinstance(cause, TypeError) and " for ^: " in text:
        return "write ** for a power; ^ is not a power in Python"
    if isinstance(cause, TypeError) and "operand" in text and "'str'" in text:
        texts = (f"'{name}' is {value}, which is text" for name, value in values.items())
        which = next(
            (told for told in texts if told.endswith("', which is text")), "a value is text"
        )
        return (
            f"{which}: correct its definition (a number has a decimal point, and no comma or "
            "unit), or write float(...)"
        )
    told = ", ".join(f"'{name}' is {value}" for name, value in values.items())
    return f"{told}: correct the definition or the expression" if told else ""


def _values_in(cause: BaseException) -> Iterator[tuple[str, str]]:
    """The names in the expression that failed with their values, as far as these are short."""
    trace = cause.__traceback__
    while trace is not None:
        scope = trace.tb_frame.f_globals
        if isinstance(scope, Scope):
            for name, value in scope.known_values(trace.tb_frame.f_code.co_names):
                if isinstance(value, str):
                    yield name, f"'{value[:_MAX_TEXT]}'"
                elif isinstance(value, float) or (isinstance(value, int) and abs(value) < _LARGE):
                    yield name, str(value)
        trace = trace.tb_next


def macro_of(error: BaseException) -> Any:
    """The macro whose call failed, or None."""
    macros = getattr(error, "macros", None) or [None]
    return macros[0] if isinstance(getattr(macros[0], "body", None), Node) else None


def _call_error(text: str, macro: Any) -> MessageText | None:
    """The message for wrong parameters or blocks of a call, a wrong condition or bracket."""
    owner = f"macro '{macro.body.getAttribute('name')}'" if macro is not None else "the macro"
    params: list[str] = list(macro.params) if macro is not None else []
    if match := _PARAMETER.search(text):
        name = match.group(1)
        if any(name in param.split(",") for param in params if "," in param):
            words = " ".join(params).replace(",", " ").split()
            message = f"{owner} {NO_PARAMETER} '{name}': its params are separated by commas"
            return MessageText(message, f'write params="{" ".join(words)}"')
        available = ", ".join(params) or "none"
        help = f"it has: {available}{did_you_mean(name, params)}"
        return MessageText(f"{owner} {NO_PARAMETER} '{name}'", help)
    if match := _WITHOUT_VALUE.search(text):
        names = match.group(1).replace(",", ", ")
        help = "pass every parameter without a default"
        numbers = [param for param in params if param[:1].isdigit() or param[:1] in "-+."]
        if numbers:  # the words of a default, which ends at the first space
            help = f"write the default with '{numbers[0]}' in single quotes: name:='0 0 0'"
        return MessageText(f"{owner} {CALLED_WITHOUT} {names}", help)
    if text.startswith("Not enough blocks"):
        blocks = ", ".join(param for param in params if param.startswith("*"))
        help = f"add an element for each of {blocks} to the call"
        return MessageText(
            f"{owner} is called without an element for {blocks or 'its block'}", help
        )
    if match := _BLOCK_TOO_MANY.search(text):
        help = "delete it, or add a parameter with * to the macro"
        return MessageText(f"{owner} has no block parameter for <{match.group(1)}>", help)
    if match := _NO_BLOCK.search(text):
        help = "insert_block takes the name of a parameter with *, or of a property with elements"
        return MessageText(f"block '{match.group(1)}' is not defined", help)
    if match := _CONDITION.search(text):
        message = f"the condition is '{match.group(2)[:60]}', neither true nor false"
        return MessageText(message, "write true or false")
    if match := _UNCLOSED.search(text):
        bracket = "}" if match.group(1)[1] == "{" else ")"
        help = f"write the missing '{bracket}'"
        return MessageText(f"'{match.group(1)[:60]}' is never closed", help)
    return None
