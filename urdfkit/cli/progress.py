"""How far a long job is, on a terminal."""

from __future__ import annotations

import os
import sys
import time
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator
    from threading import Timer
    from typing import TextIO

#: Seconds before anything is shown: most checks are over by then.
DELAY = 1.0
_WIDTH = 30


class Progress:
    """A line on standard error that is drawn over and over, and wiped in the end.

    Args:
        stream: that it is drawn on.
        things: that are counted, where that is not plain to see.
    """

    def __init__(self, stream: TextIO, things: str = "") -> None:
        self._stream = stream
        self._things = f" {things}" if things else ""
        self._start = time.monotonic()
        self._state = (0, 1)
        self._timer: Timer | None = None
        self._is_drawn = False

    def __call__(self, done: int, total: int) -> None:
        """Draw it, once the job has lasted for a while."""
        self._state = (done, total)
        left = DELAY - (time.monotonic() - self._start)
        if left <= 0:
            self._show()
        elif self._timer is None:
            # The very first thing may take long; then nobody else calls in time.
            from threading import Timer

            self._timer = Timer(left, self._show)
            self._timer.daemon = True
            self._timer.start()

    def wipe(self) -> None:
        """Leave nothing behind."""
        if self._timer is not None:
            self._timer.cancel()
            self._timer.join()
        if self._is_drawn:
            self._draw("\r\x1b[K")
            self._is_drawn = False

    def _show(self) -> None:
        done, total = self._state
        bar = "#" * (_WIDTH * done // total)
        self._draw(f"\r[{bar:<{_WIDTH}}] {done} of {total}{self._things}")
        self._is_drawn = True

    def _draw(self, text: str) -> None:
        try:
            self._stream.write(text)
            self._stream.flush()
        except OSError:
            pass  # the terminal is gone; the check matters more


def on_terminal(things: str = "") -> Progress | None:
    """Progress on standard error; None where no person looks at it, or no line can be wiped."""
    if sys.stderr is None or not sys.stderr.isatty() or os.environ.get("TERM") == "dumb":
        return None
    return Progress(sys.stderr, things)


@contextmanager
def shown(things: str = "") -> Iterator[Progress | None]:
    """Progress on standard error while a job lasts, if a person looks at it."""
    bar = on_terminal(things)
    try:
        yield bar
    finally:
        if bar is not None:
            bar.wipe()
