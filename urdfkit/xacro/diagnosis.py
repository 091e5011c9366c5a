"""xacro's errors and warnings as Problems, with message, source location and help."""

import math
import os
import re
from collections.abc import Collection, Iterable
from types import FrameType

from urdfkit.core import disk
from urdfkit.core.static_typing import Any
from urdfkit.core.suggest import nearest
from urdfkit.core.words import few
from urdfkit.errors import PackageNotFound
from urdfkit.text.diagnostic import Edit, Fix, Problem, Related, Severity
from urdfkit.text.document import Location
from urdfkit.text.source import Span
from urdfkit.text.xml_reader import DocumentTooLarge
from urdfkit.xacro.bounds import TooLarge, UnsafeExpression
from urdfkit.xacro.definitions import Definition, Definitions, annotations_of
from urdfkit.xacro.dom import Node
from urdfkit.xacro.errors import BrokenYaml, EscapesRoots, MissingArgument, root_cause
from urdfkit.xacro.locator import LocatedExpression, locate
from urdfkit.xacro.messages import explain, macro_of
from urdfkit.xacro.substitution import ENVIRONMENT, ForbiddenVariable, UnsetVariable
from urdfkit.xacro.undefined_names import bare_property
from urdfkit.xacro.yaml_files import YamlTooLarge

_DEPRECATED = re.compile(r"Using (\w+)\(\) directly is deprecated\. Use ([\w.]+)\(\)")
_UNKNOWN_ATTRIBUTE = re.compile(r"unknown attribute\(s\): ([\w:.-]+)")
#: Most other arguments that the help for a missing one names.
_MAX_ARGUMENTS = 20


def related(span: Span, message: str) -> tuple[Related, ...]:
    return (Related(span, message),)


def node_in(frame: FrameType | None) -> tuple[Node | None, dict[str, Any]]:
    """The element that xacro is processing, and the local variables of the processing function."""
    while frame is not None:
        local = frame.f_locals
        node = local.get("elt", local.get("node"))
        if (
            node is not None
            and hasattr(node, "nodeType")
            and "_urdfkit_xacro" in str(frame.f_globals.get("__name__"))
        ):
            element = node if isinstance(node, Node) else node.parentNode
            if isinstance(element, Node):
                return element, local
        frame = frame.f_back
    return None, {}


def problem(
    defined: Definitions,
    error: Exception,
    located: LocatedExpression,
    used: LocatedExpression,
    frame: FrameType,
) -> Problem:
    """The problem of an expression that failed.

    Args:
        located: the expression. Inside a property, the problem is located at the definition of the
            property, and its uses are related.
        used: the expression that uses it, which xacro is evaluating.
    """
    if missing := argument_of_missing_file(defined, root_cause(error)):
        return missing
    node, local = node_in(frame)
    if bare := bare_property(defined, root_cause(error)):
        return _without_prefix(*bare, node and locate(node, local, used).span)
    if node is None:
        return _problem_at(Location(Span(defined.source, 0, 0)), defined, error, located)
    if located.resolving:
        table, key = located.resolving[-1]
        definer = annotations_of(table).definers.get(key)
        if definer is not None:
            notes = related(locate(node, local, used).span, f"needed here for '{key}'")
            location = locate(definer, {}, located)
            return _problem_at(location, defined, error, located)._replace(related=notes)
    cause = root_cause(error)
    if isinstance(cause, BrokenYaml):
        notes = related(cause.span, cause.reason)
    else:
        notes = _definitions(local, located)
    location = locate(node, local, located)
    if isinstance(cause, MissingArgument) and _is_local(str(cause), defined, local):
        message = f"'{cause}' is not an argument: it is a property or a parameter of the macro"
        return Problem("XAC001", location.span, message, f"write ${{{cause}}}", location.frame)
    return _problem_at(location, defined, error, located)._replace(related=notes)


