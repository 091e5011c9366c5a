"""Joints: types, axes, limits."""

from __future__ import annotations

from urdfkit.lint.context import Context


def applies(subject: Context) -> bool:
    """True for a document with a robot in it: links have poses, too."""
    is_robot = bool(subject.model.joints or subject.model.links)
    return is_robot and not subject.is_list_of_joints
