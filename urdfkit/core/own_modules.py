"""urdfkit's own modules, found without a search.

A check imports 330 modules. For each of them Python asks all of its finders, which look at the
other packages of the environment as well: 17 of 486 million instructions of a check.
"""

from __future__ import annotations

import os
import sys
from importlib.machinery import ModuleSpec, SourceFileLoader

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from types import ModuleType


class OwnModules:
    """Finds ``urdfkit.a.b`` as ``b.py`` or ``b/__init__.py`` in the directory of ``urdfkit.a``."""

    @staticmethod
    def find_spec(
        name: str, path: Sequence[str] | None, _target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """None for other packages, and for files that are not there, as in a zip archive."""
        if path is None or not name.startswith("urdfkit."):
            return None
        base = f"{path[0]}{os.sep}{name.rpartition('.')[2]}"
        package = f"{base}{os.sep}__init__.py"
        file = next(filter(os.path.exists, (f"{base}.py", package)), None)
        if file is None:
            return None
        spec = ModuleSpec(name, SourceFileLoader(name, file), origin=file)
        spec.submodule_search_locations = [base] if file == package else None
        spec.has_location = True
        return spec


def install() -> None:
    """Let this process find urdfkit's modules so; other finders find all others."""
    if OwnModules not in sys.meta_path:
        sys.meta_path.insert(0, OwnModules)
