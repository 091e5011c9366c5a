"""The progress of a long job, on a terminal."""

from __future__ import annotations

import os
import sys
import time
from contextlib import contextmanager
from typing import TYPE_CHECKING

from urdfkit.core import limits

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence
    from contextlib import AbstractContextManager
    from threading import Timer
    from typing import TextIO

    from urdfkit.core.progress import Progress

#: Seconds before the bar is shown: most checks take less.
DELAY = 1.0
_WIDTH = 30


class ProgressBar:
    """A line on standard error that is redrawn, and cleared at the end.

    Args:
        things: the counted things, in the plural.
        rated: show the rate and the remaining time.
    """

    def __init__(self, stream: TextIO, things: str = "", *, rated: bool = False) -> None:
        self._stream = stream
        self._rated = rated
        self._things = f" {things}" if things else ""
        self._start = time.monotonic()
        self._state = (0, 1)
        self._timer: Timer | None = None
        self._is_visible = False

    def __call__(self, done: int, total: int) -> None:
        """Draw the bar, once the job has lasted for a while; ``total`` is 0 if unknown."""
        self._state = (done, total)
        left = DELAY - (time.monotonic() - self._start)
        if left <= 0:
            self._show()
        elif self._timer is None:
            # The first thing may take long, and this is not called again in time.
            from threading import Timer

            self._timer = Timer(left, self._show)
            self._timer.daemon = True
            self._timer.start()

    def clear(self) -> None:
        if self._timer is not None:
            self._timer.cancel()
            self._timer.join()
        if self._is_visible:
            self._draw("\r\x1b[K")
            self._is_visible = False

    def _show(self) -> None:
        done, total = self._state
        if not (done or total):
            self._draw("\rworking ...")
            self._is_visible = True
            return
        bar = "#" * (_WIDTH * done // total) if total else ""
        of_total = f" of {total}" if total else ""
        self._draw(f"\r[{bar:<{_WIDTH}}] {done}{of_total}{self._things}{self._rate()}")
        self._is_visible = True

    def _rate(self) -> str:
        """The rate, such as ``, 85.2/s, 0:03:20 left``, and a code that clears the line's rest."""
        done, total = self._state
        rate = done / max(time.monotonic() - self._start, 1e-9)
        if not self._rated or not done:
            return ""
        left = round((total - done) / rate)
        clock = f", {left // 3600}:{left // 60 % 60:02}:{left % 60:02} left" if total else ""
        return f", {rate:.3g}/s{clock}\x1b[K"

    def _draw(self, text: str) -> None:
        try:
            self._stream.write(text)
            self._stream.flush()
        except OSError:
            pass  # the terminal is closed; the check continues


def on_terminal(things: str = "", *, rated: bool = False) -> ProgressBar | None:
    """A progress bar on standard error; None if it is not a terminal, or cannot clear lines."""
    if sys.stderr is None or not sys.stderr.isatty() or os.environ.get("TERM") == "dumb":
        return None
    return ProgressBar(sys.stderr, things, rated=rated)


@contextmanager
def progress_bar(things: str = "", *, rated: bool = False) -> Iterator[Progress | None]:
    """Show a progress bar on standard error during a job, if it is a terminal.

    Until the first step is done, such as the search for robots, it shows that the job is running.
    """
    bar = on_terminal(things, rated=rated)
    if bar is not None:
        bar(0, 0)
    try:
        yield limits.noting(bar)
    finally:
        if bar is not None:
            bar.clear()


def progress_of_files(files: Sequence[str]) -> AbstractContextManager[Progress | None]:
    """A progress bar of robots; for a single robot, of its mesh files, which take longest."""
    is_single = len(files) == 1 and not os.path.isdir(files[0])
    return progress_bar("mesh files" if is_single else "")


@contextmanager
def working() -> Iterator[None]:
    """Show on standard error during a job of unknown length that it is running, on a terminal."""
    bar = on_terminal()
    if bar is None:
        yield
        return
    bar(0, 0)
    try:
        yield
    finally:
        bar.clear()
