"""Errors inside an expansion, and the value of an expression that failed."""

from __future__ import annotations

from urdfkit.core.record import Record
from urdfkit.text.source import Span


class FailedValue(str):
    """The value of an expression that failed and was reported.

    No model contains this text. An error of xacro that quotes it is a consequence.
    """

    __slots__ = ()


#: Start of the message about a file that xacrodoc finds from the directory where it is run.
ONLY_XACRODOC = "xacro looks next to the including file: not found"

#: Start of the message about an environment variable that is not set.
VARIABLE = "environment variable"

#: In the help for a name whose definition is in a condition that is false.
IN_CONDITION = "whose condition is false here"

#: After the name of a macro, in the messages about a call with other parameters than it has.
NO_PARAMETER = "has no parameter"
CALLED_WITHOUT = "is called without"

#: The only instance; its text is enclosed in private characters of Unicode.
FAILED = FailedValue("\ue000failed\ue000")


class MessageText(Record):
    """A message with its help."""

    message: str
    help: str = ""  # the rule's own help if empty


class DependsOnError(Exception):
    """An expression uses the value of an expression that failed and was reported."""


class MissingArgument(Exception):
    """A ``$(arg name)`` without a value and a default; the text is the name."""


class EscapesRoots(Exception):
    """A path outside the workspace and the packages, or not a file; the text is for users."""


class BrokenYaml(Exception):
    """An invalid YAML file; the text is from the parser."""

    def __init__(self, text: str, span: Span, reason: str) -> None:
        super().__init__(text)
        self.span = span
        self.reason = reason  # short


def is_out_of_memory(error: BaseException) -> bool:
    """True if the process is out of memory, which is the only reason for an ImportError."""
    return isinstance(root_cause(error), (MemoryError, ImportError))


def root_cause(error: BaseException) -> BaseException:
    """The innermost exception inside the exceptions of xacro."""
    depth = 0
    while isinstance(inner := getattr(error, "exc", None), BaseException) and depth < 1000:
        error = inner
        depth += 1
    return error
