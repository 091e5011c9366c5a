"""Robots for other libraries, with expanded xacro and resolved packages."""

from __future__ import annotations

import os
from io import BytesIO
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree

from urdfkit.core.installation import needing
from urdfkit.errors import UnreadableRobot
from urdfkit.lint.context import Context
from urdfkit.lint.loading import read
from urdfkit.robot.model import RobotModel
from urdfkit.workspace.resolve import Resolver

if TYPE_CHECKING:
    from yourdfpy import URDF

    from urdfkit.text.document import Element


def to_yourdfpy(robot: Context | RobotModel | str | os.PathLike[str], **options: Any) -> URDF:
    """The robot as a `yourdfpy.URDF`: a trimesh scene with forward kinematics.

    yourdfpy reads plain URDF and searches for packages only near the file; this function expands
    xacro, and resolves meshes as urdfkit does.

    Args:
        robot: a URDF or xacro file, or the result of `urdfkit.read` or `urdfkit.load`.
        options: for ``yourdfpy.URDF.load``, such as ``load_meshes=False``.

    Raises:
        MissingLibrary: yourdfpy is not installed.
        UnreadableFile: the file is missing or cannot be read.
        UnreadableRobot: yourdfpy cannot read the robot; ``urdfkit.check`` reports why.
    """
    with needing("to_yourdfpy", "exchange"):
        from yourdfpy import URDF

    if isinstance(robot, RobotModel):
        resolver, path = Resolver(robot.packages), robot.document.sources[0].path
        text = ElementTree.tostring(element_tree(robot.root))
    else:
        context = robot if isinstance(robot, Context) else read(robot)
        resolver, path, text = context.resolver, context.source.path, context.text

    def found(fname: str) -> str:
        return resolver.locate(fname, path).path or fname

    try:
        urdf: URDF = URDF.load(BytesIO(text), filename_handler=found, **options)
    except Exception as error:  # yourdfpy raises any exception for a defective robot
        raise UnreadableRobot(f"yourdfpy cannot read {path}: {error}") from error
    return urdf


def element_tree(element: Element) -> ElementTree.Element:
    """A copy of an element, which can be changed and written."""
    root = ElementTree.Element("")
    stack = [(element, root)]
    while stack:
        element, parent = stack.pop()
        values = {name: attribute.value for name, attribute in element.attributes.items()}
        copy = ElementTree.SubElement(parent, element.tag, values)
        copy.text = element.text.strip() or None
        stack += [(child, copy) for child in reversed(element.children)]
    return root[0]
