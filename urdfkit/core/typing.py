"""The names of `typing` that a check needs, as types for type checkers and as nothing at run time.

Importing `typing` takes 2 of the 80 ms of a check. Modules that a check imports take them from here
(`tests/test_imports.py`); the others import `typing`.
"""

__all__ = [
    "IO", "TYPE_CHECKING", "Any", "BinaryIO", "Generic", "Protocol", "TypeAlias", "TypeVar",
    "overload",
]  # fmt: skip

TYPE_CHECKING = False  # type checkers take it for True, by its name

if TYPE_CHECKING:
    from typing import IO, Any, BinaryIO, Generic, Protocol, TypeAlias, TypeVar, overload
else:
    Any = Protocol = TypeAlias = object

    class Generic:
        """A class with a parameter, which changes nothing: ``IO[bytes]`` is ``IO``."""

        def __class_getitem__(cls, parameters):
            return cls

    IO = BinaryIO = Generic

    def TypeVar(name, *constraints, bound=None, covariant=False):  # noqa: N802
        """A parameter of annotations."""

    def overload(function):
        """Another signature of a function."""
        return function
