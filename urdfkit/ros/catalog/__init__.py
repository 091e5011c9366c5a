"""Facts about other programs: JSON files, each with a loader next to it.

The field ``about`` of a file, or its schema, explains its fields; ``source`` names the sources of
the facts. A file is loaded once, when it is first needed.
"""

import os
from collections.abc import Callable, Mapping
from functools import cache

from urdfkit.core.record import Record, frozen
from urdfkit.core.static_typing import Any, TypeVar

Entry = TypeVar("Entry", bound=Record)


@cache
def data(name: str) -> dict[str, Any]:
    """The content of ``<name>.json`` in this directory."""
    from json import load  # 3 ms, and most models need no facts

    with open(os.path.join(os.path.dirname(__file__), f"{name}.json"), encoding="utf-8") as file:
        content: dict[str, Any] = load(file)
    return content


def names(directory: str) -> list[str]:
    """Names of the JSON files of a directory, without suffix, in alphabetical order."""
    files = os.listdir(os.path.join(os.path.dirname(__file__), directory))
    return sorted(file.removesuffix(".json") for file in files if file.endswith(".json"))


def record(kind: type[Entry], entry: Mapping[str, Any], **more: object) -> Entry:
    """An entry of a file as a record, with lists as tuples; missing fields have their defaults.

    Args:
        kind: the class of the record; its fields have the names of the keys.
        entry: from the file; keys that are not fields are ignored.
        more: other fields, which override those of the entry.
    """
    fields = {name: frozen(entry[name]) for name in kind._fields if name in entry}
    create: Callable[..., Entry] = kind
    return create(**(fields | more))
