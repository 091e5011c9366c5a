"""Simulations of the robot in MuJoCo, which a check makes only if it is asked to (--simulate)."""

from urdfkit.checks.simulation.reported import RULES, reported
from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True if the check simulates, and the description is a whole robot.

    Raises:
        Unavailable: the robot cannot be simulated, which CFG003 reports.
    """
    return context.simulation is not None


def codes(context: Context) -> set[str]:
    """The rules whose tests the robot fails."""
    return {RULES[verdict.test] for verdict in reported(context)}
