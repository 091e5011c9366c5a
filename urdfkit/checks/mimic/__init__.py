"""Joints that mimic others."""

from __future__ import annotations

from urdfkit.lint.context import Subject

#: Former codes and names, and the rules that report their findings now.
REDIRECTS = {
    "fingers-move-together": "JNT032",
    "JNT014": "JNT015", "mimic-itself": "JNT015", "mimic-cycle": "JNT015", "JNT017": "JNT015",
    "mimic-of-fixed": "JNT015", "JNT036": "JNT015", "mimic-without-effect": "JNT015",
}  # fmt: skip


def applies(subject: Subject) -> bool:
    """True if a joint mimics another one."""
    return any(joint.mimic for joint in subject.model.joints)
