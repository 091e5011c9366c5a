"""Results of simulations."""

from __future__ import annotations

from urdfkit.core.record import Record
from urdfkit.core.static_typing import TYPE_CHECKING, Any
from urdfkit.text.source import Span, shown

if TYPE_CHECKING:
    from urdfkit.text.document import Attribute, Element


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
    at: Element | Attribute | None = None  # the cause; None if unknown
    warns: bool = False  # passes, but with something to look at
    rule: str = ""  # code of the rule that finds the same cause without a simulation; may be empty

    @property
    def span(self) -> Span | None:
        """Source location of the cause; None if unknown."""
        return self.at.span if self.at else None

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
                    "rule": verdict.rule or None,
                    "file": shown(verdict.span.source.path) if verdict.span else None,
                    "line": verdict.span.line if verdict.span else None,
                }
                for verdict in self.verdicts
            ],
        }