def _is_local(name: str, defined: Definitions, local: dict[str, Any]) -> bool:
    """True for a name that is not declared as an argument, but is defined where it is used."""
    table = local.get("symbols", local.get("table"))
    return name not in defined.argument_defaults and _definer(name, table) is not None


def _definitions(local: dict[str, Any], located: LocatedExpression) -> tuple[Related, ...]:
    """The definitions of the names in a failing expression."""
    notes: list[Related] = []
    table = local.get("symbols", local.get("table"))
    for name in dict.fromkeys(re.findall(r"[A-Za-z_]\w*", located.token)):
        definer = _definer(name, table)
        if definer is not None and definer.tagName == "xacro:property":
            notes.append(Related(definer.tag_at.span, f"'{name}' is defined here"))
    return tuple(notes)


def _definer(name: str, table: Any) -> Node | None:
    """The element that defines a name in a table of symbols, or in the nearest outer table."""
    while table is not None:
        definer = annotations_of(table).definers.get(name)
        if definer is not None:
            return definer
        table = getattr(table, "__dict__", {}).get("parent")
    return None


def _problem_at(
    at: Location, defined: Definitions, error: Exception, located: LocatedExpression
) -> Problem:
    code, message, help = classify(defined, error)
    token = located.token if located.token.startswith("$") else ""
    if code in ("XAC001", "XAC009", "XAC013") and token and token[:60] not in message:
        message += f" in {token}"
    cause = root_cause(error)
    argument = str(cause) if isinstance(cause, MissingArgument) else ""
    return Problem(code, at.span, message, help, at.frame, argument=argument)


def _without_prefix(name: str, at: Span, use: Span | None) -> Problem:
    """The problem of a ``<property>`` without prefix; one for all of its uses."""
    return Problem(
        "XAC001",
        at,
        f"name '{name}' is not defined: xacro ignores a <property> without the prefix",
        "write <xacro:property>, and add the prefix to the other xacro tags",
        related=related(use, "needed here") if use else (),
    )


#: Defaults of arguments that name nothing.
_NOTHING = ("", "none", "null")


def argument_of_missing_file(
    defined: Definitions, cause: BaseException, written: str = ""
) -> Problem | None:
    """The problem of a file that is missing because the default of an argument is a placeholder.

    The default of Universal Robots' ``ur_type`` is ``ur5x``, and no such directory exists; with an
    empty default, a path resolves to the directory of the description.

    Args:
        written: the tag that names the file; empty if an expression reads it.
    """
    if not isinstance(cause, OSError) or not cause.filename:
        return None
    optional = [item for item in defined.arguments if item.name not in defined.values]
    if isinstance(cause, FileNotFoundError):
        argument = _placeholder(optional, cause.filename)
        argument = argument or _without_name(optional, cause.filename, written)
        argument = argument or _empty_in_name(optional, cause.filename, written)
    elif isinstance(cause, IsADirectoryError):
        empty = [item for item in optional if item.attributes.get("default") == ""]
        argument = empty[0] if len(empty) == 1 else None
    else:
        return None
    if argument is None:
        return None
    at = argument.tag.attribute_spans().get("default", argument.tag.span)
    message = (
        f"argument '{argument.name}' is required: with its default "
        f"'{argument.attributes['default']}', files of the model are missing"
    )
    return Problem("XAC010", at, message, _pass(defined, argument.name), argument=argument.name)


def _placeholder(optional: Collection[Definition], file: str) -> Definition | None:
    """The argument whose default is the name of a missing directory in the path of a file.

    Or an absolute path, such as ``/tmp``, with which the path of the file begins.
    """
    absolute = [item for item in optional if item.attributes.get("default", "").startswith("/")]
    for argument in absolute:
        if file.startswith(argument.attributes["default"].rstrip("/") + "/"):
            return argument
    parts = os.path.dirname(os.path.abspath(file)).split(os.sep)
    for argument in optional:
        default = argument.attributes.get("default", "")
        if len(default) > 2 and default in parts:
            parent = os.sep.join(parts[: parts.index(default)])
            if disk.is_directory(parent) and not disk.exists(os.path.join(parent, default)):
                return argument
    return None


