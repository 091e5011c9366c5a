"""How a name that an expression looked up got its value."""

from __future__ import annotations

from typing import TYPE_CHECKING

from urdfkit.core.record import Record

if TYPE_CHECKING:
    from urdfkit.text.source import Span


class Origin(Record):
    """How a name got its value.

    Attributes:
        name: of the property, parameter or argument; the key in a YAML file.
        value: as text.
        kind: ``property``, ``argument``, ``default``, ``xacro:arg``, ``command line`` or ``YAML``.
        span: where it is given; None for the command line.
        text: what is written there.
        inputs: the names that the text looks up.
    """

    name: str
    value: str
    kind: str
    span: Span | None
    text: str
    inputs: tuple[Origin, ...]
