"""A description as it was read: its text, expanded, and what is wrong with it."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

from urdfkit.core.record import Record
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.errors import NotApplicable, Unavailable
from urdfkit.text.diagnostic import Problem, Severity
from urdfkit.text.document import Attribute, CallFrame, Document, Element, Tag
from urdfkit.text.file_kinds import is_launch, is_xacro
from urdfkit.text.source import Source
from urdfkit.text.xml_reader import read_xml

if TYPE_CHECKING:
    from urdfkit.lint.ignore_comments import Ignore
    from urdfkit.ros.launch.contents import Launch
    from urdfkit.text.diagnostic import Related
    from urdfkit.workspace.resolve import Resolver
    from urdfkit.xacro import Xacro


#: An argument is used above its default, which is a value all the same.
_TOO_EARLY = "XAC020"


class Reading(Record):
    """A file as it was read."""

    document: Document | None  # after expansion; None of a launch file, or if it could not be read
    problems: tuple[Problem, ...]  # what is wrong with the text
    xacro: Xacro | None  # the expansion; None for plain XML

    @property
    def missing_arguments(self) -> tuple[str, ...]:
        """The arguments without which a xacro cannot be expanded."""
        return tuple(dict.fromkeys(one.argument for one in self.lacking))

    @property
    def arguments_to_pass(self) -> tuple[str, ...]:
        """The missing arguments, else those that xacro misses because their default comes later."""
        early = (one.argument for one in self.problems if one.code == _TOO_EARLY)
        return self.missing_arguments or tuple(dict.fromkeys(early))

    @property
    def lacking(self) -> list[Problem]:
        """The problems that are nothing but arguments without a value."""
        return [one for one in self.problems if one.argument and one.code != _TOO_EARLY]

    @property
    def missing_argument_codes(self) -> frozenset[str]:
        """The codes of the problems that are nothing but arguments without a value."""
        return frozenset(one.code for one in self.lacking)

    @property
    def is_fragment(self) -> bool:
        """True for a part of a robot that cannot be expanded alone; XAC001 says so, as an info."""
        infos = (one.code for one in self.problems if one.severity is Severity.INFO)
        return "XAC001" in infos


class DescriptionFile:
    """A URDF, xacro or launch file, read with arguments.

    Args:
        frame: the launch file that loads it; None if it was named itself.
    """

    def __init__(
        self,
        source: Source,
        resolver: Resolver,
        arguments: Mapping[str, str] | None = None,
        *,
        trust: bool = False,
        frame: CallFrame | None = None,
    ) -> None:
        self.source = source  # the file
        self.resolver = resolver  # finds packages and files
        self.arguments = dict(arguments or {})  # ``name:=value`` for xacro
        self.trust = trust  # True if the model's expressions and files are not sandboxed
        self._frame = frame
        resolver.admit(source.path, trust=trust)

    @cached_property
    def reading(self) -> Reading:
        if is_launch(self.source.path):
            return Reading(None, tuple(self.launch.problems), None)
        if not is_xacro(self.source) and not self._is_passed_to_xacro:
            document, problems = read_xml(self.source, self._frame)
            return Reading(document, tuple(problems), None)
        from urdfkit.xacro import expand

        xacro = expand(
            self.source, self.resolver, self.arguments, trust=self.trust, frame=self._frame
        )
        found = xacro.problems
        if any(problem.argument for problem in found):
            from urdfkit.lint.argument_values import with_values

            found = tuple(with_values(found, xacro, self.resolver))
        return Reading(xacro.document, found, xacro)

    @property
    def _is_passed_to_xacro(self) -> bool:
        """True for a plain URDF with expressions, which a launch file expands."""
        if b"${" not in self.source.data and b"$(" not in self.source.data:
            return False
        from urdfkit.ros.launch.robot_arguments import is_passed_to_xacro

        return is_passed_to_xacro(self.source, self.resolver)

    @property
    def is_readable(self) -> bool:
        """False for a description that cannot be read, on which hardly any rule can run."""
        return is_launch(self.source.path) or self.reading.document is not None

    def problems(self, code: str) -> list[Problem]:
        """The problems that a rule explains, in a description or a launch file."""
        return [problem for problem in self.reading.problems if problem.code == code]

    @property
    def xacro(self) -> Xacro:
        """The expansion.

        Raises:
            NotApplicable: the description is plain XML.
            Unavailable: it did not expand.
        """
        if self.reading.xacro is None:
            raise NotApplicable("not a xacro")
        if self.reading.document is None:
            raise Unavailable("the xacro does not expand")
        return self.reading.xacro

    @property
    def document(self) -> Document:
        """The expanded document.

        Raises:
            Unavailable: it could not be read.
        """
        if self.reading.document is None:
            what = "xacro does not expand" if self.reading.xacro else "description cannot be read"
            raise Unavailable(f"the {what}")
        return self.reading.document

    @property
    def text(self) -> bytes:
        """The URDF, expanded.

        Raises:
            Unavailable: it could not be read.
        """
        if self.reading.xacro is None:
            return self.source.data
        return self.xacro.text().encode("utf-8", "replace")

    @cached_property
    def _traced(self) -> Xacro:
        """The expansion once more, with notes of where every value comes from."""
        from urdfkit.xacro import expand

        return expand(self.source, self.resolver, self.arguments, trust=self.trust, traced=True)

    def data_places(self, at: Element | Attribute) -> tuple[Related, ...]:
        """Where in YAML files the values stand that expressions wrote at a place of the document.

        Expands a second time, if the first one read YAML files and there is an expression.
        """
        reading = self.reading
        element = at if isinstance(at, Element) else at.element
        if reading.xacro is None or not reading.xacro.data_files or not self._has(element):
            return ()
        attributes = at.attributes.values() if isinstance(at, Element) else (at,)
        if not any("$" in attribute.span.text for attribute in attributes):
            return ()
        return self._traced.data_places(at)

    def _has(self, element: Element) -> bool:
        """True for an element of the document, not of its SRDF or manifest."""
        while element.parent is not None:
            element = element.parent
        return self.reading.document is not None and element is self.reading.document.root

    @cached_property
    def uses(self) -> Mapping[Tag, int]:
        """How often each tag stands in the document: those of a macro, once for each call."""
        from collections import Counter
        from operator import attrgetter

        return Counter(map(attrgetter("tag_at"), self.document.root.walk()))

    @cached_property
    def launch(self) -> Launch:
        """What the launch file needs.

        Raises:
            NotApplicable: the file is no launch file.
        """
        from urdfkit.ros.launch import read_launch

        if not is_launch(self.source.path):
            raise NotApplicable("not a launch file")
        return read_launch(self.source, self.resolver, self.arguments)

    @cached_property
    def ignores(self) -> tuple[Ignore, ...]:
        sources: tuple[Source, ...] = (self.source,)
        if self.reading.xacro:
            sources = self.reading.xacro.sources
        if not any(b"urdfkit" in source.data for source in sources):
            return ()
        from urdfkit.lint.ignore_comments import ignores

        return tuple(ignore for source in sources for ignore in ignores(source))
