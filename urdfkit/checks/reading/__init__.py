"""Problems of reading a description: errors of XML and of xacro."""

from collections.abc import Collection

from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True if reading reported a problem."""
    return bool(context.reading.problems)


def codes(context: Context) -> Collection[str]:
    """The rules that have something to report."""
    return {problem.code for problem in context.reading.problems}
