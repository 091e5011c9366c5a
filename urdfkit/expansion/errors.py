"""Errors that arise inside an expansion."""

from __future__ import annotations


class MissingArgument(Exception):
    """A ``$(arg name)`` without a value and without a default; the text is the name."""


class EscapesRoots(Exception):
    """A file outside the workspace and the packages, or none; the text is for users."""


def root_cause(error: BaseException) -> BaseException:
    """The exception inside xacro's wrappings."""
    seen = 0
    while isinstance(inner := getattr(error, "exc", None), BaseException) and seen < 1000:
        error = inner
        seen += 1
    return error
