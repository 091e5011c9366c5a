"""Progress of a long job."""

from collections.abc import Callable

#: Called with the number of completed items and the total.
Progress = Callable[[int, int], None]


def silent(_done: int, _total: int) -> None:
    """Progress that is not shown."""
