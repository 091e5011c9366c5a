"""Expanding on to the next error: a tag that fails is taken out, and the expansion starts again."""

from __future__ import annotations

import os
from xml.parsers.expat import ExpatError

from urdfkit.core.record import Record
from urdfkit.text.diagnostic import Problem
from urdfkit.text.source import Span
from urdfkit.text.xml_reader import syntax_problems, unbound_prefixes
from urdfkit.xacro.budget import deadline
from urdfkit.xacro.dom import Node
from urdfkit.xacro.engine import load_engine
from urdfkit.xacro.errors import root_cause
from urdfkit.xacro.expansion import ExpansionRequest, ExpansionRun
from urdfkit.xacro.expansion_log import ANY, ExpansionLog
from urdfkit.xacro.file_reader import FileReader
from urdfkit.xacro.watchdog import watched

#: Failing tags of one file; every one costs another run.
MAX_RUNS = 50

_UNBOUND_PREFIX = 27  # expat's XML_ERROR_UNBOUND_PREFIX


class _Failure(Record):
    """What stopped a run, and the tag to take out before the next; None if that cannot help."""

    problems: list[Problem]
    node: Node | None


def attempt(request: ExpansionRequest) -> ExpansionRun:
    """Expand a file as far as it goes.

    Returns:
        The last run; its log has the problems of all.
    """
    log = ExpansionLog()
    near = os.path.join(request.root_dir, request.source.path)
    reader = FileReader(request.source, request.resolver, near=near, trust=request.trust)
    without: set[tuple[str, int]] = set()
    lost: set[str] = set()
    until = deadline()
    while True:
        log.begin(lost)
        run = ExpansionRun(request, frozenset(without), log, reader, until)
        error = _once(run)
        if error is None:
            return run
        log.first_error = log.first_error or _stock_words(error)
        failure = _failure(run, error)
        for problem in failure.problems:
            log.add(problem)
        if failure.node is None or len(without) >= MAX_RUNS:
            return run
        without.add((failure.node.tag_at.source.path, failure.node.tag_at.start))
        lost |= _names_lost(failure.node)


def _once(run: ExpansionRun) -> BaseException | None:
    """Expand once; the error that stopped it, or None."""
    try:
        with watched(run.budget):
            run.document = load_engine().expand(run)
    except (Exception, RecursionError, MemoryError) as error:
        # Nothing that an expansion imports is missing.
        if isinstance(root_cause(error), (MemoryError, ImportError)):
            return run.budget.out_of_memory().with_traceback(error.__traceback__)
        return error
    return None


def _stock_words(error: BaseException) -> str:
    """An error in the words of the ``xacro`` command."""
    if isinstance(error, ExpatError):
        return f"XML parsing error: {error}"
    return str(error) or repr(error)


def _failure(run: ExpansionRun, error: BaseException) -> _Failure:
    from urdfkit.xacro import diagnosis  # which a run without errors does without

    if isinstance(error, ExpatError):
        return _not_well_formed(error)
    traceback = error.__traceback__
    while traceback is not None and traceback.tb_next is not None:
        traceback = traceback.tb_next
    node, _ = diagnosis.node_in(traceback.tb_frame if traceback else None)
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
    """Names that lack once a tag is taken out; an include says so itself when its turn comes."""
    if node.tagName in ("xacro:property", "xacro:macro", "xacro:arg"):
        name = node.getAttribute("name")
        return {ANY if "$" in name else name}
    return set()


def _not_well_formed(error: ExpatError) -> _Failure:
    source, frame, include = error.urdfkit_place  # type: ignore[attr-defined]
    find = unbound_prefixes if error.code == _UNBOUND_PREFIX else syntax_problems
    return _Failure([problem._replace(frame=frame) for problem in find(source)], include)
