"""How a name that an expression looked up got its value."""

from __future__ import annotations

from urdfkit.core.record import Record
from urdfkit.text.source import Span


class Origin(Record):
    """How a name got its value."""

    name: str  # of the property, parameter or argument; the key in a YAML file
    value: str  # as text
    #: ``property``, ``argument``, ``default``, ``xacro:arg``, ``command line`` or ``YAML``.
    kind: str
    span: Span | None  # where it is given; None for the command line
    text: str  # what is written there
    inputs: tuple[Origin, ...]  # the names that the text looks up
