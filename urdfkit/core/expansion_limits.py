"""What the expansion of one description may use up.

One process works for one user: what he allows holds for all that it expands.
"""

from __future__ import annotations

from urdfkit.core.record import Record


class Limits(Record):
    """The limits of one expansion."""

    #: Of the processor; a sound model waits on a busy machine, and is none the worse. The largest
    #: public robots need a tenth of a second.
    seconds: float = 5.0
    megabytes: int = 512  # that it may add to the memory of the process


_allowed = Limits()


def allow(limits: Limits) -> None:
    """From now on the expansions of this process have these limits."""
    global _allowed  # noqa: PLW0603 - one process has one user
    _allowed = limits


def allowed() -> Limits:
    """The limits of an expansion that begins now."""
    return _allowed
