"""Errors that arise inside an expansion, and the value of an expression that failed."""

from urdfkit.text.source import Span


class FailedValue(str):
    """The value of an expression that failed and was reported.

    No model has this text. An error of xacro that quotes it is a consequence.
    """

    __slots__ = ()


#: Begins the message about a file that CMake makes: ``configure_file``, ``xacro_add_files``.
UNBUILT = "the build has not made the file"

#: The only one; a private character of Unicode around its text.
FAILED = FailedValue("\ue000failed\ue000")


class DependsOnError(Exception):
    """An expression uses the value of one that failed and was reported."""


class MissingArgument(Exception):
    """A ``$(arg name)`` without a value and without a default; the text is the name."""


class EscapesRoots(Exception):
    """A file outside the workspace and the packages, or none; the text is for users."""


class BrokenYaml(Exception):
    """A YAML file that is none; the text is the parser's."""

    def __init__(self, text: str, span: Span, reason: str) -> None:
        super().__init__(text)
        self.span = span  # where
        self.reason = reason  # in short


def is_of_process(error: BaseException) -> bool:
    """True if the process lacks memory: nothing that an expansion imports is missing otherwise."""
    return isinstance(root_cause(error), (MemoryError, ImportError))


def root_cause(error: BaseException) -> BaseException:
    """The exception inside xacro's wrappings."""
    seen = 0
    while isinstance(inner := getattr(error, "exc", None), BaseException) and seen < 1000:
        error = inner
        seen += 1
    return error
