"""Which libraries are installed; none is imported to find out.

``importlib.util`` does the same, and is one more import of every check.
"""

from __future__ import annotations

import sys
from functools import lru_cache

TYPE_CHECKING = False

if TYPE_CHECKING:
    from importlib.machinery import ModuleSpec

#: What measures meshes.
_FOR_MESHES = ("numpy", "lxml", "manifold3d", "mapbox_earcut")


def find(name: str) -> ModuleSpec | None:
    """From where a library would be imported; None if it is not installed."""
    for finder in sys.meta_path:
        spec = finder.find_spec(name, None)
        if spec is not None:
            return spec
    return None


@lru_cache
def missing_for_meshes() -> str:
    """A library that measuring meshes needs and that is not installed; empty if all are."""
    return next((name for name in _FOR_MESHES if find(name) is None), "")


def why_unmeasured() -> str:
    """Why meshes are not measured, and what to do, behind ``meshes are``; empty if they are."""
    missing = missing_for_meshes()
    if not missing:
        return ""
    from urdfkit.core.installation import install_command

    return f"not measured without {missing}: {install_command('meshes')}"
