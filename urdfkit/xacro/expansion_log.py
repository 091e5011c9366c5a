"""Problems and messages of all runs that expand a file."""

from __future__ import annotations

import re
from collections.abc import Iterable

from urdfkit.core.record import Record
from urdfkit.text.diagnostic import Problem, Related
from urdfkit.text.document import Tag
from urdfkit.text.source import Span
from urdfkit.xacro.bounds import UnsafeExpression
from urdfkit.xacro.errors import FAILED, DependsOnError, MissingArgument, root_cause

MAX_PROBLEMS = 500
#: Most failing tags of one file.
MAX_REMOVED = 500
MAX_MESSAGES = 1000
MAX_MESSAGE = 1000
#: Most uses of a failing property that are reported.
MAX_RELATED = 5
#: Code of the rule about packages that are not found.
PACKAGE_NOT_FOUND = "XAC011"
#: Stands for all names, in the undefined names of a missing file.
ANY = "*"

_UNDEFINED = (
    r"name '(\w+)' is not defined|unknown macro name: (?:xacro:)?(?:.*\.)?(\S+)"
    r'|Undefined block "(\w+)"'
)
#: How xacro's error for a call without its block begins.
_FEW_BLOCKS = "Not enough blocks"


class Message(Record):
    """A message of xacro or of the model during the expansion."""

    kind: str
    text: str
    span: Span | None


class ExpansionLog:
    """Problems and messages, in order."""

    def __init__(self) -> None:
        self.first_error: str | None = None  # as in stock xacro; None without an error
        #: True unless an error is reported that is no package that is not found.
        self.lacks_only_packages = True
        self.messages: list[Message] = []  # of xacro and of the model in the last run, in order
        self._undefined: set[str] = set()  # names whose definition failed
        #: Tags that failed and were reported, as (path, offset).
        self._removed: set[tuple[str, int]] = set()
        self._problems: dict[object, Problem] = {}

    def begin_run(self) -> None:
        self.messages = []

    def remove(self, tag: Tag, names: Iterable[str]) -> bool:
        """Continue without a tag that defines names; False if too many tags failed already."""
        if len(self._removed) >= MAX_REMOVED:
            return False
        self._removed.add((tag.source.path, tag.start))
        self._undefined.update(names)
        return True

    def is_removed(self, tag: Tag) -> bool:
        """True for a tag that failed and was reported."""
        return bool(self._removed) and (tag.source.path, tag.start) in self._removed

    @property
    def has_removed_tags(self) -> bool:
        return bool(self._removed)

    @property
    def problems(self) -> list[Problem]:
        """Errors and warnings with their locations, in the order of the expansion."""
        return list(self._problems.values())

    @property
    def is_full(self) -> bool:
        """True if further problems are dropped."""
        return len(self._problems) >= MAX_PROBLEMS

    def add_message(self, message: Message) -> None:
        if len(self.messages) < MAX_MESSAGES:
            self.messages.append(message)

    def add_error(self, problem: Problem) -> None:
        """Add a problem that stops stock xacro."""
        self.lacks_only_packages &= problem.code == PACKAGE_NOT_FOUND
        self.add(problem)

    def add(self, problem: Problem) -> None:
        """Add a problem; a repeated problem only adds its location to the first one."""
        if len(problem.message) > MAX_MESSAGE:  # messages of models may be long
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
        """True if an error is a consequence of a reported one."""
        cause = root_cause(error)
        if isinstance(cause, DependsOnError) or FAILED in str(error):
            return True
        if not self._undefined:
            return False
        if ANY in self._undefined and str(cause).startswith(_FEW_BLOCKS):
            return True  # the block of the call is inserted from the missing file
        if isinstance(cause, MissingArgument):
            return bool(self._undefined & {ANY, str(cause)})
        if isinstance(cause, UnsafeExpression):
            # A property that xacro rejects because its name begins with two underscores.
            return any(f"name '{name}' is not" in str(cause) for name in self._undefined)
        match = re.search(_UNDEFINED, str(cause))
        return match is not None and bool(self._undefined & {ANY, *match.groups()})


def _identity(problem: Problem) -> object:
    """A key that is equal for equal problems of different runs."""
    if problem.argument:  # one problem for all uses of an argument without a value
        return problem.message
    steps = problem.frame.steps() if problem.frame else ()
    places = tuple(_place(span) for span in (problem.span, *(step.span for step in steps)))
    return problem.code, problem.message, places


def _place(span: Span) -> tuple[str, int, int]:
    return span.source.path, span.start, span.end
