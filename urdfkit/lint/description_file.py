"""A description file: its text, expansion and problems."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

from urdfkit.core.record import Record
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.errors import NotApplicable, Unavailable
from urdfkit.text.diagnostic import Problem
from urdfkit.text.document import Attribute, CallFrame, Document, Element, Tag
from urdfkit.text.file_kinds import is_launch, is_parameter_file, is_xacro
from urdfkit.text.source import Source
from urdfkit.text.xml_reader import read_xml

if TYPE_CHECKING:
    from urdfkit.lint.ignore_comments import Ignore
    from urdfkit.ros.launch.contents import Launch
    from urdfkit.workspace.resolve import Resolver
    from urdfkit.xacro import Xacro
    from urdfkit.xacro.origin import DataPlaces


#: Code of the rule about arguments that are used before their default, which is still a value.
TOO_EARLY = "XAC020"


class Reading(Record):
    """The result of reading a file."""

    document: Document | None  # after expansion; None for launch files and unreadable files
    problems: tuple[Problem, ...]
    xacro: Xacro | None  # the expansion; None for plain XML

    @property
    def known(self) -> Document | None:
        """The document, or what it is without packages that are not found."""
        if self.document is None and self.xacro is not None:
            return self.xacro.without_packages
        return self.document

    @property
    def defaults(self) -> Mapping[str, str]:
        """The arguments that a description declares, with their defaults."""
        return self.xacro.defaults if self.xacro is not None else {}

    @property
    def missing_arguments(self) -> tuple[str, ...]:
        """The arguments without which a xacro cannot be expanded."""
        return tuple(dict.fromkeys(problem.argument for problem in self.missing_argument_problems))

    @property
    def arguments_to_pass(self) -> tuple[str, ...]:
        """The missing arguments, otherwise those that are used before their default."""
        return self.missing_arguments or self.early_arguments

    @property
    def early_arguments(self) -> tuple[str, ...]:
        """The arguments that are used before their default."""
        early = (problem.argument for problem in self.problems if problem.code == TOO_EARLY)
        return tuple(dict.fromkeys(early))

    @property
    def missing_argument_problems(self) -> list[Problem]:
        """The problems that are arguments without a value."""
        return [
            problem for problem in self.problems if problem.argument and problem.code != TOO_EARLY
        ]

    @property
    def missing_argument_codes(self) -> frozenset[str]:
        """The codes of the problems that are arguments without a value."""
        return frozenset(problem.code for problem in self.missing_argument_problems)

    @property
    def is_fragment(self) -> bool:
        """True for a part of a robot that cannot be expanded alone: XAC001 is no error for it."""
        return any(
            problem.code == "XAC001" and problem.severity is not None for problem in self.problems
        )


class DescriptionFile:
    """A URDF, xacro or launch file, read with arguments.

    Args:
        frame: the launch file that loads it; None if the user named the file.
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
        #: True for the robot that rules check; rules about others require them whole.
        self.is_checked = False
        self._frame = frame
        resolver.admit(source.path, trust=trust)

    @cached_property
    def reading(self) -> Reading:
        if self.is_bringup:
            return Reading(None, tuple(self.launch.problems), None)
        if not is_xacro(self.source) and not self._is_passed_to_xacro:
            document, xml_problems = read_xml(self.source, self._frame)
            return Reading(document, tuple(xml_problems), None)
        xacro = self._expansion()
        problems = xacro.problems
        if any(problem.argument for problem in problems):
            from urdfkit.lint.argument_values import with_values

            problems = tuple(with_values(problems, xacro, self.resolver))
        return Reading(xacro.document, problems, xacro)

    def _expansion(self) -> Xacro:
        from urdfkit.xacro import expand

        key = (self.source, frozenset(self.arguments.items()), self.trust, self._frame)
        expansions: dict[object, Xacro] | None = self.resolver.expansions
        xacro = expansions.get(key) if expansions else None
        if xacro is None:
            xacro = expand(
                self.source, self.resolver, self.arguments, trust=self.trust, frame=self._frame
            )
            if expansions is not None:
                expansions[key] = xacro
        return xacro

    @property
    def _is_passed_to_xacro(self) -> bool:
        """True for a plain URDF with expressions, which a launch file expands."""
        if b"${" not in self.source.data and b"$(" not in self.source.data:
            return False
        from urdfkit.ros.launch.robot_arguments import is_passed_to_xacro

        return is_passed_to_xacro(self.source, self.resolver)

    @cached_property
    def is_bringup(self) -> bool:
        """True for a launch file or a parameter file, which describe no robot themselves."""
        return is_launch(self.source.path) or is_parameter_file(self.source)

    @property
    def is_readable(self) -> bool:
        """False for a description that cannot be read, which few rules can check."""
        return self.is_bringup or self.reading.document is not None

    def problems(self, code: str) -> list[Problem]:
        """The problems with the code of a rule, in a description or a launch file."""
        return [problem for problem in self.reading.problems if problem.code == code]

    @property
    def part(self) -> Document | None:
        """What a checked robot is without packages that are not found; None if it is whole."""
        xacro = self.reading.xacro if self.is_checked else None
        return xacro.without_packages if xacro is not None else None

    @property
    def xacro(self) -> Xacro:
        """The expansion.

        Raises:
            NotApplicable: the description is plain XML.
            Unavailable: it did not expand.
        """
        if self.reading.xacro is None:
            raise NotApplicable("not a xacro")
        if self.reading.document is None and self.part is None:
            raise Unavailable("the xacro does not expand")
        return self.reading.xacro

    @property
    def document(self) -> Document:
        """The expanded document.

        Raises:
            Unavailable: it could not be read.
        """
        if self.part is not None:
            return self.part
        if self.reading.document is None:
            reason = "xacro does not expand" if self.reading.xacro else "description cannot be read"
            raise Unavailable(f"the {reason}")
        return self.reading.document

    @property
    def text(self) -> bytes:
        """The URDF, expanded.

        Raises:
            Unavailable: it could not be read.
        """
        if self.reading.xacro is None:
            return self.source.data
        if self.reading.document is None:
            raise Unavailable("the xacro does not expand")
        return self.xacro.text().encode("utf-8", "replace")

    @cached_property
    def _traced(self) -> Xacro:
        """A second expansion that records the origin of every value."""
        from urdfkit.xacro import expand

        return expand(self.source, self.resolver, self.arguments, trust=self.trust, traced=True)

    def data_places(self, at: Element | Attribute) -> DataPlaces | None:
        """Places in YAML files of the values that expressions yield at an element or attribute.

        Expands a second time if the xacro reads YAML files and the place has an expression.
        """
        reading = self.reading
        element = at if isinstance(at, Element) else at.element
        if reading.xacro is None or not reading.xacro.data_files or not self._has(element):
            return None
        attributes = at.attributes.values() if isinstance(at, Element) else (at,)
        if not any("$" in attribute.span.text for attribute in attributes):
            return None
        return self._traced.data_places(at)

    def _has(self, element: Element) -> bool:
        """True for an element of the document, not of its SRDF or manifest."""
        while element.parent is not None:
            element = element.parent
        return self.reading.document is not None and element is self.reading.document.root

    @cached_property
    def uses(self) -> Mapping[Tag, int]:
        """Number of uses of each tag in the document; a tag in a macro has one for each call."""
        from collections import Counter
        from operator import attrgetter

        return Counter(map(attrgetter("tag_at"), self.document.root.walk()))

    @property
    def is_launched(self) -> bool:
        """True if it is checked with the arguments of a launch file."""
        return self._frame is not None

    @cached_property
    def launch(self) -> Launch:
        """The contents of the launch file, or the programs that read the parameter file.

        Raises:
            NotApplicable: the file is neither of them.
        """
        from urdfkit.ros.launch import read_launch

        if not self.is_bringup:
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
