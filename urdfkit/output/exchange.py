"""Robots for other libraries: with xacro expanded and packages found, which they cannot do."""

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
    """The robot as yourdfpy has it: a scene of trimesh with forward kinematics.

    yourdfpy reads plain URDF and looks for packages around the file only; here xacro is expanded,
    and meshes are looked for wherever urdfkit finds them.

    Args:
        robot: a URDF or xacro file, or what `urdfkit.read` or `urdfkit.load` gives of one.
        options: for ``yourdfpy.URDF.load``, such as ``load_meshes=False``.

    Raises:
        MissingLibrary: yourdfpy is not installed.
        UnreadableFile: the file is missing or may not be read.
        UnreadableRobot: yourdfpy does not get through it; ``urdfkit.check`` says why.
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
    except Exception as error:  # whatever a defect of a robot leads to there
        raise UnreadableRobot(f"yourdfpy cannot read {path}: {error}") from error
    return urdf


def element_tree(element: Element) -> ElementTree.Element:
    """An element with all in it, for a writer of XML."""
    values = {name: attribute.value for name, attribute in element.attributes.items()}
    found = ElementTree.Element(element.tag, values)
    found.text = element.text
    found.extend(map(element_tree, element.children))
    return found