def _without_name(optional: Iterable[Definition], file: str, written: str) -> Definition | None:
    """The argument whose default says that it names nothing, and is the name of a file."""
    name = os.path.basename(file).partition(".")[0]
    found = [item for item in optional if item.attributes.get("default") == name]
    if name.lower() not in _NOTHING:
        return None
    found = [item for item in found if item.name in written] or found
    return found[0] if len(found) == 1 else None


def _empty_in_name(optional: Iterable[Definition], file: str, written: str) -> Definition | None:
    """The argument that is empty, and is a part of the name of a file of which there are others.

    Without it, ``base$(arg drive).xacro`` is ``base.xacro``, next to ``base4WD.xacro``.
    """
    siblings = disk.names_or_empty(os.path.dirname(file))
    for argument in optional:
        name = re.escape(argument.name)
        use = rf"\$\(arg\s+{name}\s*\)|\$\{{\s*{name}\s*\}}"
        before, *others = re.split(use, written)
        if argument.attributes.get("default") != "" or len(others) != 1:
            continue
        start, end = re.split(r"[/\"']", before)[-1], re.split(r"[\"']", others[0])[0]
        if any(
            other.startswith(start) and other.endswith(end) and len(other) > len(start + end)
            for other in siblings
        ):
            return argument
    return None


def classify(defined: Definitions, error: BaseException) -> tuple[str, str, str]:
    cause = root_cause(error)
    if isinstance(cause, (UnsafeExpression, ForbiddenVariable)):
        rejected = "rejected: " if isinstance(cause, UnsafeExpression) else ""
        return "XAC009", f"{rejected}{cause}", ""
    if isinstance(cause, (TooLarge, DocumentTooLarge, YamlTooLarge)):
        return "XAC013", f"rejected: {cause}", ""
    if isinstance(cause, RecursionError):
        return "XAC013", "infinite recursion of macros, includes or properties", ""
    if isinstance(cause, PackageNotFound):
        searched = ", ".join(cause.searched) or "nothing to search"
        message = f"package '{cause.name}' is not found; searched: {searched}"
        return "XAC011", message, f"pass its directory: --package {cause.name}=DIR"
    if isinstance(cause, UnsetVariable):
        help = "set it" if cause.name in ENVIRONMENT else "set it, and pass --trust"
        return "XAC001", str(cause), f"{help}, or write $(optenv {cause.name} DEFAULT)"
    if isinstance(cause, EscapesRoots):
        help = "move the file into a package, or add --trust if you trust the author of the model"
        return "XAC009", str(cause), help
    if isinstance(cause, MissingArgument):
        message = f"argument '{cause}' has no value and no default"
        return "XAC010", message, _how_to_pass(defined, cause)
    return "XAC001", *explain(defined, error, cause)


def _how_to_pass(defined: Definitions, missing: BaseException) -> str:
    others = {name: default for name, default in defined.argument_defaults.items() if default}
    text = _pass(defined, str(missing))
    if others:
        named = [f"{name} (default {default})" for name, default in others.items()]
        text += f"; other arguments: {few(named, _MAX_ARGUMENTS)}"
    return text


def _pass(defined: Definitions, name: str) -> str:
    """How to pass an argument, and the misspelt argument that was passed instead, if any."""
    known = defined.argument_defaults
    mistake = nearest(name, [passed for passed in defined.values if passed not in known])
    return f"pass it: {name}:=VALUE" + (f", not {mistake}:=" if mistake else "")


