"""A dictionary of bounded size, for memoised results."""

from urdfkit.core.static_typing import TypeVar

#: Most results; more than a robot needs repeatedly.
LIMIT = 1024

_Key = TypeVar("_Key")
_Value = TypeVar("_Value")


class Memo(dict[_Key, _Value]):
    """Results for single files in a process that may read a million; cleared when it is full.

    >>> memo = Memo((number, None) for number in range(LIMIT))
    >>> memo["next"] = None
    >>> list(memo)
    ['next']
    """

    __slots__ = ()

    def __setitem__(self, key: _Key, value: _Value) -> None:
        if len(self) >= LIMIT:
            self.clear()
        super().__setitem__(key, value)
