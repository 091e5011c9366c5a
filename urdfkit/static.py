"""Names of `typing` for the modules of the ordinary check, which importing it costs 2 ms of 80.

Type checkers take these names for those of `typing`; a running program does nothing with them.
"""

from __future__ import annotations

__all__ = ["TYPE_CHECKING", "Any", "Generic", "Protocol", "TypeVar"]

TYPE_CHECKING = False

if TYPE_CHECKING:
    from typing import Any, Generic, Protocol, TypeVar
else:
    Any = object

    class Generic:
        """A class with parameters, which only type checkers look at."""

        def __class_getitem__(cls, _):
            return cls

    class Protocol:
        """What others look like."""

    def TypeVar(name, *_, **__):  # noqa: N802 - as typing calls it
        return name
