"""Facts about other programs, as data: one JSON file per subject, one loader beside it.

Each file says in ``about`` what its fields mean and in ``source`` or ``sources`` where the facts
were read. A file is loaded when a model first has something that it tells about, and once.
"""

from __future__ import annotations

import os
from functools import cache
from typing import Any


@cache
def data(name: str) -> dict[str, Any]:
    """The content of ``<name>.json`` in this folder."""
    content: dict[str, Any] = loads(text(name))
    return content


def text(name: str) -> str:
    """The text of ``<name>.json``."""
    with open(os.path.join(os.path.dirname(__file__), f"{name}.json"), encoding="utf-8") as file:
        return file.read()


def loads(written: str) -> Any:
    """The value of a JSON text."""
    from json import loads  # 3 ms, and most models need no facts

    return loads(written)
