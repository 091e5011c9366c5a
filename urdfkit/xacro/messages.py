"""Messages and help for xacro's errors."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from itertools import pairwise

from urdfkit.core import disk
from urdfkit.core.record import Record
from urdfkit.core.static_typing import Any
from urdfkit.core.suggest import TYPO, did_you_mean, nearest, nearest_file_name
from urdfkit.text.comments import blank_comments
from urdfkit.text.schema import XACRO_TAGS
from urdfkit.text.source import STANDARD_INPUT, Span, shown, why_unreadable
from urdfkit.workspace.install_rules import is_built, is_expanded
from urdfkit.workspace.manifest import nearest_manifest
from urdfkit.workspace.package_directories import package_name
from urdfkit.xacro.definitions import Definitions
from urdfkit.xacro.dom import Node
from urdfkit.xacro.errors import IN_CONDITION, NOT_BUILT, ONLY_XACRODOC, BrokenYaml

#: Most directories in a help text.
_MAX_DIRECTORIES = 10
#: Most directories in the path of a file in a macro.
_MAX_LEVELS = 5

_FROM_STANDARD_INPUT = (
    "paths in standard input are relative to the current directory: run urdfkit there, or pass "
    "--stdin-filename FILE"
)

_NO_KEY = re.compile(r"The yaml dictionary has no key '([^']*)'")
_INCLUDED_AS = re.compile(rb"""<xacro:include\b[^>]*\bns\s*=\s*["']([\w.-]+)["']""")
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
    """A message with its help."""

    message: str
    help: str = ""  # the rule's own help if empty


def explain(defined: Definitions, error: BaseException, cause: BaseException) -> MessageText:
    """The message for an error of an expression, a call or a tag.

    Args:
        cause: the innermost error.
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
        return MessageText(f"not an expression: {cause.msg}", "write a valid Python expression")
    if isinstance(cause, BrokenYaml):
        where = cause.span.source.path
        return MessageText(f"{where} is not valid YAML: {cause.reason}", "correct the file")
    if isinstance(cause, KeyError):
        return MessageText(f"key {cause} does not exist", "correct the key, or its source")
    text = str(cause).split("\nwhen evaluating expression")[0].strip()
    if isinstance(cause, AttributeError) and (message := _attribute_error(text, cause)):
        return message
    if isinstance(cause, NameError) and (match := _UNDEFINED.search(text)):
        return _undefined_name(defined, text, match.group(1))
    if match := _UNKNOWN_MACRO.search(text):
        return _unknown_macro(defined, match.group(1))
    if isinstance(cause, TypeError) and (help := _type_error_help(text)):
        return MessageText(text, help)
    return _call_error(text, macro_of(error)) or MessageText(
        text.replace("\n", "; ") or type(cause).__name__
    )


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


def _type_error_help(text: str) -> str:
    """How to fix an expression that computes with text; empty for other errors."""
    if " for ^: " in text:
        return "write ** for a power; ^ is not a power in Python"
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


def _call_error(text: str, macro: Any) -> MessageText | None:
    """The message for wrong parameters or blocks of a call, a wrong condition or bracket."""
    owner = f"macro '{macro.body.getAttribute('name')}'" if macro is not None else "the macro"
    params: list[str] = list(macro.params) if macro is not None else []
    if match := _PARAMETER.search(text):
        name = match.group(1)
        if any(name in param.split(",") for param in params if "," in param):
            words = " ".join(params).replace(",", " ").split()
            message = f"{owner} has no parameter '{name}': its params are separated by commas"
            return MessageText(message, f'write params="{" ".join(words)}"')
        available = ", ".join(params) or "none"
        help = f"it has: {available}{did_you_mean(name, params)}"
        return MessageText(f"{owner} has no parameter '{name}'", help)
    if match := _WITHOUT_VALUE.search(text):
        names = match.group(1).replace(",", ", ")
        help = "pass every parameter without a default"
        numbers = [param for param in params if param[:1].isdigit() or param[:1] in "-+."]
        if numbers:  # the words of a default, which ends at the first space
            help = f"write the default with '{numbers[0]}' in single quotes: name:='0 0 0'"
        return MessageText(f"{owner} is called without {names}", help)
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


def _unknown_macro(defined: Definitions, name: str) -> MessageText:
    known = [macro.name for macro in defined.macros]
    if tag := nearest(name, XACRO_TAGS, TYPO):
        known.append(tag)
    if elsewhere := _defined_elsewhere(defined, "macro", name):
        return MessageText(f"macro '{name}' is not defined", elsewhere)
    space, _, bare = name.rpartition(".")
    if space and bare in known:  # in another namespace: no other name is meant
        known = [f"{namespace}.{bare}" for namespace in _namespaces(defined)]
    help = "define the macro above its call, or include the file that does"
    if any(_BARE_INCLUDE.search(source.data) for source in defined.sources.values()):
        help = "write <xacro:include>: xacro ignores an <include> without the prefix"
    return MessageText(f"macro '{name}' is not defined", help + did_you_mean(name, known))


def _namespaces(defined: Definitions) -> list[str]:
    """The namespaces in which files are included."""
    texts = (source.data for source in defined.sources.values())
    names = (name for text in texts for name in _INCLUDED_AS.findall(blank_comments(text)))
    return list(dict.fromkeys(name.decode("utf-8", "replace") for name in names))


def bare_property(defined: Definitions, cause: BaseException) -> tuple[str, Span] | None:
    """An undefined name, and the ``<property>`` without prefix that should define it."""
    match = _UNDEFINED.search(str(cause)) if isinstance(cause, NameError) else None
    if match is None:
        return None
    pattern = re.compile(_BARE_PROPERTY % re.escape(match.group(1)).encode())
    for source in defined.sources.values():
        if tag := pattern.search(blank_comments(source.data)):
            return match.group(1), Span(source, tag.start(), tag.end())
    return None


def _undefined_name(defined: Definitions, text: str, name: str) -> MessageText:
    if elsewhere := _defined_elsewhere(defined, "property", name):
        return MessageText(text, elsewhere)
    if any(argument.name == name for argument in defined.arguments):
        use = f"write $(arg {name}), or define a property of this value above the use"
        return MessageText(text, f"'{name}' is an argument: {use}")
    known = [property_name for _, property_name in _definitions(defined, "property")]
    help = f"define the property '{name}' above its use, or correct the name"
    return MessageText(text, help + did_you_mean(name, known))


def _defined_elsewhere(defined: Definitions, kind: str, name: str) -> str:
    """The help for a name whose definition is not valid for its use; empty if it has none."""
    definitions = _definitions(defined, kind)
    span = next((span for span, known_name in definitions if known_name == name), None)
    if span is None:
        return ""
    place = f"{shown(span.source.path)}:{span.line}:{span.column}"
    parent = _innermost(span.source.data[: span.start])
    if parent == "macro":
        return f"'{name}' is defined at {place}, but only inside that macro"
    if parent:
        return (
            f"'{name}' is defined at {place} in an <xacro:{parent}> {IN_CONDITION}, or which comes "
            "after the use"
        )
    if include := _include_of(defined, span.source.path):
        if _innermost(include.string[: include.start()]) == "macro":
            return f"'{name}' is defined at {place}, but only inside the macro that includes it"
        if kind == "macro" and (match := _NAMESPACE.search(include[0])):
            namespace = match[1].decode()
            return f'its file is included with ns="{namespace}": write <xacro:{namespace}.{name}>'
    return f"'{name}' is defined later, at {place}: move its definition above the use"


def _include_of(defined: Definitions, path: str) -> re.Match[bytes] | None:
    """The tag that includes a file; None if there is none."""
    file = re.escape(os.path.basename(path)).encode()
    pattern = re.compile(rb"""<xacro:include\b[^>]*%s["'][^>]*>""" % file)
    matches = (pattern.search(source.data) for source in defined.sources.values())
    return next(filter(None, matches), None)


def _definitions(defined: Definitions, kind: str) -> Iterator[tuple[Span, str]]:
    """Spans and names of the definitions in all files."""
    for source in defined.sources.values():
        for match in _DEFINED.finditer(source.data):
            if match[1].decode() == kind:
                yield Span(source, match.start(), match.end()), match[2].decode()


def _innermost(text: bytes) -> str:
    """The innermost condition or macro that is open at the end of a text; empty if none is."""
    opened: list[str] = []
    for match in _OPENED.finditer(text):
        if match[1]:
            opened.append(match[1].decode())
        elif opened:
            opened.pop()
    return opened[-1] if opened else ""


def relative_to_caller(cause: BaseException, own: str) -> MessageText | None:
    """The message for a missing file that is found from the file ``own``, in whose macro it is."""
    if not isinstance(cause, FileNotFoundError) or not cause.filename:
        return None
    path, home = os.fspath(cause.filename), os.path.dirname(own)
    name, above = os.path.basename(path), os.path.dirname(path)
    for _ in range(_MAX_LEVELS):
        is_other = os.path.abspath(above) != os.path.abspath(home)
        if is_other and disk.is_file(os.path.join(home, name)):
            message = f"file not found: {shown(path)}, relative to the file that calls the macro"
            help = f"write $(find PACKAGE)/..., which finds {shown(home)}/{name} from everywhere"
            return MessageText(message, help)
        name, above = f"{os.path.basename(above)}/{name}", os.path.dirname(above)
    return None


def _missing_file(path: str) -> MessageText:
    _, scheme, reference = path.partition("package:/")
    if scheme:
        package, _, rest = reference.strip("/").partition("/")
        message = f"xacro does not resolve package://{package}/{rest}"
        return MessageText(message, f"write $(find {package})/{rest}")
    if disk.is_file(f"{path}.in"):
        message = f"{NOT_BUILT}: {shown(path)}, from {os.path.basename(path)}.in"
        help = "build the workspace, or create the file with the values of CMake"
        return MessageText(message, help)
    if disk.is_file(f"{path}.xacro") and is_expanded(f"{path}.xacro"):
        message = f"{NOT_BUILT}: {shown(path)}, from {os.path.basename(path)}.xacro"
        return MessageText(message, "build the workspace, or include the xacro itself")
    if is_built(path):
        return MessageText(f"{NOT_BUILT}: {shown(path)}", "build the workspace")
    if found := _from_parent(path):
        directory, relative = found
        message = f"{ONLY_XACRODOC}: {shown(path)}; only xacrodoc finds it, in {shown(directory)}"
        return MessageText(message, f"write {relative}")
    help = _below_package(os.path.abspath(path)) or _nearest_file(path)
    return MessageText(f"file not found: {shown(path)}", help)


def _below_package(path: str) -> str:
    """The help for a path that is right from the directory of the package."""
    file = nearest_manifest(path)
    home = os.path.dirname(file) if file else ""
    name = package_name(home) if file else None
    parts = os.path.relpath(path, home).split(os.sep) if name else []
    for number in range(1, len(parts) - 1):
        if disk.is_file(os.path.join(home, *parts[number:])):
            return f"write $(find {name})/{'/'.join(parts[number:])}"
    return ""


def _from_parent(path: str) -> tuple[str, str] | None:
    """The directory from which a path is right, and the right path; None if there is none.

    Such a path begins with the name of the directory that it is in: ``xacro/xacro/leg.xacro``.
    """
    parts = path.split(os.sep)
    for number, (name, other) in enumerate(pairwise(parts)):
        relative = parts[number + 2 :]
        if name == other and disk.is_file(os.sep.join((*parts[: number + 1], *relative))):
            return os.sep.join(parts[:number]) or os.curdir, "/".join(relative)
    return None


def _nearest_file(path: str) -> str:
    """The help for a missing file: the missing directory in its path, or a similar file."""
    directory, name = os.path.split(os.path.normpath(path))
    last = name
    while (
        directory and not disk.is_directory(directory) and directory != os.path.dirname(directory)
    ):
        directory, name = os.path.split(directory)
    if name != last and directory.startswith(os.sep) and directory.count(os.sep) == 1:
        return "the path is of another computer: write $(find PACKAGE)/..."  # below / or /home
    try:
        siblings = disk.names(directory or os.curdir)
    except OSError:
        return ""
    suggested = nearest_file_name(name, siblings)
    hint = f"did you mean '{suggested}'?" if suggested else ""
    if name == last:
        return hint or "correct the path; a relative one begins at the directory of its file"
    present = sorted(path for path in siblings if disk.is_directory(os.path.join(directory, path)))
    if not hint and 0 < len(present) <= _MAX_DIRECTORIES:  # often the valid values of an argument
        hint = f"available: {', '.join(present)}"
    return f"directory '{name}' not found in {shown(directory)}" + (f"; {hint}" if hint else "")
