"""How far a long check is, on a terminal."""

from __future__ import annotations

import os
import sys
import time
from typing import TextIO

#: Seconds before anything is shown: most checks are over by then.
DELAY = 1.0
_WIDTH = 30


class Progress:
    """A line on standard error that is drawn over and over, and wiped in the end."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream
        self._start = time.monotonic()
        self._is_drawn = False

    def __call__(self, done: int, total: int) -> None:
        """Draw it, once the check has lasted for a while."""
        if time.monotonic() - self._start < DELAY:
            return
        bar = "#" * (_WIDTH * done // total)
        self._draw(f"\r[{bar:<{_WIDTH}}] {done} of {total}")
        self._is_drawn = True

    def wipe(self) -> None:
        """Leave nothing behind."""
        if self._is_drawn:
            self._draw("\r\x1b[K")
            self._is_drawn = False

    def _draw(self, text: str) -> None:
        try:
            self._stream.write(text)
            self._stream.flush()
        except OSError:
            pass  # the terminal is gone; the check matters more


def on_terminal() -> Progress | None:
    """Progress on standard error; None where no person looks at it, or no line can be wiped."""
    if sys.stderr is None or not sys.stderr.isatty() or os.environ.get("TERM") == "dumb":
        return None
    return Progress(sys.stderr)
