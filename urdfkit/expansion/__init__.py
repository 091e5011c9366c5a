"""xacro files as Documents: expanded without ROS, with the place of every element.

This package is the only one that uses xacro.
"""

from __future__ import annotations

import gc
import os
from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any
from xml.parsers.expat import ExpatError

from urdfkit.document import Attribute, Document, Frame
from urdfkit.expansion import describe, dom
from urdfkit.expansion.engine import activated, load_xacro
from urdfkit.expansion.errors import root_cause
from urdfkit.expansion.part import as_part
from urdfkit.expansion.run import Definition, Message, Run
from urdfkit.expansion.trace import Origin, inputs_of
from urdfkit.expansion.usage import Usage, usage
from urdfkit.reading import (
    Problem,
    TooMuch,
    encoding_problems,
    syntax_problems,
    unbound_prefixes,
)
from urdfkit.source import Source, Span

if TYPE_CHECKING:
    from urdfkit.resolve import Resolver

#: Structural errors of one file; every one costs another run.
MAX_RUNS = 50

_UNBOUND_PREFIX = 27  # expat's XML_ERROR_UNBOUND_PREFIX


class Xacro:
    """The outcome of an expansion.

    Attributes:
        document: expanded; None if there was an error.
        problems: errors and warnings, each with its place.
        macros, properties, arguments: what the files define.
        messages: of xacro and of the model, in order.
        sources: the xacro files that were read, the checked one first.
        data_files: paths of the YAML files that were read.
        dependencies: included and loaded files, as the models spell them.
        first_error: text of the first error, as stock xacro words it; None without one.
    """

    def __init__(self, run: Run, problems: list[Problem], first_error: str | None) -> None:
        self.problems = tuple(problems)
        self.macros: tuple[Definition, ...] = tuple(run.macros)
        self.properties: tuple[Definition, ...] = tuple(run.properties)
        self.arguments: tuple[Definition, ...] = tuple(run.declared)
        self.messages: tuple[Message, ...] = tuple(run.messages)
        self.sources = tuple(run.sources.values())
        self.data_files = tuple(dict.fromkeys(run.data_files))
        self.dependencies = tuple(dict.fromkeys(load_xacro().all_includes))
        self.first_error = first_error
        self._included = frozenset(run.included)
        self._dom = run.document if first_error is None else None
        self.document: Document | None = None
        if self._dom is not None:
            self.document = dom.to_document(self._dom, self.sources)

    @cached_property
    def usage(self) -> Usage:
        """What the files mention, evaluated or not."""
        return usage(self.sources)

    @property
    def is_complete(self) -> bool:
        """True if every include of the files was read, so that nothing else can use a name."""
        return self.usage.includes <= self._included

    @property
    def is_library(self) -> bool:
        """True if the file only defines macros for others."""
        return self.document is not None and not self.document.root.child("link")

    def inputs(self, attribute: Attribute) -> tuple[Origin, ...]:
        """The names that the expression of an attribute looked up, if the run was traced."""
        assert self._dom is not None
        return inputs_of(self._dom, attribute.element, attribute.name)

    def comments(self) -> Iterator[str]:
        """The comments of the expanded document; xacro drops those above its own tags."""
        return dom.comments(self._dom) if self._dom is not None else iter(())

    def text(self) -> str:
        """The expanded document as the ``xacro`` command prints it.

        Raises:
            ValueError: there is none, because of an error.
        """
        if self._dom is None:
            raise ValueError(self.first_error)
        return str(self._dom.toprettyxml(indent="  "))


def expand(
    source: Source,
    resolver: Resolver,
    arguments: Mapping[str, str] | None = None,
    *,
    trust: bool = False,
    root_dir: str = os.curdir,
    traced: bool = False,
    frame: Frame | None = None,
) -> Xacro:
    """Expand a xacro file.

    All errors are found, not the first only: an expression that fails counts as reported and
    the expansion goes on; a tag that fails is taken out and the expansion starts again.

    Args:
        source: the file.
        resolver: finds packages, and knows which files may be read.
        arguments: values of ``xacro:arg`` by name.
        trust: run expressions unfenced, read any file and variable.
        root_dir: relative paths of the command line start there.
        traced: note where every value comes from, for ``Xacro.inputs``; slower.
        frame: the launch file that asks for it, if one does.
    """
    collecting = gc.isenabled()
    gc.disable()  # the trees are large and live until the end
    try:
        options = {"trust": trust, "root_dir": root_dir, "traced": traced, "frame": frame}
        return _expand(source, resolver, dict(arguments or {}), **options)
    finally:
        if collecting:
            gc.enable()


