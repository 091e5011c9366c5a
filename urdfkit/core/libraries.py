"""Finds out which libraries are installed, without importing them.

``importlib.util`` would do the same, at the cost of one more import in every check.
"""

from __future__ import annotations

import sys
from functools import lru_cache

TYPE_CHECKING = False

if TYPE_CHECKING:
    from collections.abc import Iterator
    from importlib.machinery import ModuleSpec

#: Libraries that measure meshes.
_FOR_MESHES = ("numpy", "lxml", "manifold3d", "mapbox_earcut")


def find(name: str) -> ModuleSpec | None:
    """Import spec of a library; None if it is not installed."""
    for finder in sys.meta_path:
        spec = finder.find_spec(name, None)
        if spec is not None:
            return spec
    return None


def find_all(name: str) -> Iterator[ModuleSpec]:
    """Import specs of the packages with a name on the path, first that which Python imports."""
    first = find(name)
    if first is None:
        return
    if first.origin is not None:  # otherwise a directory without code
        yield first
    from importlib.machinery import PathFinder

    for directory in sys.path:
        spec = PathFinder.find_spec(name, [directory])
        if spec is not None and spec.origin not in (None, first.origin):
            yield spec


@lru_cache
def missing_for_meshes() -> str:
    """The first library for measuring meshes that is not installed; empty if all are."""
    return next((name for name in _FOR_MESHES if find(name) is None), "")


def why_unmeasured() -> str:
    """Why meshes cannot be measured, to follow ``meshes are``; empty if they can."""
    missing = missing_for_meshes()
    if not missing:
        return ""
    from urdfkit.core.installation import install_command

    return f"not measured without {missing}: {install_command('meshes')}"
