"""What reading a description met: errors of XML and of xacro."""

from collections.abc import Collection

from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True where reading met something."""
    return bool(context.reading.problems)


def codes(context: Context) -> Collection[str]:
    """The rules that have something to report."""
    return {problem.code for problem in context.reading.problems}
