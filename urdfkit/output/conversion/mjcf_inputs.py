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
#: Fields of an actuator in MuJoCo's specification, apart from its name and its joint.
_ACTUATOR_FIELDS = tuple(
    """
    actdim actearly actlimited actrange armature biasprm biastype cranklength ctrllimited ctrlrange
    ctrlspec damping delay dynprm dyntype ffrange forcelimited forcerange gainprm gaintype gear
    group inheritrange interp lengthrange nsample velrange
    """.split()
)
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
        if child.tag not in ("raw_inputs", "option", "actuator"):
            mjcf.losses.lose(child, _MERGED)


def add_given_actuators(mjcf: MjcfRobot, robot: Context) -> set[str]:
    """Add the actuators of joints in ``<mujoco_inputs>``, and return the names of the joints.

    Raises:
        UrdfkitError: MuJoCo rejects an actuator, or there is no such joint.
    """
    inputs = robot.document.root.child("mujoco_inputs")
    raw = inputs.child("raw_inputs") if inputs else None
    joints = {joint.name for joint in robot.model.joints if joint.kind != "fixed"}
    driven: set[str] = set()
    for block in raw.all("actuator") if raw else ():
        for element in block.children:
            joint = element.get("joint")
            if joint is None or "class" in element.attributes:
                mjcf.losses.lose(element, "only actuators of joints without a class are converted")
                continue
            if joint not in joints:
                raise UrdfkitError(
                    f"{element.span}: <{element.tag}> is for an unknown joint '{joint}'; correct it"
                )
            name = element.get("name") or (f"{joint}_{element.tag}" if joint in driven else joint)
            _copy_actuator(mjcf, _parsed(element).actuators[0], name)
            driven.add(joint)
            _keep(mjcf.losses, element)
    return driven


def _copy_actuator(mjcf: MjcfRobot, actuator: Any, name: str) -> None:
    copy = mjcf.spec.add_actuator(name=name, target=actuator.target, trntype=actuator.trntype)
    for field in _ACTUATOR_FIELDS:
        setattr(copy, field, getattr(actuator, field))


def _parsed(element: Element) -> Any:
    """The `mujoco.MjSpec` with one actuator.

    Raises:
        UrdfkitError: MuJoCo rejects it.
    """
    text = tostring(element_tree(element), encoding="unicode")
    return _specification(element, f"<actuator>{text}</actuator>")


def _keep(losses: LossTable, element: Element) -> None:
    """Record an ``<option>``, a ``<size>`` or an actuator, and its ancestors."""
    for part in element.walk():
        losses.keep(part, element.tag)
        for attribute in part.attributes.values():
            if element.tag != "size" or attribute.name == "memory":
                losses.keep(attribute, element.tag)
    block = element.parent
    while block is not None and block.tag != "robot":
        losses.approximate(block, "only options, memory and actuators")
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
            yield element, _specification(element, settings)


def _specification(element: Element, content: str) -> Any:
    """The `mujoco.MjSpec` of the content of a ``<mujoco>``, which an element is the last part of.

    Raises:
        UrdfkitError: MuJoCo rejects it.
    """
    try:
        return mujoco.MjSpec.from_string(f"<mujoco>{content}</mujoco>")
    except ValueError as error:
        message = " ".join(str(error).partition("\n")[0].split())
        raise UrdfkitError(
            f"{element.span}: MuJoCo rejects <{element.tag}>: {message}; correct it"
        ) from error
