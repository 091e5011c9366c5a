"""Names that differ, as MuJoCo wants them of things of one kind."""

from __future__ import annotations

from itertools import chain, count


class FreeNames:
    """The names of one kind of things."""

    def __init__(self) -> None:
        self._taken: set[str] = set()

    def take(self, wanted: str) -> str:
        """A name that is free: the wanted one, or with a number behind it."""
        numbered = (f"{wanted}_{number}" for number in count(2))
        free = next(one for one in chain((wanted,), numbered) if one.casefold() not in self._taken)
        self._taken.add(free.casefold())
        return free
