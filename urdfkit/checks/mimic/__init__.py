"""Joints that mimic other joints."""

from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True if a joint mimics another one."""
    return any(joint.mimic for joint in context.model.joints)
