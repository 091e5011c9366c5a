"""The result of the conversion to USD for each part of a robot, from the stage."""

from typing import Any

from pxr import UsdPhysics

from urdfkit.lint.context import Context
from urdfkit.output.conversion.hull_deviation import record_hulls
from urdfkit.output.conversion.losses import LossTable
from urdfkit.output.conversion.usd_proof import RESISTANCE
from urdfkit.output.conversion.usd_shapes import gprims
from urdfkit.output.conversion.usd_stage import Stage
from urdfkit.robot.assets.colours import Colours
from urdfkit.robot.joint import Joint
from urdfkit.robot.link import Body, Link

#: Note on elements that the converter does not support.
OTHERWISE = "stored under urdf:, which no simulator reads"
_NO_BODY = "the link is not a rigid body in USD: it is fixed and has no child links"
_NO_MESH = "the converter does not convert the mesh file"
_SHAPES = ("box", "sphere", "cylinder", "mesh")


def mark_parts(losses: LossTable, robot: Context, stage: Stage) -> None:
    """Record what the conversion did with links, joints and materials of a robot."""
    losses.keep(robot.model.root, "prim")
    colours = Colours(robot.model)
    for link in robot.model.links:
        _link(losses, link, stage)
        for geometry in link.bodies:
            _geometry(losses, geometry, colours, is_visual=geometry in link.visuals)
    record_hulls(losses, robot, robot.model.collisions)
    for prim, geometry in stage.shapes:
        if geometry.shape and not gprims(prim):
            losses.lose(geometry.shape.at, _NO_MESH)
    for joint in robot.model.joints:
        _joint(losses, joint, stage)


def _link(losses: LossTable, link: Link, stage: Stage) -> None:
    prim = stage.links.get(link.name)
    inertial = link.inertial
    if prim is None:
        losses.approximate(link.at, "part of the link that it is fixed to")
    else:
        losses.keep(link.at, f"prim {prim.GetPath()}")
    if inertial is None:
        return
    if prim is not None and not prim.HasAPI(UsdPhysics.RigidBodyAPI):
        losses.lose(inertial.at, _NO_BODY)
        return
    note = "part of the mass of the parent" if prim is None else "mass"
    losses.keep(inertial.at, note, "mass", "inertia", "origin")


def _geometry(losses: LossTable, geometry: Body, colours: Colours, *, is_visual: bool) -> None:
    shape = geometry.shape
    if shape is None or shape.kind not in _SHAPES:
        return
    note = "geometry" if is_visual else "collider"
    losses.keep(geometry.at, note, "origin", "geometry")
    losses.keep(geometry.at.attributes.get("name"), "name")
    losses.keep(shape.at, note)
    material = colours.of(geometry) if is_visual else None
    if material is None or geometry.material is None:
        return
    losses.keep(geometry.material.at, "material")
    losses.keep(material.at, "material", "color")
    texture = material.at.child("texture")
    if shape.kind == "mesh":
        losses.keep(texture, "texture, if the mesh has texture coordinates")


def _joint(losses: LossTable, joint: Joint, stage: Stage) -> None:
    prim = stage.joints.get(joint.name)
    note = prim.GetTypeName() if prim else "pose of the prim"
    note = "free rigid body" if joint.kind == "floating" else note
    losses.keep(joint.at, note)
    for tag in ("origin", "parent", "child"):
        losses.keep(joint.at.child(tag), "pose of the prim")
    if joint.kind in ("fixed", "floating"):
        for tag in ("axis", "limit", "dynamics", "mimic"):
            losses.lose(joint.at.child(tag), f"a {joint.kind} joint has none")
        return
    losses.keep(joint.at.child("axis"), "axis")
    _limits(losses, joint)
    if prim is not None:
        _attributes(losses, joint, prim)


def _attributes(losses: LossTable, joint: Joint, prim: Any) -> None:
    """Record attributes of a joint other than axis and range."""
    for path, (name, _) in RESISTANCE.items():
        tag, _, written = path.partition("@")
        element = joint.at.child(tag)
        if element is not None and prim.GetAttribute(f"newton:{name}").HasAuthoredValue():
            losses.keep(element, "joint")
            losses.keep(element.attributes.get(written), f"newton:{name}")
    for tag in ("calibration", "safety_controller"):
        element = joint.at.child(tag)
        losses.approximate(element, OTHERWISE)
        for attribute in element.attributes.values() if element is not None else ():
            losses.approximate(attribute, OTHERWISE)
    if joint.mimic is not None and prim.HasAPI("NewtonMimicAPI"):
        losses.keep(joint.mimic.at, "NewtonMimicAPI")


def _limits(losses: LossTable, joint: Joint) -> None:
    limit = joint.at.child("limit")
    if limit is None:
        return
    losses.keep(limit, "limits")
    for end in ("lower", "upper"):
        if joint.kind in ("continuous", "planar"):
            losses.lose(limit.attributes.get(end), f"a {joint.kind} joint has no range")
    losses.approximate(limit.attributes.get("effort"), OTHERWISE)