def _expand(source: Source, resolver: Resolver, arguments: dict[str, str], **options: Any) -> Xacro:
    structural: list[Problem] = []
    first_error: str | None = None
    without: set[tuple[str, int]] = set()
    lost: set[str] = set()
    while True:
        run = Run(
            source,
            resolver,
            arguments,
            without=frozenset(without),
            lost=frozenset(lost),
            **options,
        )
        error = _attempt(run)
        first_error = first_error or run.first_error
        if error is None:
            break
        first_error = first_error or _stock_text(error)
        found, node = _structural(run, error)
        structural += [problem for problem in found if problem not in structural]
        if node is None or len(without) >= MAX_RUNS:
            break
        without.add((node.tag_at.source.path, node.tag_at.start))
        lost |= _names_lost(node)
    encodings = [
        problem for one in run.sources.values() for problem in encoding_problems(one, strict=True)
    ]
    problems = [*encodings, *structural, *run.problems]
    if first_error is not None:
        problems = as_part(source, resolver.packages, problems)
    return Xacro(run, problems, first_error)


def _attempt(run: Run) -> BaseException | None:
    """Expand once; the error that stopped it, or None."""
    with activated(run) as xacro:
        try:
            run.document = xacro.process_file(run.source.path, mappings=dict(run.arguments))
        except (Exception, RecursionError, MemoryError) as error:
            return error
    return None


def _stock_text(error: BaseException) -> str:
    """An error in the words of the ``xacro`` command."""
    if isinstance(error, ExpatError):
        return f"XML parsing error: {error}"
    return str(error) or repr(error)


def _structural(run: Run, error: BaseException) -> tuple[list[Problem], dom.Node | None]:
    """What stopped an expansion, and the tag to take out before the next attempt."""
    if isinstance(error, ExpatError):
        return _not_well_formed(run, error)
    traceback = error.__traceback__
    while traceback is not None and traceback.tb_next is not None:
        traceback = traceback.tb_next
    node, _ = describe.node_in(traceback.tb_frame if traceback else None)
    if "*" in run.lost and str(error).startswith("unknown macro name") and node is not None:
        return [], node
    code, message, help = describe.classify(run, error)
    detached = node is not None and node.parentNode is None and node.tagName != "xacro:property"
    if code == "XAC013" or node is None or detached:
        at = node.tag_at.span if node is not None else Span(run.source, 0, 0)
        frame = node.frame if node is not None else None
        return [Problem(code, at, message, help, frame)], None
    at = _at(node, str(error))
    notes = describe.macro_notes(error)
    return [Problem(code, at, message, help, node.frame, notes)], node


def _at(node: dom.Node, message: str) -> Span:
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


def _names_lost(node: dom.Node) -> set[str]:
    """Names that lack once a tag is taken out; an include says so itself when its turn comes."""
    if node.tagName in ("xacro:property", "xacro:macro"):
        return {node.getAttribute("name")}
    return set()


def _not_well_formed(run: Run, error: ExpatError) -> tuple[list[Problem], dom.Node | None]:
    source: Source = getattr(error, "urdfkit_source", run.source)
    frame: Frame | None = getattr(error, "urdfkit_frame", None)
    if error.code == _UNBOUND_PREFIX:
        found = [problem._replace(frame=frame) for problem in unbound_prefixes(source)]
    else:
        found = [problem._replace(frame=frame) for problem in syntax_problems(source)]
    return found, run.including[-1] if run.including else None


__all__ = ["Definition", "Message", "TooMuch", "Xacro", "expand", "load_xacro", "root_cause"]
