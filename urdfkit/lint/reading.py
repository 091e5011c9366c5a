"""One description as it was read."""

from __future__ import annotations

from typing import TYPE_CHECKING

from urdfkit.core.record import Record

if TYPE_CHECKING:
    from urdfkit.text.diagnostic import Problem
    from urdfkit.text.document import Document
    from urdfkit.xacro import Xacro


class Reading(Record):
    """A description as it was read.

    Attributes:
        document: after expansion; None if it could not be read.
        problems: what is wrong with the text.
        xacro: what the expansion met; None for plain XML.
    """

    document: Document | None
    problems: tuple[Problem, ...]
    xacro: Xacro | None
