"""The URDF of a bundle: the expanded robot with references to the files of the bundle."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

from urdfkit.core.record import Record
from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.robot.model import RobotModel
from urdfkit.robot.placed import Placed
from urdfkit.text.diagnostic import Edit
from urdfkit.text.document import Element
from urdfkit.text.editing.apply import apply_edits
from urdfkit.text.editing.edits import escaped, insert_first
from urdfkit.text.source import Source, Span
from urdfkit.text.xml_reader import read_xml

_DECLARATION = rb"^\s*<\?xml[^>]*\?>\s*"
#: A value that refers to a file of this machine or of a package.
_OUTSIDE = re.compile(r"(?:package|model|file)://|/[^/]+/.*\.\w+$")


class Renamed(Record):
    """A file reference, and its replacement in the bundle."""

    element: str  # path in the expanded robot, such as ``link/arm/visual/geometry/mesh``
    span: Span  # source location
    old: str  # original reference
    new: str  # reference in the bundle


def mesh_references(model: RobotModel) -> list[Placed[str]]:
    """Mesh references of a model, in the order of its links."""
    return [shape.filename for shape in model.shapes if shape.filename]


def texture_references(model: RobotModel) -> list[Placed[str]]:
    """Texture references of a model, those of its named materials first."""
    materials = (*model.materials, *(body.material for body in model.visuals))
    return [material.texture for material in materials if material and material.texture]


def references(model: RobotModel) -> list[Placed[str]]:
    """References to all files that are required to load a model."""
    return [*mesh_references(model), *texture_references(model)]


def rewritten(
    robot: Context, new_name: Callable[[Placed[str]], str], *, for_mujoco: bool
) -> tuple[bytes, tuple[Renamed, ...], tuple[tuple[str, str], ...]]:
    """The expanded robot with new file references.

    Args:
        new_name: returns the new path for a reference.
        for_mujoco: make MuJoCo keep the directories of mesh files, which it drops by default.

    Returns:
        The URDF; the changed references; and values that still refer to other files, such as plugin
        parameters, after the paths of their elements.

    Raises:
        UrdfkitError: the expanded text cannot be edited.
    """
    text = re.sub(_DECLARATION, b"", robot.text)
    source = Source("robot.urdf", b'<?xml version="1.0" encoding="utf-8"?>\n' + text)
    document, _ = read_xml(source)
    if document is None:
        raise UrdfkitError(f"{robot.source.path}: the expanded robot is not valid XML")
    model = RobotModel(document)
    edits: list[Edit] = []
    renamed = []
    for old, new_reference in zip(references(robot.model), references(model), strict=True):
        new = new_name(old)
        edits.append(Edit(new_reference.span, escaped(new)))
        renamed.append(Renamed(old.at.path, old.span, old.value, new))
    if for_mujoco:
        edits += _compiler(model.root)
    return apply_edits(source.data, edits), tuple(renamed), tuple(_outside(model))


def _compiler(root: Element) -> tuple[Edit, ...]:
    """MuJoCo's ``<compiler>`` with ``strippath="false"`` and no ``meshdir``."""
    mujoco = root.child("mujoco")
    compiler = mujoco.child("compiler") if mujoco else None
    if mujoco is None:
        return insert_first(root, ['<mujoco><compiler strippath="false"/></mujoco>'])
    if compiler is None:
        return insert_first(mujoco, ['<compiler strippath="false"/>'])
    attributes = {at.name: at.value for at in compiler.attributes.values() if at.name != "meshdir"}
    attributes["strippath"] = "false"
    values = "".join(f' {name}="{escaped(value)}"' for name, value in attributes.items())
    return (Edit(compiler.tag_at.whole_span, f"<compiler{values}/>"),)


def _outside(model: RobotModel) -> Iterator[tuple[str, str]]:
    """Values other than references that refer to files outside of the bundle."""
    referenced = {id(placed.at) for placed in references(model)}
    for element in model.root.walk():
        values = [at.value for at in element.attributes.values() if id(at) not in referenced]
        for value in (*values, element.text.strip()):
            if _OUTSIDE.match(value):
                yield element.path, value
