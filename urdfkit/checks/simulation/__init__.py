"""Simulations of the robot in MuJoCo, which a check makes only if it is asked to (--simulate)."""

from urdfkit.checks.simulation.reported import RULES, reported
from urdfkit.errors import Unavailable
from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True if the check simulates, and the description is a whole robot.

    Raises:
        Unavailable: a mesh file is missing, which MSH001 reports.
    """
    if not context.simulates or context.is_part or not context.tree.is_sound:
        return False
    bodies = [body for link in context.model.links for body in link.collisions]
    names = [body.shape.filename for body in bodies if body.shape and body.shape.filename]
    if any(context.files.locate(name).path is None for name in names):
        raise Unavailable("not simulated: mesh files of collisions are missing")
    return True


def codes(context: Context) -> set[str]:
    """The rules whose tests the robot fails."""
    return {RULES[verdict.test] for verdict in reported(context)}
