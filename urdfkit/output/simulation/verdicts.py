"""Results of simulations."""

from __future__ import annotations

from typing import Any

from urdfkit.core.record import Record
from urdfkit.text.source import Span, shown


class Verdict(Record):
    """The result of one simulated test."""

    #: ``size``, ``overlap``, ``energy``, ``stability``, ``timestep``, ``drive``, ``sweep``,
    #: ``mimic``, ``hold``, ``drop``
    test: str
    passes: bool
    message: str  # the observation, with value and bound
    value: float  # measured value, in the unit of the message
    bound: float  # of the value
    names: tuple[str, ...] = ()  # the links or joints concerned
    span: Span | None = None  # source location of the cause; None if unknown
    warns: bool = False  # passes, but with something to look at

    def __str__(self) -> str:
        where = f" ({self.span})" if self.span else ""
        result = "warns" if self.warns else "passes" if self.passes else "FAILS"
        return f"{result} {self.test}: {self.message}{where}"


class Simulation(Record):
    """All verdicts on a robot; ``is_free`` if its root floats and stands on a floor."""

    is_free: bool
    verdicts: tuple[Verdict, ...]
    srdf: str | None = None  # path of the SRDF whose disabled pairs do not collide

    @property
    def passes(self) -> bool:
        return all(verdict.passes for verdict in self.verdicts)

    @property
    def facts(self) -> dict[str, Any]:
        """The verdicts for JSON."""
        return {
            "base": "free" if self.is_free else "fixed",
            "passes": self.passes,
            "srdf": shown(self.srdf) if self.srdf else None,
            "verdicts": [
                {
                    "test": verdict.test,
                    "passes": verdict.passes,
                    "warns": verdict.warns,
                    "message": verdict.message,
                    "value": verdict.value,
                    "bound": verdict.bound,
                    "names": list(verdict.names),
                    "file": shown(verdict.span.source.path) if verdict.span else None,
                    "line": verdict.span.line if verdict.span else None,
                }
                for verdict in self.verdicts
            ],
        }
