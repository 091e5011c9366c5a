"""What all attempts at expanding one file found: problems and messages."""

from __future__ import annotations

import re
from collections.abc import Iterable

from urdfkit.core.record import Record
from urdfkit.text.diagnostic import Problem, Related
from urdfkit.text.document import Tag
from urdfkit.text.source import Span
from urdfkit.xacro.errors import FAILED, DependsOnError, MissingArgument, root_cause

MAX_PROBLEMS = 500
#: Failing tags of one file.
MAX_TAKEN_OUT = 500
MAX_MESSAGES = 1000
MAX_MESSAGE = 1000
#: Uses of one failing property that are worth naming.
MAX_RELATED = 5
#: Stands among the lost names for those that a missing file would have defined.
ANY = "*"

_UNDEFINED = (
    r"name '(\w+)' is not defined|unknown macro name: (?:xacro:)?(?:.*\.)?(\S+)"
    r'|Undefined block "(\w+)"'
)


class Message(Record):
    """What xacro or the model itself says while it is expanded."""

    kind: str
    text: str
    span: Span | None


class ExpansionLog:
    """Problems and messages, as they are met."""

    def __init__(self) -> None:
        self.first_error: str | None = None  # as stock xacro words it; None without one
        self.messages: list[Message] = []  # of xacro and of the model in the last attempt, in order
        #: Names that nothing defines any more, because what did so failed.
        self.lost: set[str] = set()
        #: Tags that failed and were reported: paths and offsets.
        self._taken_out: set[tuple[str, int]] = set()
        self._problems: dict[object, Problem] = {}

    def begin(self) -> None:
        """Another attempt begins."""
        self.messages = []

    def take_out(self, tag: Tag, lost: Iterable[str]) -> bool:
        """Go on without a tag, and the names that it defines; False if too many failed already."""
        if len(self._taken_out) >= MAX_TAKEN_OUT:
            return False
        self._taken_out.add((tag.source.path, tag.start))
        self.lost.update(lost)
        return True

    def has_taken_out(self, tag: Tag) -> bool:
        """True for a tag that failed and was reported."""
        return bool(self._taken_out) and (tag.source.path, tag.start) in self._taken_out

    @property
    def is_whole(self) -> bool:
        """True if no tag was taken out."""
        return not self._taken_out

    @property
    def problems(self) -> list[Problem]:
        """Errors and warnings, each with its place, in the order of the expansion."""
        return list(self._problems.values())

    @property
    def is_full(self) -> bool:
        """True if no other problem will be kept."""
        return len(self._problems) >= MAX_PROBLEMS

    def say(self, message: Message) -> None:
        if len(self.messages) < MAX_MESSAGES:
            self.messages.append(message)

    def add(self, problem: Problem) -> None:
        """Keep a problem; the same one met again only adds the place that met it."""
        if len(problem.message) > MAX_MESSAGE:  # what the model says may be a novel
            problem = problem._replace(message=problem.message[: MAX_MESSAGE - 3] + "...")
        key = _identity(problem)
        known = self._problems.get(key)
        if known is None:
            if not self.is_full:
                self._problems[key] = problem
        elif len(known.related) < MAX_RELATED:
            uses = problem.related
            if _place(known.span) != _place(problem.span):
                uses = (Related(problem.span, "needed here"),)
            together = tuple(dict.fromkeys((*known.related, *uses)))
            self._problems[key] = known._replace(related=together)

    def is_consequence(self, error: BaseException) -> bool:
        """True if an error follows from one that was already reported."""
        cause = root_cause(error)
        if isinstance(cause, DependsOnError) or FAILED in str(error):
            return True
        if not self.lost:
            return False
        if isinstance(cause, MissingArgument):
            return bool(self.lost & {ANY, str(cause)})
        undefined = re.search(_UNDEFINED, str(cause))
        return undefined is not None and bool(self.lost & {ANY, *undefined.groups()})


def _identity(problem: Problem) -> object:
    """What two problems have in common that are one; not the objects of one attempt."""
    if problem.argument:  # without a value, wherever it is used
        return problem.message
    way = problem.frame.steps() if problem.frame else ()
    places = tuple(_place(span) for span in (problem.span, *(step.span for step in way)))
    return problem.code, problem.message, places


def _place(span: Span) -> tuple[str, int, int]:
    return span.source.path, span.start, span.end
