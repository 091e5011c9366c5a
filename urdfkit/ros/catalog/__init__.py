"""Facts about other programs, as data: one JSON file per context, one loader next to it.

Each file says in ``about``, or in its schema, what its fields mean, and in ``source`` where the
facts were read. A file is loaded once, when a model first needs it.
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
    """What the files of a directory are about, in the order of the alphabet."""
    files = os.listdir(os.path.join(os.path.dirname(__file__), directory))
    return sorted(file.removesuffix(".json") for file in files if file.endswith(".json"))


def record(kind: type[Entry], entry: Mapping[str, Any], **more: object) -> Entry:
    """What a file says of one thing, lists as tuples; fields that it lacks have their defaults.

    Args:
        kind: the class of the record, with the names of the file.
        entry: from the file; keys that are no fields are left out.
        more: fields that the entry does not have under their names.
    """
    given = {name: frozen(entry[name]) for name in kind._fields if name in entry}
    make: Callable[..., Entry] = kind
    return make(**(given | more))
