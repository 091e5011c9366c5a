"""A cache of what is read from text files."""

from collections.abc import Callable
from functools import lru_cache

from urdfkit.core.static_typing import TypeVar
from urdfkit.text.source import Source

_Result = TypeVar("_Result")

#: Longest file, in bytes, of which many are kept; what is parsed takes fifty times as much memory.
_SMALL = 32 * 1024
#: Number of small files, such as the parameter files of a workspace, and of others.
_MANY, _FEW = 512, 4


def cached_by_source(read: Callable[[Source], _Result]) -> Callable[[Source], _Result]:
    """A function of a file whose results are kept: for many small files, and for few large ones."""
    of_small, of_large = lru_cache(_MANY)(read), lru_cache(_FEW)(read)

    def cached(source: Source) -> _Result:
        return of_small(source) if len(source.data) <= _SMALL else of_large(source)

    cached.__doc__ = read.__doc__
    return cached
