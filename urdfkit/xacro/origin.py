"""Origins of the values that expressions use."""

from __future__ import annotations

from urdfkit.core.record import Record
from urdfkit.text.diagnostic import Related
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


class DataPlaces(Record):
    """The places in YAML files of the values that the expressions of an element yield."""

    lines: tuple[Related, ...]  # the first value on each line
    #: The first value, if it is the number in a YAML file that is to be edited: the expressions
    #: do not calculate.
    value: Span | None
