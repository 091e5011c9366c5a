"""Tags that fail: what is reported of them, and how the expansion does without them."""

from __future__ import annotations

from xml.parsers.expat import ExpatError

from urdfkit.core.record import Record
from urdfkit.text.diagnostic import Problem
from urdfkit.text.source import Span
from urdfkit.text.xml_reader import syntax_problems, unbound_prefixes
from urdfkit.xacro import diagnosis
from urdfkit.xacro.dom import Node
from urdfkit.xacro.errors import is_of_process, root_cause
from urdfkit.xacro.expansion import ExpansionRun
from urdfkit.xacro.expansion_log import ANY

_UNBOUND_PREFIX = 27  # expat's XML_ERROR_UNBOUND_PREFIX


class _Failure(Record):
    """The problems that an error stands for, and the tag to take out; None if that cannot help."""

    problems: list[Problem]
    node: Node | None


def take_out(run: ExpansionRun, error: BaseException) -> bool:
    """Report an error that stopped an expansion.

    Returns:
        True if the expansion can go on without the tag that failed.
    """
    return _report(run, error, _failure(run, error, _failed_tag(error)))


def take_out_tag(run: ExpansionRun, error: Exception, tag: Node) -> bool:
    """Report an error if it is one of a tag without which the expansion can go on; True if so."""
    if is_of_process(error) or _failed_tag(error) is not tag:
        return False
    failure = _failure(run, error, tag)
    return failure.node is not None and _report(run, error, failure)


def _failed_tag(error: BaseException) -> Node | None:
    """The innermost tag that xacro worked on when an error arose."""
    traceback = error.__traceback__
    while traceback is not None and traceback.tb_next is not None:
        traceback = traceback.tb_next
    return diagnosis.node_in(traceback.tb_frame if traceback else None)[0]


def _report(run: ExpansionRun, error: BaseException, failure: _Failure) -> bool:
    log = run.log
    log.first_error = log.first_error or _stock_words(error)
    for problem in failure.problems:
        log.add(problem)
    return failure.node is not None and log.take_out(failure.node.tag_at, _names_lost(failure.node))


def _stock_words(error: BaseException) -> str:
    """An error in the words of the ``xacro`` command."""
    if isinstance(error, ExpatError):
        return f"XML parsing error: {error}"
    return str(error) or repr(error)


def _failure(run: ExpansionRun, error: BaseException, node: Node | None) -> _Failure:
    if isinstance(error, ExpatError):
        return _not_well_formed(error)
    if wanting := diagnosis.argument_of_missing_file(run.defined, root_cause(error)):
        return _Failure([wanting], node)
    code, message, help = diagnosis.classify(run.defined, error)
    if node is None:
        return _Failure([Problem(code, Span(run.request.source, 0, 0), message, help)], None)
    taken_out = node.parentNode is None and node.tagName != "xacro:property"
    if code == "XAC013" or taken_out:
        return _Failure([Problem(code, node.tag_at.span, message, help, node.frame)], None)
    if run.log.is_consequence(error):
        return _Failure([], node)
    notes = diagnosis.macro_notes(error)
    at = _at(node, str(error))
    return _Failure([Problem(code, at, message, help, node.frame, notes)], node)


def _at(node: Node, message: str) -> Span:
    """The attribute that an error of stock xacro names, else the tag's name."""
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


def _names_lost(node: Node) -> set[str]:
    """Names that lack once a tag is taken out."""
    if node.tagName == "xacro:include":
        return {ANY}
    if node.tagName in ("xacro:property", "xacro:macro", "xacro:arg"):
        name = node.getAttribute("name")
        return {ANY if "$" in name else name}
    return set()


def _not_well_formed(error: ExpatError) -> _Failure:
    source, frame, include = error.urdfkit_place  # type: ignore[attr-defined]
    find = unbound_prefixes if error.code == _UNBOUND_PREFIX else syntax_problems
    return _Failure([problem._replace(frame=frame) for problem in find(source)], include)
