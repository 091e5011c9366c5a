"""Expansion of xacro files into Documents, without ROS, with the source location of every element.

Only this package imports xacro.
"""

import gc
import os
from collections.abc import Iterator, Mapping
from functools import cached_property

from urdfkit.text.document import Attribute, CallFrame, Document, Element
from urdfkit.text.source import Source
from urdfkit.text.xml_declaration import encoding_problems
from urdfkit.workspace.resolve import Resolver
from urdfkit.xacro import dom
from urdfkit.xacro.definitions import Definition
from urdfkit.xacro.errors import FAILED
from urdfkit.xacro.expansion import ExpansionRequest, ExpansionRun
from urdfkit.xacro.expansion_log import Message
from urdfkit.xacro.origin import DataPlaces, Origin
from urdfkit.xacro.recovery import expand_repeatedly
from urdfkit.xacro.usage import Usage, usage


class Xacro:
    """The result of an expansion.

    Attributes:
        document: the expanded document; None after an error.
        problems: errors and warnings with their source locations.
        macros, properties, arguments: the definitions in the files.
        defaults: of the arguments, by name, as written; empty for an argument without a default.
        messages: of xacro and of the model, in order.
        sources: the xacro files that were read, the checked file first.
        data_files: paths of the YAML files that were read.
        dependencies: included and loaded files, also missing ones, as the models spell them.
        first_error: text of the first error, as in stock xacro; None without an error.
    """

    def __init__(self, run: ExpansionRun, resolver: Resolver) -> None:
        log = run.log
        self.sources = tuple(run.reader.sources.values())
        problems = [
            *(item for source in self.sources for item in encoding_problems(source, strict=True)),
            *log.problems,
        ]
        if log.first_error is not None:
            from urdfkit.xacro.fragment import merge_missing_names

            problems = merge_missing_names(self.sources, resolver.packages, problems, run.document)
        self._included = frozenset(run.included)
        if log.first_error is not None and not self.is_complete:
            # A file that was not included may use the first value of a property.
            problems = [problem for problem in problems if problem.code != "XAC008"]
        self.problems = tuple(problems)
        self.macros = tuple(run.defined.macros)
        self.properties = tuple(run.defined.properties)
        self.arguments = tuple(run.defined.arguments)
        self.defaults = run.defined.argument_defaults
        self.messages = tuple(log.messages)
        self.data_files = tuple(dict.fromkeys(run.reader.data_files))
        paths = (path for path in run.dependencies if FAILED not in path)
        self.dependencies = tuple(dict.fromkeys(paths))
        self.first_error = log.first_error
        self._dom = run.document if log.first_error is None else None
        self.document: Document | None = None
        if self._dom is not None:
            self.document = dom.to_document(self._dom, self.sources)
        self._lacking = run.document if self.first_error and log.lacks_only_packages else None

    @cached_property
    def without_packages(self) -> Document | None:
        """The part of the document that needs no package that is not found; None if it is whole.

        None also after another error, and if the place of a link is not known.
        """
        if self._lacking is None:
            return None
        from urdfkit.xacro.partial import without_failed_values

        return without_failed_values(self._lacking, self.sources)

    @cached_property
    def has_all_links(self) -> bool:
        """True if what is missing without packages that are not found are shapes and plugins.

        Only tags that are not xacro's name the packages then, and no include is missing.
        """
        known = self.without_packages or self.document
        if known is None or self._lacking is None:
            return known is not None
        from urdfkit.xacro.partial import lacks_no_link

        return lacks_no_link(self._lacking, known, self.problems)

    @cached_property
    def usage(self) -> Usage:
        """The names that the files use, evaluated or not."""
        return usage(self.sources)

    @property
    def is_complete(self) -> bool:
        """True if all includes of the files were read, so that no other file can use a name."""
        return not self.unread_includes

    @property
    def unread_includes(self) -> frozenset[tuple[str, int]]:
        """The include tags that were not evaluated: the path of the file and the offset of each."""
        return self.usage.includes - self._included

    @property
    def is_library(self) -> bool:
        """True if the file only defines macros for other files."""
        return self.document is not None and not self.document.root.child("link")

    def inputs(self, attribute: Attribute) -> tuple[Origin, ...]:
        """The names that the expression of an attribute looked up, if the run was traced."""
        from urdfkit.xacro.trace import inputs_of

        assert self._dom is not None
        return inputs_of(self._dom, attribute.element, attribute.name)

    def data_places(self, at: Element | Attribute) -> DataPlaces | None:
        """The places in YAML files of the values of an attribute or element, if traced."""
        from urdfkit.xacro.trace import data_places

        return data_places(self._dom, at) if self._dom is not None else None

    def comments(self) -> Iterator[str]:
        """The comments of the expanded document; xacro drops comments above its own tags."""
        return dom.comments(self._dom) if self._dom is not None else iter(())

    def text(self) -> str:
        """The expanded document as the ``xacro`` command prints it.

        Raises:
            ValueError: the expansion failed.
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
    frame: CallFrame | None = None,
) -> Xacro:
    """Expand a xacro file.

    All errors are found, not only the first: an expression or tag that fails is reported, and the
    expansion continues without it.

    Args:
        source: the file.
        resolver: finds packages, and decides which files may be read.
        arguments: values of ``xacro:arg`` by name.
        trust: do not sandbox expressions, read any file and variable.
        root_dir: base directory of relative paths of the command line.
        traced: record the origin of every value, for ``Xacro.inputs``; slower.
        frame: the launch file that loads it, if any.
    """
    collecting = gc.isenabled()
    gc.disable()  # the trees are large and needed until the end
    try:
        values = dict(arguments or {})
        request = ExpansionRequest(source, resolver, values, trust, root_dir, traced, frame)
        return Xacro(expand_repeatedly(request), resolver)
    finally:
        if collecting:
            gc.enable()


__all__ = ["Definition", "Message", "Xacro", "expand"]
