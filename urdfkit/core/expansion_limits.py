"""Limits of time and memory for a xacro expansion.

They are global: a process serves one user, whose limits apply to all expansions.
"""

from __future__ import annotations

from urdfkit.core.record import Record


class Limits(Record):
    """The limits of one expansion."""

    #: CPU time, so that a busy machine does not matter. The largest public robots need 0.1 s.
    seconds: float = 5.0
    megabytes: int = 512  # added to the memory of the process


_allowed = Limits()


def allow(limits: Limits) -> None:
    """Set the limits of all further expansions of this process."""
    global _allowed  # noqa: PLW0603 - one process has one user
    _allowed = limits


def allowed() -> Limits:
    """The current limits."""
    return _allowed
