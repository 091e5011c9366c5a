"""What a file of a robot defines, but an argument disables."""

import os
import re
from functools import lru_cache

from urdfkit.core import disk
from urdfkit.errors import PackageNotFound
from urdfkit.lint.context import Context
from urdfkit.lint.include_graph import INCLUDE
from urdfkit.text.comments import blank_comments, without_comments
from urdfkit.text.source import Source
from urdfkit.workspace.package_references import FIND
from urdfkit.workspace.resolve import Resolver

#: The name of a link or joint, behind the expressions that it begins with; the joints of other
#: elements, such as ``<ros2_control>``, have no type.
_DEFINITION = (
    rb"""<(?:link|joint(?=[^<>]*\stype\s*=))\b[^<>]*?"""
    rb"""\bname\s*=\s*["'](?:\$[({][^)}"'<>]*[)}])*([^"'<>$]+)["']"""
)

#: A macro with its name and body.
_MACRO = (
    rb"""(?s)<xacro:macro\b[^<>]*?\bname\s*=\s*["'](?:xacro:)?([^"'<>]+)["'][^<>]*>"""
    rb"""(.*?)</xacro:macro>"""
)
#: A call with the name of its macro, or one whose macro an expression names.
_CALL = rb"<xacro:(?:[\w-]+\.)?([\w-]+)"


def is_switched_off(context: Context, name: str) -> bool:
    """True if a file of the robot defines a link or joint inside a false condition.

    The condition may be that of its include.

    The joint of a controller may have the name of a link by mistake. A definition behind a prefix
    is in no false condition if the robot has the name with a prefix.
    """
    expanded, model = context.reading.xacro, context.model
    known = (*model.links_by_name, *model.joints_by_name)
    if expanded is None or any(other.endswith(name) for other in known):
        return False
    return name in _defined(all_sources(context))


def uncalled_macro(context: Context, name: str) -> str:
    """The macro that defines a link or joint, and that the robot does not call; empty if none."""
    return _in_uncalled_macros(all_sources(context)).get(name, "")


def all_sources(context: Context) -> tuple[Source, ...]:
    """The files of a xacro, with those whose includes are inside a false condition."""
    expanded = context.reading.xacro
    return _with_unread(expanded.sources, context.resolver) if expanded else ()


@lru_cache(maxsize=1)
def _with_unread(sources: tuple[Source, ...], resolver: Resolver) -> tuple[Source, ...]:
    found = {disk.real(source.path): source for source in sources}
    queue = list(sources)
    while queue:
        source = queue.pop()
        for name in re.findall(INCLUDE, without_comments(source.data)):
            path = _included(name.decode("utf-8", "replace"), source.path, resolver)
            if path and disk.real(path) not in found and (own := resolver.readable(path)):
                found[disk.real(path)] = own
                queue.append(own)
    return tuple(found.values())


def _included(name: str, near: str, resolver: Resolver) -> str | None:
    """The path of an include; None if it has an expression."""
    try:
        text = re.sub(FIND, lambda match: resolver.package(match.group(1), near), name)
    except PackageNotFound:
        return None
    directory = os.path.dirname(os.path.abspath(near))
    text = text.replace("$(dirname)", directory)
    return None if "$" in text or "\0" in text else os.path.join(directory, text)


@lru_cache(maxsize=1)  # a robot may have many unknown references
def _defined(sources: tuple[Source, ...]) -> frozenset[str]:
    """The names of the links and joints in some files, without expressions at their beginning."""
    found = (re.findall(_DEFINITION, blank_comments(source.data)) for source in sources)
    return frozenset(name.decode("utf-8", "replace") for names in found for name in names)


@lru_cache(maxsize=1)
def _in_uncalled_macros(sources: tuple[Source, ...]) -> dict[str, str]:
    """The links and joints that only uncalled macros define, with the macro of each."""
    texts = [blank_comments(source.data) for source in sources]
    called = {name for text in texts for name in re.findall(_CALL, text)}
    if b"call" in called:  # of a macro that an expression names
        return {}
    found: dict[bytes, bytes] = {}
    elsewhere = set[bytes]()
    for text in texts:
        for macro in re.finditer(_MACRO, text):
            if macro[1] not in called:
                found.update(dict.fromkeys(re.findall(_DEFINITION, macro[2]), macro[1]))
        rest = re.sub(_MACRO, lambda macro: macro[0] if macro[1] in called else b"", text)
        elsewhere.update(re.findall(_DEFINITION, rest))
    return {
        name.decode("utf-8", "replace"): macro.decode("utf-8", "replace")
        for name, macro in found.items()
        if name not in elsewhere
    }
