"""MuJoCo settings in a URDF: ``<mujoco>``, and settings of mujoco_ros2_control."""

from collections.abc import Iterator
from typing import Any
from xml.etree.ElementTree import tostring

import mujoco

from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.output.conversion.losses import LossTable
from urdfkit.output.conversion.mjcf_robot import MjcfRobot
from urdfkit.output.exchange import element_tree
from urdfkit.text.document import Element

_MASSES = "the conversion writes the masses of the robot"
_FILES = "the conversion finds and copies the files"
#: Why attributes of ``<compiler>`` are lost: they apply to MuJoCo's URDF parser.
_COMPILER = {
    **dict.fromkeys(("balanceinertia", "boundinertia", "boundmass", "inertiafromgeom"), _MASSES),
    **dict.fromkeys(("inertiagrouprange", "settotalmass"), _MASSES),
    **dict.fromkeys(("assetdir", "meshdir", "strippath", "texturedir"), _FILES),
    "fusestatic": "replaced by the option --fixed",
    "discardvisual": "visuals become geoms that do not collide",
}
_MERGED = "mujoco_ros2_control merges it into the MJCF; urdfkit does not"


def add_options(mjcf: MjcfRobot, robot: Context) -> None:
    """Apply options and memory sizes of the URDF, and record other settings.

    Raises:
        UrdfkitError: MuJoCo rejects a setting.
    """
    root = robot.document.root
    for element, spec in _read(robot):
        if element.tag == "option":
            mjcf.spec.option = spec.option
        elif "memory" in element.attributes:
            mjcf.spec.memory = spec.memory
        _keep(mjcf.losses, element)
    block = root.child("mujoco")
    compiler = block.child("compiler") if block else None
    for name, attribute in compiler.attributes.items() if compiler else ():
        if name in _COMPILER:
            mjcf.losses.lose(attribute, _COMPILER[name])
    inputs = root.child("mujoco_inputs")
    raw = inputs.child("raw_inputs") if inputs else None
    for child in (*(inputs.children if inputs else ()), *(raw.children if raw else ())):
        if child.tag not in ("raw_inputs", "option"):
            mjcf.losses.lose(child, _MERGED)


def _keep(losses: LossTable, element: Element) -> None:
    """Record an ``<option>`` or ``<size>`` and its ancestors."""
    for part in element.walk():
        losses.keep(part, element.tag)
        for attribute in part.attributes.values():
            if element.tag == "option" or attribute.name == "memory":
                losses.keep(attribute, element.tag)
    block = element.parent
    while block is not None and block.tag != "robot":
        losses.approximate(block, "only options and memory")
        block = block.parent


def expected_options(robot: Context) -> Any:
    """The `mujoco.MjOption` of a model with the options that the URDF sets."""
    spec = mujoco.MjSpec()
    for element, read in _read(robot):
        if element.tag == "option":
            spec.option = read.option
    return spec.compile().opt


def _read(robot: Context) -> Iterator[tuple[Element, Any]]:
    """Elements with options or sizes, each with a specification with all options so far."""
    root = robot.document.root
    inputs = root.child("mujoco_inputs")
    settings = ""
    for block in (root.child("mujoco"), inputs.child("raw_inputs") if inputs else None):
        for element in block.children if block else ():
            if element.tag not in ("option", "size"):
                continue
            settings += tostring(element_tree(element), encoding="unicode")
            try:
                yield element, mujoco.MjSpec.from_string(f"<mujoco>{settings}</mujoco>")
            except ValueError as error:
                message = " ".join(str(error).partition("\n")[0].split())
                raise UrdfkitError(
                    f"{element.span}: MuJoCo rejects <{element.tag}>: {message}; correct it"
                ) from error
