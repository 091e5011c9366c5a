"""The verdicts of simulations that rules report."""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.lint.rules import Context, Finding, Findings, Severity

if TYPE_CHECKING:
    from urdfkit.physics.verdicts import Verdict

#: The rule that reports the verdicts of each test. Other rules find overlaps at the start (COL001)
#: and joints that do not hold their load (DYN003).
RULES = {
    "energy": "SIM001",
    "stability": "SIM001",
    "timestep": "SIM001",
    "drive": "SIM002",
    "sweep": "SIM002",
    "mimic": "SIM002",
    "drop": "SIM003",
    "size": "SIM004",
}


def reported(context: Context) -> Iterator[Verdict]:
    """The verdicts that fail or warn, unless another rule finds the same cause.

    If the size of the robot is wrong, the other verdicts are consequences.
    """
    verdicts = context.simulation.verdicts if context.simulation else ()
    wrong_size = [verdict for verdict in verdicts if verdict.test == "size" and not verdict.passes]
    for verdict in wrong_size or verdicts:
        is_reported = verdict.warns or not verdict.passes
        if is_reported and not verdict.rule and verdict.test in RULES:
            yield verdict


def findings(context: Context, code: str) -> Findings:
    """The findings of a rule: at the cause, or at the robot if it is unknown."""
    for verdict in reported(context):
        if RULES[verdict.test] == code:
            at = verdict.at or context.document.root
            severity = Severity.WARNING if verdict.warns else None
            yield Finding(at, verdict.message, group_key=verdict.test, severity=severity)
