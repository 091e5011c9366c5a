"""Messages about properties and macros that are not defined where they are used."""

import os
import re
from collections.abc import Iterator

from urdfkit.core.suggest import TYPO, did_you_mean, nearest
from urdfkit.text.comments import blank_comments
from urdfkit.text.schema import XACRO_TAGS
from urdfkit.text.source import Span, shown
from urdfkit.xacro.definitions import Definitions
from urdfkit.xacro.errors import IN_CONDITION, MessageText

#: In Python's message of a NameError.
UNDEFINED = re.compile(r"name '(\w+)' is not defined")
#: Values of Python, by their names in other languages.
_LITERALS = {"true": "True", "false": "False", "none": "None", "null": "None"}
_INCLUDED_AS = re.compile(rb"""<xacro:include\b[^<>]*\bns\s*=\s*["']([\w.-]+)["']""")
_BARE_INCLUDE = re.compile(rb"<include\s[^<>]*\bfilename\s*=")
_BARE_HELP = "write <xacro:include>: xacro ignores an <include> without the prefix"
_BARE_PROPERTY = rb"""<property\s[^<>]*?\bname\s*=\s*["']%s["'][^<>]*>"""
_DEFINED = re.compile(rb"""<xacro:(property|macro)\b[^<>]*?\bname\s*=\s*["']([\w:]+)["']""")
_NAMESPACE = re.compile(rb"""\sns\s*=\s*["']([\w.]+)""")
_OPENED = re.compile(rb"<xacro:(if|unless|macro)\b[^<>]*(?<!/)>|</xacro:(?:if|unless|macro)\s*>")


def unknown_macro(defined: Definitions, name: str) -> MessageText:
    """The message for the call of a macro that is not defined."""
    known = [macro.name for macro in defined.macros]
    if tag := nearest(name, XACRO_TAGS, TYPO):
        known.append(tag)
    if elsewhere := _defined_elsewhere(defined, "macro", name):
        return MessageText(f"macro '{name}' is not defined", elsewhere)
    space, _, bare = name.rpartition(".")
    if space and bare in known:  # in another namespace: no other name is meant
        known = [f"{namespace}.{bare}" for namespace in _namespaces(defined)]
    help = "define the macro above its call, or include the file that does"
    if _has_bare_include(defined):
        help = _BARE_HELP
    return MessageText(f"macro '{name}' is not defined", help + did_you_mean(name, known))


def undefined_name(defined: Definitions, text: str, name: str) -> MessageText:
    """The message for an expression with a name that is not defined."""
    if elsewhere := _defined_elsewhere(defined, "property", name):
        return MessageText(text, elsewhere)
    if any(argument.name == name for argument in defined.arguments):
        use = f"write $(arg {name}), or define a property of this value above the use"
        return MessageText(text, f"'{name}' is an argument: {use}")
    if literal := _LITERALS.get(name):
        return MessageText(text, f"write {literal}")
    known = [property_name for _, property_name in _definitions(defined, "property")]
    hint = did_you_mean(name, known)
    help = f"define the property '{name}' above its use, or correct the name"
    if not hint and _has_bare_include(defined):
        help = _BARE_HELP
    return MessageText(text, help + hint)


def _has_bare_include(defined: Definitions) -> bool:
    sources = defined.sources.values()
    return any(_BARE_INCLUDE.search(blank_comments(source.data)) for source in sources)


def bare_property(defined: Definitions, cause: BaseException) -> tuple[str, Span] | None:
    """An undefined name, and the ``<property>`` without prefix that should define it."""
    match = UNDEFINED.search(str(cause)) if isinstance(cause, NameError) else None
    if match is None:
        return None
    pattern = re.compile(_BARE_PROPERTY % re.escape(match.group(1)).encode())
    for source in defined.sources.values():
        if tag := pattern.search(blank_comments(source.data)):
            return match.group(1), Span(source, tag.start(), tag.end())
    return None


def _namespaces(defined: Definitions) -> list[str]:
    """The namespaces in which files are included."""
    texts = (source.data for source in defined.sources.values())
    names = (name for text in texts for name in _INCLUDED_AS.findall(blank_comments(text)))
    return list(dict.fromkeys(name.decode("utf-8", "replace") for name in names))


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
    pattern = re.compile(rb"""<xacro:include\b[^<>]*%s["'][^<>]*>""" % file)
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
