"""Tags that fail: their problems, and their removal so that the expansion can continue."""

from __future__ import annotations

import re
from xml.parsers.expat import ExpatError

from urdfkit.core.record import Record
from urdfkit.errors import PackageNotFound
from urdfkit.text.diagnostic import Problem
from urdfkit.text.source import Span, shown
from urdfkit.text.xml_reader import syntax_problems, unbound_prefixes
from urdfkit.xacro import diagnosis
from urdfkit.xacro.dom import Node
from urdfkit.xacro.errors import is_out_of_memory, root_cause
from urdfkit.xacro.expansion import ExpansionRun
from urdfkit.xacro.expansion_log import ANY
from urdfkit.xacro.missing_files import next_to, relative_to_caller

#: A file of a package, as xacro includes it.
_FOUND = re.compile(r"\s*\$\(find\s+([\w-]+)\)/")
_UNBOUND_PREFIX = 27  # expat's XML_ERROR_UNBOUND_PREFIX


class _Failure(Record):
    """The problems of an error, and the tag to remove; None if the expansion cannot continue."""

    problems: list[Problem]
    node: Node | None


def remove_failed_tag(run: ExpansionRun, error: BaseException) -> bool:
    """Report an error that stopped an expansion.

    Returns:
        True if the expansion can be repeated without the tag that failed.
    """
    return _report(run, error, _failure(run, error, _failed_tag(error)))


def remove_tag(run: ExpansionRun, error: Exception, tag: Node) -> bool:
    """Report the error of a tag and return True, if the expansion can continue without the tag."""
    if is_out_of_memory(error) or _failed_tag(error) is not tag:
        return False
    failure = _failure(run, error, tag)
    return failure.node is not None and _report(run, error, failure)


def _failed_tag(error: BaseException) -> Node | None:
    """The innermost tag that xacro was processing when an error was raised."""
    traceback = error.__traceback__
    while traceback is not None and traceback.tb_next is not None:
        traceback = traceback.tb_next
    return diagnosis.node_in(traceback.tb_frame if traceback else None)[0]


def _report(run: ExpansionRun, error: BaseException, failure: _Failure) -> bool:
    log = run.log
    log.first_error = log.first_error or _stock_message(error)
    for problem in failure.problems:
        log.add_error(problem)
    node = failure.node
    return node is not None and log.remove(node.tag_at, _defined_names(node))


def _stock_message(error: BaseException) -> str:
    """The message of the ``xacro`` command for an error."""
    if isinstance(error, ExpatError):
        return f"XML parsing error: {error}"
    return str(error) or repr(error)


def _failure(run: ExpansionRun, error: BaseException, node: Node | None) -> _Failure:
    error = _without_manifest(run, error, node) or error
    if isinstance(error, ExpatError):
        return _not_well_formed(error)
    written = node.tag_at.span.text if node else ""
    if missing := diagnosis.argument_of_missing_file(run.defined, root_cause(error), written):
        return _Failure([missing], node)
    code, message, help = diagnosis.classify(run.defined, error)
    if node is None:
        return _Failure([Problem(code, Span(run.request.source, 0, 0), message, help)], None)
    if node.frame and node.frame.kind == "macro":
        text = relative_to_caller(root_cause(error), node.tag_at.source.path)
        message, help = text or (message, help)
    elif node.tagName == "xacro:include" and message.startswith("file not found"):
        help = next_to(root_cause(error), node.tag_at.source.path) or help
    is_removed = node.parentNode is None and node.tagName != "xacro:property"
    if code == "XAC013" or is_removed:
        return _Failure([Problem(code, node.tag_at.span, message, help, node.frame)], None)
    if run.log.is_consequence(error):
        return _Failure([], node)
    notes = diagnosis.macro_notes(error)
    at = _at(node, str(error))
    return _Failure([Problem(code, at, message, help, node.frame, notes)], node)


def _without_manifest(
    run: ExpansionRun, error: BaseException, node: Node | None
) -> PackageNotFound | None:
    """The error for a file of a package of which only a part is here, without its package.xml.

    ROS finds the package, and the file, elsewhere. A workspace without any package is a copy, whose
    directories stand for its packages.
    """
    is_missing = isinstance(root_cause(error), FileNotFoundError)
    found = _FOUND.match(node.getAttribute("filename")) if node and is_missing else None
    if node is None or found is None:
        return None
    near, packages = node.tag_at.source.path, run.request.resolver.packages
    candidates = list(packages.candidates(found[1], near))
    if any(one.certain for one in candidates) or not packages.known(near):
        return None
    partial = (f"{shown(one.directory)} (no package.xml)" for one in candidates)
    return PackageNotFound(found[1], (*partial, *packages.searched(found[1], near)))


def _at(node: Node, message: str) -> Span:
    """The span of the attribute in an error message of stock xacro, or of the tag's name."""
    spans = node.tag_at.attribute_spans()
    if node.tagName == "xacro:include":
        return spans.get("filename", node.tag_at.span)
    if message.startswith("unknown macro name"):
        return node.tag_at.name_span
    if "'_setitem'" in message and "scope" in spans:
        return spans["scope"]
    for name in spans:
        if f'Invalid parameter "{name}"' in message or f'conditional "{name}"' in message:
            return spans[name]
    if node.tagName in ("xacro:if", "xacro:unless"):
        return spans.get("value", node.tag_at.span)
    return spans.get("name", node.tag_at.name_span) if "name" in message else node.tag_at.name_span


def _defined_names(node: Node) -> set[str]:
    """The names that a tag defines."""
    if node.tagName == "xacro:include":
        return {ANY}
    if node.tagName in ("xacro:property", "xacro:macro", "xacro:arg"):
        name = node.getAttribute("name")
        return {ANY if "$" in name else name}
    return set()


def _not_well_formed(error: ExpatError) -> _Failure:
    source, frame, include = error.urdfkit_location  # type: ignore[attr-defined]
    find = unbound_prefixes if error.code == _UNBOUND_PREFIX else syntax_problems
    return _Failure([problem._replace(frame=frame) for problem in find(source)], include)
