"""Facts about other programs, as data: one JSON file per subject, one loader next to it.

Each file says in ``about``, or in its schema, what its fields mean, and in ``source`` where the
facts were read. A file is loaded once, when a model first needs it.
"""

from __future__ import annotations

import os
from functools import cache
from typing import Any


@cache
def data(name: str) -> dict[str, Any]:
    """The content of ``<name>.json`` in this directory."""
    from json import load  # 3 ms, and most models need no facts

    with open(os.path.join(os.path.dirname(__file__), f"{name}.json"), encoding="utf-8") as file:
        content: dict[str, Any] = load(file)
    return content
