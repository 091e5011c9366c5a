"""xacro: macros, properties, arguments, expressions."""

from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True for a xacro, and for a plain file with expressions or tags of xacro."""
    reading = context.reading
    if reading.xacro is not None or any(
        problem.code.startswith("XAC") for problem in reading.problems
    ):
        return True
    return any(sign in context.source.data for sign in (b"${", b"$(", b"<xacro:"))
