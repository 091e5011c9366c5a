"""What an expansion may use up: time, and what it makes."""

import time

from urdfkit.core import disk, expansion_limits
from urdfkit.text.xml_reader import DocumentTooLarge

#: Characters and items, counted together, that one expansion may make for each megabyte that it
#: may take. The largest public robots need a twentieth of what the usual limit gives.
UNITS_OF_A_MEGABYTE = 60_000
#: What an element counts for, as it needs that much more memory than a character.
ELEMENT_SIZE = 100
#: What a call counts for, or one turn of a comprehension, as it takes that much longer.
STEP_SIZE = 10
#: The time of the processor that this thread took; in a browser, which has one thread, the process.
_clock = getattr(time, "thread_time", time.process_time)
#: Units between two looks at the clock.
_BETWEEN_LOOKS = 1000


class Budget:
    """The budget of one expansion, shared by all of its attempts as far as time is concerned.

    Args:
        deadline: the time of the thread at which it must have ended.
    """

    __slots__ = ("_deadline", "_left", "_limits", "_look")

    def __init__(self, deadline: float) -> None:
        self._deadline = deadline
        self._limits = expansion_limits.allowed()
        self._left = self._look = UNITS_OF_A_MEGABYTE * self._limits.megabytes

    def charge(self, units: int) -> None:
        """Count what is made.

        Raises:
            DocumentTooLarge: more than any robot needs, or it takes too long.
        """
        self._left -= units
        if self._left > self._look:
            return
        self._look = self._left - _BETWEEN_LOOKS
        if self._left < 0:
            most = UNITS_OF_A_MEGABYTE * self._limits.megabytes
            raise DocumentTooLarge(
                f"the expansion makes more than {most} characters, or "
                f"{most // ELEMENT_SIZE} elements"
            )
        self.check_time()

    def check_time(self) -> None:
        """Look at the clock.

        Raises:
            DocumentTooLarge: it takes too long.
        """
        if _clock() > self._deadline:
            disk.depends_on_more()  # on a faster machine it may be done in time
            raise DocumentTooLarge(f"the expansion takes longer than {self._limits.seconds:g} s")

    def seconds_left(self) -> float:
        """The time until the deadline; never less than a moment."""
        return max(self._deadline - _clock(), 0.01)

    def out_of_memory(self) -> DocumentTooLarge:
        """The error of an expansion to which the system gives no more memory."""
        disk.depends_on_more()
        return DocumentTooLarge(f"the expansion takes more than {self._limits.megabytes} MB")


def deadline() -> float:
    """The time of the thread at which an expansion that begins now must have ended."""
    return _clock() + expansion_limits.allowed().seconds
