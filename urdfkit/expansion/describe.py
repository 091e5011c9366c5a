"""xacro's errors and warnings as Problems: what went wrong, where, and what to do."""

from __future__ import annotations

import math
import os
import re
from types import FrameType
from typing import TYPE_CHECKING, Any

from urdfkit.diagnostic import Edit, Fix, Related
from urdfkit.errors import PackageNotFound
from urdfkit.expansion.dom import Node
from urdfkit.expansion.errors import EscapesRoots, MissingArgument, root_cause
from urdfkit.expansion.expressions import TooLarge, UnsafeExpression
from urdfkit.expansion.substitution import EnvironmentRefused
from urdfkit.expansion.values import YamlTooLarge
from urdfkit.nearest import did_you_mean, nearest
from urdfkit.reading import Problem, TooMuch
from urdfkit.source import Span

if TYPE_CHECKING:
    from urdfkit.expansion.run import Located, Run

_DEPRECATED = re.compile(r"Using (\w+)\(\) directly is deprecated\. Use ([\w.]+)\(\)")
_UNDEFINED = re.compile(r"name '(\w+)' is not defined")
UNKNOWN_MACRO = re.compile(r"macro '([^']+)' is not defined")


def related(span: Span, message: str) -> tuple[Related, ...]:
    """One related place."""
    return (Related(span, message),)


def node_in(frame: FrameType | None) -> tuple[Node | None, dict[str, Any]]:
    """The element that xacro is working on, and the variables of the function that does."""
    while frame is not None:
        local = frame.f_locals
        node = local.get("elt", local.get("node"))
        if (
            node is not None
            and hasattr(node, "nodeType")
            and "_urdfkit_xacro" in str(frame.f_globals.get("__name__"))
        ):
            holder = node if isinstance(node, Node) else node.parentNode
            if isinstance(holder, Node):
                return holder, local
        frame = frame.f_back
    return None, {}


def problem(run: Run, error: Exception, located: Located, frame: FrameType) -> Problem:
    """An expression that failed, at its place.

    Inside a property the place is the property's definition, and its uses are related.
    """
    if wanting := _argument_of_missing_file(run, root_cause(error)):
        return wanting
    node, local = node_in(frame)
    if located.resolving:
        table, key = located.resolving[-1]
        definer = _places(table).get(key, (None,))[0]
        if isinstance(definer, Node):
            used = _span(node, local, located) if node is not None else None
            notes = related(used or definer.tag_at.span, f"needed here for '{key}'")
            made = _made(run, error, located, _span(definer, {}, located))
            return made._replace(frame=definer.frame, related=notes)
    if node is None:
        return _made(run, error, located, Span(run.source, 0, 0))
    made = _made(run, error, located, _span(node, local, located))
    return made._replace(frame=node.frame, related=_definitions(local, located))


def _definitions(local: dict[str, Any], located: Located) -> tuple[Related, ...]:
    """Where the names of a failing expression were defined."""
    found: list[Related] = []
    table = local.get("symbols", local.get("table"))
    for name in dict.fromkeys(re.findall(r"[A-Za-z_]\w*", located.token)):
        scope = table
        while scope is not None:
            if name in _places(scope):
                definer = _places(scope)[name][0]
                span = definer.tag_at.span
                if definer.tagName == "xacro:property":
                    found.append(Related(span, f"'{name}' is defined here"))
                break
            scope = getattr(scope, "__dict__", {}).get("parent")
    return tuple(found)


def _places(table: Any) -> dict[str, Any]:
    """Who defined the names of a table; not by getattr, which a name space answers itself."""
    places: dict[str, Any] = getattr(table, "__dict__", {}).get("places", {})
    return places


def _span(node: Node, local: dict[str, Any], located: Located) -> Span:
    """The expression in the attribute, the text or the macro parameter that holds it."""
    spans = node.tag_at.attribute_spans()
    values = dict(zip(node.raw[::2], node.raw[1::2], strict=True))
    for name, value in values.items():
        if value == located.text and name in spans:
            return _inside(spans[name], located)
    macro = getattr(local.get("m"), "body", None)
    if isinstance(macro, Node):
        params = macro.tag_at.attribute_spans().get("params")
        if params is not None and located.text in params.text:
            start = params.start + params.text.encode().find(located.text.encode())
            return Span(params.source, start, start + len(located.text.encode()))
    inner = node.tag_at.inner_span
    start = inner.source.data.find(located.token.encode(), inner.start, inner.end)
    if start >= 0:
        return Span(inner.source, start, start + len(located.token.encode()))
    return node.tag_at.span


