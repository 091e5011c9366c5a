"""How far a long job is."""

from collections.abc import Callable

#: Called with the number of things that are done, and of all.
Progress = Callable[[int, int], None]
