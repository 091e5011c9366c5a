"""What simulations say of a robot."""

from __future__ import annotations

from typing import Any

from urdfkit.core.record import Record
from urdfkit.text.source import Span, shown


class Verdict(Record):
    """The result of one simulated test."""

    #: ``overlap``, ``energy``, ``stability``, ``drive``, ``sweep``, ``mimic``, ``hold``, ``drop``
    test: str
    passes: bool  # False if the robot does not behave
    message: str  # what happens, how much, and the bound
    value: float  # that was measured, in the unit of the message
    bound: float  # of the value
    names: tuple[str, ...] = ()  # of the links or joints that it is about
    span: Span | None = None  # where the cause is written; None where it has no place

    def __str__(self) -> str:
        where = f" ({self.span})" if self.span else ""
        return f"{'passes' if self.passes else 'FAILS'} {self.test}: {self.message}{where}"


class Simulation(Record):
    """All verdicts on a robot; ``is_free`` if its root floats and stands on a floor."""

    is_free: bool
    verdicts: tuple[Verdict, ...]

    @property
    def passes(self) -> bool:
        return all(one.passes for one in self.verdicts)

    @property
    def facts(self) -> dict[str, Any]:
        """The verdict for JSON."""
        return {
            "base": "free" if self.is_free else "fixed",
            "passes": self.passes,
            "verdicts": [
                {
                    "test": one.test,
                    "passes": one.passes,
                    "message": one.message,
                    "value": one.value,
                    "bound": one.bound,
                    "names": list(one.names),
                    "file": shown(one.span.source.path) if one.span else None,
                    "line": one.span.line if one.span else None,
                }
                for one in self.verdicts
            ],
        }
