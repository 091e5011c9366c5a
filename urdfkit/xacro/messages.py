"""What xacro's errors mean and what to do about them."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from urdfkit.core import disk
from urdfkit.core.record import Record
from urdfkit.core.static_typing import Any
from urdfkit.core.suggest import SIMILAR_FILE, TYPO, did_you_mean, nearest
from urdfkit.text.comments import blank_comments
from urdfkit.text.schema import XACRO_TAGS
from urdfkit.text.source import STANDARD_INPUT, Span, shown, why_unreadable
from urdfkit.workspace.install_rules import is_expanded
from urdfkit.xacro.definitions import Definitions
from urdfkit.xacro.dom import Node
from urdfkit.xacro.errors import UNBUILT, BrokenYaml

#: Directories that a help lists.
_FEW = 10

_FROM_STANDARD_INPUT = (
    "relative paths in standard input start at the current directory: run there, or let check "
    "know the file by --stdin-filename FILE"
)

_UNDEFINED = re.compile(r"name '(\w+)' is not defined")
_UNKNOWN_MACRO = re.compile(r"unknown macro name: (?:xacro:)?(\S+)")
_PARAMETER = re.compile(r'Invalid parameter "([^"]*)"')
_WITHOUT_VALUE = re.compile(r"Undefined parameters \[([^\]]*)\]")
_BLOCK_TOO_MANY = re.compile(r'Unused block "([^"]*)"')
_NO_BLOCK = re.compile(r'Undefined block "([^"]*)"')
_CONDITION = re.compile(r'Xacro conditional "(.*)" evaluated to "(.*)", which is not', re.DOTALL)
_UNCLOSED = re.compile(r"invalid expression: (\$[{(].*)", re.DOTALL)
_BARE_INCLUDE = re.compile(rb"<include\s[^<>]*\bfilename\s*=")
_BARE_PROPERTY = rb"""<property\s[^<>]*?\bname\s*=\s*["']%s["'][^<>]*>"""
_DEFINED = re.compile(rb"""<xacro:(property|macro)\b[^<>]*?\bname\s*=\s*["']([\w:]+)["']""")
_NAMESPACE = re.compile(rb"""\sns\s*=\s*["']([\w.]+)""")
_OPENED = re.compile(rb"<xacro:(if|unless|macro)\b[^<>]*(?<!/)>|</xacro:(?:if|unless|macro)\s*>")


class MessageText(Record):
    """A message and a help; the rule's own help if empty."""

    message: str
    help: str = ""


def explain(defined: Definitions, error: BaseException, cause: BaseException) -> MessageText:
    """An error of an expression, a call or a tag.

    Args:
        cause: the innermost one.
    """
    if isinstance(cause, FileNotFoundError) and cause.filename:
        missing = _missing_file(os.fspath(cause.filename))
        is_relative = STANDARD_INPUT in defined.sources and not os.path.isabs(cause.filename)
        return missing._replace(help=_FROM_STANDARD_INPUT) if is_relative else missing
    if isinstance(cause, OSError) and cause.filename:
        path = os.fspath(cause.filename)
        reason, _, help = why_unreadable(path, cause).partition("; ")
        return MessageText(f"{shown(path)}: {reason}", help)
    if isinstance(cause, SyntaxError):
        return MessageText(f"not an expression: {cause.msg}", "write it as Python would read it")
    if isinstance(cause, BrokenYaml):
        where = cause.span.source.path
        return MessageText(f"{where} is not valid YAML: {cause.reason}", "correct the file")
    if isinstance(cause, KeyError):
        return MessageText(
            f"there is no key {cause}", "correct the key, or what the key comes from"
        )
    text = str(cause).split("\nwhen evaluating expression")[0].strip()
    if isinstance(cause, NameError) and (found := _UNDEFINED.search(text)):
        return _undefined_name(defined, text, found.group(1))
    if isinstance(cause, AttributeError) and "'_setitem'" in text:
        message = 'scope="parent" stands outside of every macro, where there is no parent'
        return MessageText(message, "delete the scope")
    if found := _UNKNOWN_MACRO.search(text):
        return _unknown_macro(defined, found.group(1))
    if isinstance(cause, TypeError) and (help := _help_with_types(text)):
        return MessageText(text, help)
    return _of_call(text, macro_of(error)) or MessageText(
        text.replace("\n", "; ") or type(cause).__name__
    )


def _help_with_types(text: str) -> str:
    """What to do where an expression calculates with text; empty where it does something else."""
    if " for ^: " in text:
        return "write ** for a power; ^ is none in Python"
    if "operand" in text and "'str'" in text:
        return (
            "a value in it is text: correct its definition (a number has a decimal point, and no "
            "comma or unit), or write float(...)"
        )
    return ""


def macro_of(error: BaseException) -> Any:
    """The macro whose call failed, or None."""
    macros = getattr(error, "macros", None) or [None]
    return macros[0] if isinstance(getattr(macros[0], "body", None), Node) else None


def _of_call(text: str, macro: Any) -> MessageText | None:
    """Calls with other parameters or blocks than the macro has, and the like."""
    who = f"macro '{macro.body.getAttribute('name')}'" if macro is not None else "the macro"
    params: list[str] = list(macro.params) if macro is not None else []
    if found := _PARAMETER.search(text):
        name = found.group(1)
        if any(name in param.split(",") for param in params if "," in param):
            words = " ".join(params).replace(",", " ").split()
            message = f"{who} has no parameter '{name}': its params are separated by commas"
            return MessageText(message, f'write params="{" ".join(words)}"')
        has = ", ".join(params) or "none"
        return MessageText(
            f"{who} has no parameter '{name}'", f"it has: {has}{did_you_mean(name, params)}"
        )
    if found := _WITHOUT_VALUE.search(text):
        names = found.group(1).replace(",", ", ")
        return MessageText(
            f"{who} is called without {names}", "give every parameter without a default"
        )
    if text.startswith("Not enough blocks"):
        blocks = ", ".join(param for param in params if param.startswith("*"))
        what = f"put an element for each of {blocks} into the call"
        return MessageText(f"{who} is called without an element for {blocks or 'its block'}", what)
    if found := _BLOCK_TOO_MANY.search(text):
        what = "delete it, or give the macro a parameter with * for it"
        return MessageText(f"{who} has no block parameter for <{found.group(1)}>", what)
    if found := _NO_BLOCK.search(text):
        what = "insert_block takes the name of a parameter with *, or of a property with elements"
        return MessageText(f"block '{found.group(1)}' is not defined", what)
    if found := _CONDITION.search(text):
        value = found.group(2)[:60]
        return MessageText(
            f"the condition is '{value}', neither true nor false", "write true or false"
        )
    if found := _UNCLOSED.search(text):
        bracket = "}" if found.group(1)[1] == "{" else ")"
        return MessageText(
            f"'{found.group(1)[:60]}' is never closed", f"write the missing '{bracket}'"
        )
    return None


def _unknown_macro(defined: Definitions, name: str) -> MessageText:
    known = [macro.name for macro in defined.macros]
    if tag := nearest(name, XACRO_TAGS, TYPO):
        known.append(tag)
    if elsewhere := _defined_elsewhere(defined, "macro", name):
        return MessageText(f"macro '{name}' is not defined", elsewhere)
    help = "define the macro above its call, or include the file that does"
    if any(map(_BARE_INCLUDE.search, (one.data for one in defined.sources.values()))):
        help = "write <xacro:include>: xacro ignores an <include> without the prefix"
    return MessageText(f"macro '{name}' is not defined", help + did_you_mean(name, known))


def bare_property(defined: Definitions, cause: BaseException) -> tuple[str, Span] | None:
    """The name that an expression lacks, and the ``<property>`` without prefix that has it."""
    found = _UNDEFINED.search(str(cause)) if isinstance(cause, NameError) else None
    if found is None:
        return None
    pattern = re.compile(_BARE_PROPERTY % re.escape(found.group(1)).encode())
    for source in defined.sources.values():
        if tag := pattern.search(blank_comments(source.data)):
            return found.group(1), Span(source, tag.start(), tag.end())
    return None


def _undefined_name(defined: Definitions, text: str, name: str) -> MessageText:
    if elsewhere := _defined_elsewhere(defined, "property", name):
        return MessageText(text, elsewhere)
    later = [named for _, named in _definitions(defined, "property")]
    help = f"define the property '{name}' above its use, or correct the name"
    return MessageText(text, help + did_you_mean(name, later))


def _defined_elsewhere(defined: Definitions, kind: str, name: str) -> str:
    """How a name is defined where xacro has not come, or not for this use; empty if nowhere."""
    span = next((span for span, named in _definitions(defined, kind) if named == name), None)
    if span is None:
        return ""
    place = f"{shown(span.source.path)}:{span.line}:{span.column}"
    within = _innermost(span.source.data[: span.start])
    if within == "macro":
        return f"'{name}' is defined at {place}, and known in that macro only"
    if within:
        return (
            f"'{name}' is defined at {place}, but the <xacro:{within}> around it does not hold, or "
            "comes after the use"
        )
    if include := _include_of(defined, span.source.path):
        if _innermost(include.string[: include.start()]) == "macro":
            return f"'{name}' is defined at {place}, and known in the macro that includes it only"
        if kind == "macro" and (found := _NAMESPACE.search(include[0])):
            namespace = found[1].decode()
            return f'its file is included with ns="{namespace}": write <xacro:{namespace}.{name}>'
    return f"'{name}' is defined further down, at {place}: move its definition above the use"


def _include_of(defined: Definitions, path: str) -> re.Match[bytes] | None:
    """The tag that includes a file; None without one."""
    file = re.escape(os.path.basename(path)).encode()
    included = re.compile(rb"""<xacro:include\b[^>]*%s["'][^>]*>""" % file)
    found = (included.search(source.data) for source in defined.sources.values())
    return next(filter(None, found), None)


def _definitions(defined: Definitions, kind: str) -> Iterator[tuple[Span, str]]:
    """Places and names of the definitions in all files."""
    for source in defined.sources.values():
        for found in _DEFINED.finditer(source.data):
            if found[1].decode() == kind:
                yield Span(source, found.start(), found.end()), found[2].decode()


def _innermost(before: bytes) -> str:
    """The condition or macro that is open at the end of a text; empty if none is."""
    opened: list[str] = []
    for found in _OPENED.finditer(before):
        if found[1]:
            opened.append(found[1].decode())
        elif opened:
            opened.pop()
    return opened[-1] if opened else ""


def _missing_file(path: str) -> MessageText:
    _, scheme, there = path.partition("package:/")
    if scheme:
        package, _, rest = there.strip("/").partition("/")
        message = f"xacro does not resolve package://{package}/{rest}"
        return MessageText(message, f"write $(find {package})/{rest}")
    if disk.is_file(f"{path}.in"):
        made = f"{UNBUILT}: {shown(path)}, from {os.path.basename(path)}.in"
        return MessageText(made, "build the workspace, or make the file with CMake's values")
    if disk.is_file(f"{path}.xacro") and is_expanded(f"{path}.xacro"):
        made = f"{UNBUILT}: {shown(path)}, from {os.path.basename(path)}.xacro"
        return MessageText(made, "build the workspace, or include the xacro itself")
    return MessageText(f"file not found: {shown(path)}", _nearest_file(path))


def _nearest_file(path: str) -> str:
    """What there is instead of a missing file: a directory that is missing, or a file like it."""
    directory, name = os.path.split(os.path.normpath(path))
    last = name
    while (
        directory and not disk.is_directory(directory) and directory != os.path.dirname(directory)
    ):
        directory, name = os.path.split(directory)
    try:
        siblings = disk.names(directory or os.curdir)
    except OSError:
        return ""
    stem, dot, suffix = name.partition(".")
    alike = [other.partition(".")[0] for other in siblings if other.endswith(dot + suffix)]
    suggested = nearest(stem, alike, SIMILAR_FILE)
    hint = f"did you mean '{suggested}{dot}{suffix}'?" if suggested else ""
    if name == last:
        return hint or "correct the path; a relative one starts at the file that it stands in"
    there = sorted(one for one in siblings if disk.is_directory(os.path.join(directory, one)))
    if not hint and 0 < len(there) <= _FEW:  # often the values that an argument may have
        hint = f"there {'is' if len(there) == 1 else 'are'} {', '.join(there)}"
    return f"directory '{name}' not found in {shown(directory)}" + (f"; {hint}" if hint else "")