def _inside(span: Span, located: Located) -> Span:
    """The expression in an attribute's value; the whole value if it is written with entities."""
    if span.text != located.text:
        return span
    start = span.start + len(located.text[: located.offset].encode())
    return Span(span.source, start, start + len(located.token.encode()))


def _made(run: Run, error: Exception, located: Located, at: Span) -> Problem:
    code, message, help = classify(run, error)
    if located.token.startswith("$") and code in ("XAC001", "XAC009", "XAC013"):
        message += f" in {located.token}"
    return Problem(code, at, message, help)


def _argument_of_missing_file(run: Run, cause: BaseException) -> Problem | None:
    """A file that is missing because an argument has only a stand-in for a default.

    Universal Robots' ``ur_type`` is ``ur5x`` unless given, and no such folder exists.
    """
    if not isinstance(cause, FileNotFoundError) or not cause.filename:
        return None
    parts = os.fspath(cause.filename).split(os.sep)
    for argument in run.declared:
        default = argument.attributes.get("default", "")
        if default in parts and len(default) > 2 and argument.name not in run.arguments:
            at = argument.tag.attribute_spans().get("default", argument.tag.span)
            message = (
                f"argument '{argument.name}' must be given: with its default '{default}' "
                "files are missing that the model needs"
            )
            return Problem("XAC010", at, message, f"pass it: {argument.name}:=VALUE")
    return None


def classify(run: Run, error: BaseException) -> tuple[str, str, str]:
    """Code, message and help of an error."""
    cause = root_cause(error)
    if isinstance(cause, UnsafeExpression):
        return "XAC009", f"refused: {cause}", ""
    if isinstance(cause, EnvironmentRefused):
        return "XAC009", str(cause), ""
    if isinstance(cause, (TooLarge, TooMuch, YamlTooLarge)):
        return "XAC013", f"refused: {cause}", ""
    if isinstance(cause, RecursionError):
        return "XAC013", "macros, includes or properties refer to themselves without end", ""
    if isinstance(cause, MemoryError):
        return "XAC013", "the expansion needs more memory than there is", ""
    if isinstance(cause, PackageNotFound):
        searched = ", ".join(cause.searched) or "nothing to search"
        message = f"package '{cause.name}' is not found; searched: {searched}"
        return "XAC011", message, f"name its folder: --package {cause.name}=DIR"
    if isinstance(cause, EscapesRoots):
        return "XAC012", f"{cause} is outside the workspace and the packages of this model", ""
    if isinstance(cause, MissingArgument):
        return "XAC010", f"argument '{cause}' has no value and no default", _how_to_pass(run, cause)
    return "XAC001", _plain(error, cause), _what_to_do(run, cause)


def _plain(error: BaseException, cause: BaseException) -> str:
    """The reason in one line, without xacro's list of enclosing expressions."""
    if isinstance(cause, FileNotFoundError) and cause.filename:
        return f"there is no file {cause.filename}"
    if isinstance(cause, OSError) and cause.filename:
        return f"{cause.filename}: {cause.strerror}"
    if isinstance(cause, SyntaxError):
        return f"not an expression: {cause.msg}"
    text = str(cause).split("\nwhen evaluating expression")[0].strip()
    if text.startswith("unknown macro name: "):
        return f"macro '{text.rpartition(' ')[2].removeprefix('xacro:')}' is not defined"
    if isinstance(cause, AttributeError) and "'_setitem'" in text:
        return 'scope="parent" stands outside of every macro, where there is no parent'
    return text.replace("\n", "; ") or type(cause).__name__


def _how_to_pass(run: Run, missing: BaseException) -> str:
    declared = {name: default for name, default in run.known_arguments().items() if default}
    text = f"pass it: {missing}:=VALUE"
    if declared:
        text += "; the others: " + ", ".join(f"{n} (default {d})" for n, d in declared.items())
    return text