def used_too_early(name: str, declaration: Node, frame: FrameType) -> Problem:
    """The problem of an argument that is used above the ``<xacro:arg>`` with its default."""
    node, local = node_in(frame)
    at = declaration.tag_at.span if node is None else node.tag_at.span
    help = f"move the <xacro:arg> above the first use, or pass {name}:=VALUE"
    definer = _definer(name, local.get("symbols", local.get("table")))
    if definer is not None and definer.tagName != "xacro:property":
        help = f"write ${{{name}}} for the parameter of the macro"
    use = re.compile(rb"\$\(\s*arg\s+%s\s*\)" % re.escape(name.encode()))
    if found := use.search(at.source.data, at.start, at.end):
        at = Span(at.source, *found.span())
    return Problem(
        "XAC020",
        at,
        f"argument '{name}' is used above its <xacro:arg>, before xacro reads its default",
        help,
        node.frame if node is not None else None,
        related(declaration.tag_at.span, "declared here"),
        argument=name,
    )


def macro_notes(error: BaseException) -> tuple[Related, ...]:
    """A note on the definition of the macro whose call failed."""
    macro = macro_of(error)
    if macro is None:
        return ()
    name = macro.body.getAttribute("name")
    return related(macro.body.tag_at.span, f"macro '{name}' is defined here")


def warning(text: str, node: Node, local: dict[str, Any]) -> Problem | None:
    """The problem of a warning of xacro; None if it has no effect.

    Args:
        node: the element that xacro is processing.
        local: the local variables of the processing function.
    """
    if text.startswith("redefining global symbol: "):
        return _shadowing(text.rpartition(": ")[2], node, getattr(local.get("m"), "body", None))
    if deprecated := _DEPRECATED.match(text):
        return _deprecated_call(node, *deprecated.groups())
    spans = node.tag_at.attribute_spans()
    at = node.tag_at.span
    if unknown := _UNKNOWN_ATTRIBUTE.search(text):
        at = spans.get(unknown.group(1), at)
    elif "matched no files" in text:
        at = spans.get("filename", at)
    return Problem("XAC017", at, text, "", node.frame)


def _shadowing(name: str, node: Node, macro: Any) -> Problem | None:
    """The problem of a property or macro parameter with the name of a constant or function."""
    constant = {"pi": math.pi, "e": math.e, "tau": math.tau}.get(name)
    spans = node.tag_at.attribute_spans()
    hidden = f"the constant {name} = {constant:.6g}" if constant else f"the function {name}()"
    if node.tagName == "xacro:property":
        if constant and _is_near(node.raw_attributes().get("value", ""), constant):
            return None  # it repeats the constant; XAC007 reports inexact ones
        at = spans.get("name", node.tag_at.span)
        help = "rename the property" + (", or delete it: xacro defines pi" if name == "pi" else "")
        return Problem("XAC017", at, f"property '{name}' hides {hidden}", help, node.frame)
    if isinstance(macro, Node):
        params = macro.tag_at.attribute_spans().get("params", macro.tag_at.span)
        match = re.search(rb"(?<![\w*])%s(?!\w)" % re.escape(name.encode()), params.text.encode())
        start, end = match.span() if match else (0, params.end - params.start)
        at = Span(params.source, params.start + start, params.start + end)
        message = f"parameter '{name}' of macro '{macro.getAttribute('name')}' hides {hidden}"
        return Problem("XAC017", at, message, "rename the parameter", macro.frame)
    return Problem("XAC017", node.tag_at.span, f"'{name}' hides {hidden}", "", node.frame)


def _is_near(text: str, value: float) -> bool:
    try:
        return abs(float(text) - value) < 1e-4
    except ValueError:
        return False


def _deprecated_call(node: Node, old: str, new: str) -> Problem:
    """The problem of a function that moved into a namespace; the fix renames the call."""
    message, help = f"{old}() without its namespace is deprecated", f"write {new}()"
    pattern = re.compile(rb"(?<![\w.])" + old.encode() + rb"(?=\s*\()")
    at = node.tag_at.span
    match = pattern.search(at.source.data, at.start, at.end)
    if match is None:
        return Problem("XAC017", at, message, help, node.frame, severity=Severity.INFO)
    span = Span(at.source, *match.span())
    fix = Fix(help, (Edit(span, new),), safe=True)
    return Problem("XAC017", span, message, help, node.frame, fix=fix, severity=Severity.INFO)
