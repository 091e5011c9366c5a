"""Joints: types, axes, limits."""

from urdfkit.lint.context import Context
from urdfkit.text.file_kinds import is_list_of_joints


def applies(context: Context) -> bool:
    """True for a document that contains a robot: links alone can have wrong origins, too."""
    is_robot = bool(context.model.joints or context.model.links)
    return is_robot and not is_list_of_joints(context.document.root)
