"""The origin of a value that an expression uses."""

from __future__ import annotations

from urdfkit.core.record import Record
from urdfkit.text.source import Span


class Origin(Record):
    """The definition that a name has its value from."""

    name: str  # of the property, parameter or argument; the key in a YAML file
    value: str  # as text
    #: ``property``, ``argument``, ``default``, ``xacro:arg``, ``command line`` or ``YAML``.
    kind: str
    span: Span | None  # of the definition; None for the command line
    text: str  # source text of the definition
    inputs: tuple[Origin, ...]  # origins of the names in the text
