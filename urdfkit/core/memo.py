"""Results by key, which are forgotten when there are many."""

from typing import TypeVar

#: Results that are kept: more than a robot asks for again and again.
LIMIT = 1024

_Key = TypeVar("_Key")
_Value = TypeVar("_Value")


class Memo(dict[_Key, _Value]):
    """What was worked out for single files, in a process that may look at a million of them.

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
