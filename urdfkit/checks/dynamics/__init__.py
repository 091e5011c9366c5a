"""Dynamics: gravity torques, stability, the mass matrix."""

from urdfkit.lint.context import Context
from urdfkit.robot.joint import DEGREES_OF_FREEDOM


def applies(context: Context) -> bool:
    """True if a joint moves and a link has a mass, or Pinocchio is a target."""
    model = context.model
    if "pinocchio" in context.given_targets:
        return True
    return any(joint.kind in DEGREES_OF_FREEDOM for joint in model.joints) and any(
        link.mass for link in model.links
    )
