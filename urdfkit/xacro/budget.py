"""Limits of time and output for an expansion."""

import time

from urdfkit.core import disk, expansion_limits
from urdfkit.text.xml_reader import DocumentTooLarge

#: Characters and items together that an expansion may create for each megabyte of its memory limit.
#: The largest public robots need a twentieth of the default limit.
UNITS_PER_MEGABYTE = 60_000
#: Units of an element, by its memory in comparison to a character.
ELEMENT_SIZE = 100
#: Units of an attribute, a comment or another small node.
NODE_SIZE = 30
#: Units of a call or an iteration of a comprehension, by its time in comparison to a character.
STEP_SIZE = 10
#: Processor time of this thread; of the process in a browser, which has one thread.
_clock = getattr(time, "thread_time", time.process_time)
#: Units between two checks of the time.
_CHECK_INTERVAL = 1000


class Budget:
    """The budget of one run of an expansion; all runs share the deadline.

    Args:
        deadline: processor time of the thread at which the expansion must have ended.
    """

    __slots__ = ("_deadline", "_left", "_limits", "_next_check")

    def __init__(self, deadline: float) -> None:
        self._deadline = deadline
        self._limits = expansion_limits.allowed()
        self._left = self._next_check = UNITS_PER_MEGABYTE * self._limits.megabytes

    def charge(self, units: int) -> None:
        """Subtract units from the budget.

        Raises:
            DocumentTooLarge: the budget is used up, or the time is over.
        """
        self._left -= units
        if self._left > self._next_check:
            return
        self._next_check = self._left - _CHECK_INTERVAL
        if self._left < 0:
            most = UNITS_PER_MEGABYTE * self._limits.megabytes
            raise DocumentTooLarge(
                f"the expansion creates more than {most} characters, or "
                f"{most // ELEMENT_SIZE} elements"
            )
        self.check_time()

    def check_time(self) -> None:
        """Check the time.

        Raises:
            DocumentTooLarge: the time is over.
        """
        if _clock() > self._deadline:
            disk.depends_on_more()  # a faster machine may finish in time
            raise DocumentTooLarge(f"the expansion takes longer than {self._limits.seconds:g} s")

    def seconds_left(self) -> float:
        """Seconds until the deadline, at least 0.01."""
        return max(self._deadline - _clock(), 0.01)

    def out_of_memory(self) -> DocumentTooLarge:
        """The error of an expansion that the system refuses more memory."""
        disk.depends_on_more()
        return DocumentTooLarge(f"the expansion takes more than {self._limits.megabytes} MB")


def deadline() -> float:
    """Processor time of the thread at which an expansion that starts now must have ended."""
    return _clock() + expansion_limits.allowed().seconds
