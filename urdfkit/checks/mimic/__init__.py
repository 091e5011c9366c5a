"""Joints that mimic others."""

from __future__ import annotations

from urdfkit.lint.context import Subject


def applies(subject: Subject) -> bool:
    """True if a joint mimics another one."""
    return any(joint.mimic for joint in subject.model.joints)