def _what_to_do(run: Run, cause: BaseException) -> str:
    """The remedy, with the name that was probably meant."""
    if isinstance(cause, FileNotFoundError) and cause.filename:
        return _nearest_file(os.fspath(cause.filename))
    text = str(cause)
    if text.startswith("unknown macro name: "):
        name = text.rpartition(" ")[2].removeprefix("xacro:")
        meant = did_you_mean(name, (macro.name for macro in run.macros))
        return f"define the macro before its call, or include the file that does{meant}"
    undefined = _UNDEFINED.search(text)
    if undefined is None or not isinstance(cause, NameError):
        return ""
    name = undefined.group(1)
    meant = did_you_mean(name, (definition.name for definition in run.properties))
    return f"define the property '{name}' before its use, or mend its name{meant}"


def _nearest_file(path: str) -> str:
    """What there is instead of a missing file: a folder that is missing, or a file like it."""
    folder, name = os.path.split(os.path.normpath(path))
    while folder and not os.path.isdir(folder) and folder != os.path.dirname(folder):
        folder, name = os.path.split(folder)
    try:
        beside = os.listdir(folder or os.curdir)
    except OSError:
        return ""
    stem, dot, suffix = name.partition(".")
    alike = [other.partition(".")[0] for other in beside if other.endswith(dot + suffix)]
    meant = nearest(stem, alike)
    what = f"there is no '{name}' in {folder or os.curdir}"
    return f"{what}; did you mean '{meant}{dot}{suffix}'?" if meant else what


def used_too_early(name: str, declaration: Node, frame: FrameType) -> Problem:
    """An argument that is used above the ``<xacro:arg>`` that gives it a default."""
    node, _ = node_in(frame)
    at = declaration.tag_at.span if node is None else node.tag_at.span
    use = re.compile(rb"\$\(\s*arg\s+%s\s*\)" % re.escape(name.encode()))
    if found := use.search(at.source.data, at.start, at.end):
        at = Span(at.source, *found.span())
    return Problem(
        "XAC020",
        at,
        f"argument '{name}' is used above its <xacro:arg>, where xacro does not know its default yet",
        f"move the <xacro:arg> above the first use, or pass {name}:=VALUE",
        node.frame if node is not None else None,
        related(declaration.tag_at.span, "declared here"),
    )


def with_macro(error: BaseException, message: str) -> tuple[str, tuple[Related, ...]]:
    """An error of a call, with the macro's name and the place of its definition."""
    macros = getattr(error, "macros", [])
    body = getattr(macros[0], "body", None) if macros else None
    if not isinstance(body, Node):
        return message, ()
    name = body.getAttribute("name")
    notes = related(body.tag_at.span, f"macro '{name}' is defined here")
    return f"macro '{name}': {message}", notes


def warning(text: str, node: Node) -> Problem | None:
    """What xacro warns of, at the element it works on; None if it does no harm."""
    spans = node.tag_at.attribute_spans()
    if text.startswith("redefining global symbol: "):
        name = text.rpartition(": ")[2]
        if _is_built_in(name, node):
            return None
        message = f"'{name}' hides what expressions already have under this name"
        at = spans.get("name", node.tag_at.span) if node.tagName == "xacro:property" else None
        return Problem("XAC016", at or spans.get(name, node.tag_at.span), message, "", node.frame)
    if deprecated := _DEPRECATED.match(text):
        return _deprecated_call(node, *deprecated.groups())
    return Problem("XAC017", node.tag_at.span, text, "", node.frame)


def _is_built_in(name: str, node: Node) -> bool:
    """True for a property that repeats a constant of expressions; XAC007 tells poor ones."""
    constant = {"pi": math.pi, "e": math.e, "tau": math.tau}.get(name)
    values = dict(zip(node.raw[::2], node.raw[1::2], strict=True))
    try:
        return constant is not None and abs(float(values.get("value", "")) - constant) < 1e-4
    except ValueError:
        return False


def _deprecated_call(node: Node, old: str, new: str) -> Problem:
    """A function that moved into a name space; the fix renames the one call in the tag."""
    message = f"{old}() without its name space is deprecated"
    pattern = re.compile(rb"(?<![\w.])" + old.encode() + rb"(?=\s*\()")
    at = node.tag_at.span
    found = pattern.search(at.source.data, at.start, at.end)
    if found is None:
        return Problem("XAC015", at, message, f"write {new}()", node.frame)
    span = Span(at.source, *found.span())
    fix = Fix(f"write {new}", (Edit(span, new),), safe=True)
    return Problem("XAC015", span, message, f"write {new}()", node.frame, fix=fix)
