"""What urdfkit notes about the names in xacro's tables of properties and macros."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from urdfkit.xacro.dom import Node
    from urdfkit.xacro.trace import Origin

#: Holds spaces: a name space of xacro makes keys of its attributes, and no model has this one.
_KEY = "notes of urdfkit"


class TableAnnotations:
    """About the names of one table.

    Attributes:
        definers: the elements that define them.
        used: those that were looked up since.
        inputs: what the expressions of their values looked up, if the run is traced.
    """

    __slots__ = ("definers", "inputs", "used")

    def __init__(self) -> None:
        self.definers: dict[str, Node] = {}
        self.used: set[str] = set()
        self.inputs: dict[str, tuple[Origin, ...]] = {}


def notes_of(table: Any) -> TableAnnotations:
    """The notes of a table; of the built-in names, which are no such table, none."""
    variables: dict[str, Any] = getattr(table, "__dict__", {})
    notes: TableAnnotations | None = variables.get(_KEY)
    if notes is None:
        notes = variables[_KEY] = TableAnnotations()
    return notes
