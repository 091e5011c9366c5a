"""What an expansion may use up: time, and what it makes."""

from __future__ import annotations

import time

from urdfkit.core import disk
from urdfkit.text.xml_reader import DocumentTooLarge

#: Of the processor: on a busy machine a sound model waits, and is none the worse.
MAX_SECONDS = 30.0
#: Characters and items, counted together, that one expansion may make; with what Python needs
#: for them half a gigabyte. The largest public robots need a twentieth.
MAX_UNITS = 30_000_000
#: What an element counts for, as it needs that much more memory than a character.
ELEMENT_SIZE = 100
#: What a call counts for, or one turn of a comprehension, as it takes that much longer.
STEP_SIZE = 10
#: Units between two looks at the clock.
_BETWEEN_LOOKS = 1000


class Budget:
    """The budget of one expansion, shared by all of its attempts as far as time is concerned."""

    __slots__ = ("_deadline", "_left", "_look")

    def __init__(self, deadline: float) -> None:
        self._deadline = deadline
        self._left = self._look = MAX_UNITS

    def charge(self, units: int) -> None:
        """Count what is made.

        Raises:
            TooMuch: more than any robot needs, or it takes too long.
        """
        self._left -= units
        if self._left > self._look:
            return
        self._look = self._left - _BETWEEN_LOOKS
        if self._left < 0:
            raise DocumentTooLarge(
                f"the expansion makes more than {MAX_UNITS} characters, or "
                f"{MAX_UNITS // ELEMENT_SIZE} elements"
            )
        if time.thread_time() > self._deadline:
            disk.depends_on_more()  # on a faster machine it may be done in time
            raise DocumentTooLarge(f"the expansion takes longer than {MAX_SECONDS:g} s")


def deadline() -> float:
    """The time of the thread at which an expansion that begins now must have ended."""
    return time.thread_time() + MAX_SECONDS
