"""Names of `typing` for the modules that every check imports.

Importing `typing` takes longer than twenty rules. Type checkers take these names for those of
`typing`, and so does ruff (``typing-modules`` in ``pyproject.toml``).
"""

from __future__ import annotations

__all__ = ["IO", "TYPE_CHECKING", "Any", "BinaryIO", "Generic", "Protocol", "TypeVar", "overload"]

TYPE_CHECKING = False

if TYPE_CHECKING:
    from typing import IO, Any, BinaryIO, Generic, Protocol, TypeVar, overload
else:
    IO = Any = BinaryIO = Protocol = object

    class Generic:
        """Base of generic classes."""

        __slots__ = ()

        def __class_getitem__(cls, _):
            return cls

    def TypeVar(_name, *_constraints, **_options):  # noqa: N802 - the name in typing
        return object

    def overload(function):
        return function
