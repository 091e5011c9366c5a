"""The result of the conversion to SDF for each part of a robot."""

from urdfkit.core.spatial import Transform, from_rpy
from urdfkit.output.bundle import Bundle
from urdfkit.output.bundle.robot import mesh_references
from urdfkit.output.conversion.losses import LossTable
from urdfkit.output.conversion.sdf_extensions import POSED, RECEIVERS, GazeboBlock, is_read_as_rpy
from urdfkit.output.conversion.sdf_model import SdfModel, is_hinge
from urdfkit.output.conversion.sdf_proof import difference
from urdfkit.output.conversion.sdf_values import snapped_rpy
from urdfkit.robot.assets.colours import Colours
from urdfkit.robot.joint import Joint
from urdfkit.robot.link import Body, Link, Material
from urdfkit.robot.rigid_bodies import KEEPING_TAGS
from urdfkit.ros.gazebo.conversion import SdfConversion
from urdfkit.text.document import Attribute, Element

#: Why parts are lost: the default reason, and reasons by tag.
OTHERWISE = "sdformat does not read it"
REASONS = {
    "texture": "sdformat reads only the colour of a material",
    "transmission": "not in SDF; controllers read it from the URDF",
    "ros2_control": "not in SDF; controllers read it from the URDF",
    "material": "no visual uses its colour",
    "color": "no visual uses its colour",
}

#: Least difference of two rotations that counts.
_TURNED = 1e-9


def record_losses(
    losses: LossTable, conversion: SdfConversion, model: SdfModel, bundle: Bundle
) -> None:
    """Record what the conversion did with each part of a robot.

    Args:
        model: the resulting SDF model.
        bundle: the written files.
    """
    root = conversion.model.root
    losses.keep(root, "model")
    losses.keep(root.child("origin"), "pose of the model")
    for link in conversion.model.links:
        _link(losses, link, conversion)
    _shapes(losses, conversion, model)
    for joint in conversion.model.joints:
        _joint(losses, joint, conversion)
    for extension in model.extensions.all:
        _extension(losses, extension, conversion)
    changes = {entry.path: entry.change for entry in bundle.contents}
    references = mesh_references(conversion.model)
    for reference, renamed in zip(references, bundle.renamed, strict=False):
        if isinstance(reference.at, Attribute) and _is_kept(reference.at.element, conversion):
            losses.keep(reference.at, f"copied as {renamed.new}")
            if changes[renamed.new]:
                losses.approximate(reference.at, changes[renamed.new])
    by_path = {element.path: element for block in root.all("gazebo") for element in block.walk()}
    for path, value in bundle.outside:
        if path in by_path:
            losses.approximate(by_path[path], f"'{value}' refers to a file that is not copied")


def _is_kept(element: Element | None, conversion: SdfConversion) -> bool:
    """True for a part of a link that Gazebo does not drop."""
    while element is not None and element.tag != "link":
        element = element.parent
    return element is not None and element.get("name") not in conversion.dropped


def _link(losses: LossTable, link: Link, conversion: SdfConversion) -> None:
    into = conversion.merged.get(link.name, "")
    if link.name in conversion.dropped:
        losses.lose(link.at, f"Gazebo drops the link: {conversion.dropped[link.name]}")
        return
    if into:
        losses.approximate(link.at, f"frame of '{into}', into which it is merged")
    else:
        losses.keep(link.at, "link")
    inertial = link.inertial
    if inertial is not None and link.name in conversion.survivor:
        note = f"part of the mass of '{into}'" if into else "mass"
        losses.keep(inertial.at, note, "mass", "inertia")
        _origin(losses, inertial.at, inertial.origin, note, is_turned=bool(into))


def _shapes(losses: LossTable, conversion: SdfConversion, model: SdfModel) -> None:
    colours = Colours(conversion.model)
    for link in conversion.links:
        names = {id(at): name for name, at in (*link.collisions, *link.visuals)}
        for part, frame in link.body.links:
            for body in (*part.collisions, *part.visuals):
                _shape(losses, body, names[id(body.at)], frame)
            for body in part.visuals:
                _colour(losses, body, colours.of(body), model)


def _colour(losses: LossTable, body: Body, defined: Material | None, model: SdfModel) -> None:
    """Record the material of a visual; ``defined`` has its colour."""
    if body.material is None or defined is None:
        return
    if id(body.at) not in model.coloured:
        losses.lose(body.material.at, "the visual has the material of a <gazebo>")
        return
    losses.keep(body.material.at, "colour of the visual")
    losses.keep(defined.at, "colour of visuals")
    losses.approximate(defined.at.child("color"), "diffuse and ambient, 1.25 times as bright")


def _shape(losses: LossTable, body: Body, name: str, frame: Transform) -> None:
    losses.keep(body.at, name, "geometry")
    losses.keep(body.at.attributes.get("name"), name)
    _origin(losses, body.at, frame @ body.origin, name, is_turned=True)
    if body.shape is not None:
        losses.keep(body.shape.at, name)


def _origin(
    losses: LossTable, at: Element, frame: Transform, note: str, *, is_turned: bool
) -> None:
    """Record an origin; if ``is_turned``, urdfdom rounds a pitch near 90 degrees to 90 degrees."""
    origin = at.child("origin")
    losses.keep(origin, note)
    rounded = Transform(from_rpy(*snapped_rpy(frame.rotation)), frame.position)
    error = difference(frame, rounded) if is_turned else 0.0
    if error > _TURNED:
        losses.approximate(origin, f"the pitch is rounded to 90 degrees, off by {error:.2g} rad")


def _joint(losses: LossTable, joint: Joint, conversion: SdfConversion) -> None:
    if joint.child_name in conversion.dropped:
        losses.lose(joint.at, f"Gazebo drops '{joint.child_name}'")
        return
    is_merged = joint.name not in conversion.joint_names
    what = "frame" if is_merged else "joint"
    if is_merged or is_hinge(joint, conversion):
        note = "frame; the links are merged" if is_merged else "revolute joint from 0 to 0"
        losses.approximate(joint.at, note)
    else:
        losses.keep(joint.at, what)
    for tag in ("origin", "parent", "child"):
        losses.keep(joint.at.child(tag), what)
    for tag in ("axis", "limit", "dynamics", "mimic"):
        part = joint.at.child(tag)
        if part is not None and joint.kind == "fixed":
            losses.lose(part, "a fixed joint has none")
        elif part is not None:
            _of_axis(losses, joint, part)
    if joint.leader and joint.kind != "fixed" and joint.leader not in conversion.joint_names:
        note = f"the SDF has no joint '{joint.leader}' to follow"
        losses.approximate(joint.at.child("mimic"), note)


def _of_axis(losses: LossTable, joint: Joint, part: Element) -> None:
    losses.keep(part, "joint")
    for name in ("effort", "velocity", "damping", "friction"):
        losses.keep(part.attributes.get(name), "joint")
    for name in ("lower", "upper"):
        if joint.kind == "continuous":
            losses.lose(part.attributes.get(name), "a continuous joint has no range")


def _extension(losses: LossTable, extension: GazeboBlock, conversion: SdfConversion) -> None:
    """Record the children of a ``<gazebo>``, with the tags that received them."""
    block, reference = extension.block, extension.block.get("reference") or ""
    joint = conversion.model.joints_by_name.get(reference)
    if not extension.receivers and not any(child.tag in KEEPING_TAGS for child in block.children):
        losses.lose(block, _nothing(reference, joint, conversion))
        return
    losses.keep(block, "its children")
    is_fixed = joint is not None and joint.kind == "fixed"
    for child in block.children:
        if child.tag == "canonicalBody" or (child.tag in KEEPING_TAGS and not is_fixed):
            losses.lose(child, "sdformat ignores it")
            continue
        is_shape = child.tag in ("visual", "collision")
        receiver = RECEIVERS.get(child.tag, child.tag if is_shape else "")
        if child.tag in KEEPING_TAGS:
            receiver = "joint"
        elif receiver and receiver not in extension.receivers:
            losses.lose(child, _unreceived(receiver, reference, conversion))
            continue
        _keep_all(losses, child, f"of the {receiver}" if receiver else "as written")
        pose = child.child("pose") if child.tag in POSED else None
        if pose is not None and is_read_as_rpy(pose, is_moved=reference in conversion.merged):
            losses.approximate(pose, "sdformat reads it as x y z and rpy in rad when it moves it")


def _keep_all(losses: LossTable, root: Element, note: str) -> None:
    for element in root.walk():
        losses.keep(element, note)
        for attribute in element.attributes.values():
            losses.keep(attribute, "as written")


def _unreceived(receiver: str, reference: str, conversion: SdfConversion) -> str:
    """The reason why a setting of a block for some SDF tag is ignored."""
    if not reference:
        return f"it applies to a {receiver}, and the <gazebo> has no reference"
    if receiver == "model":
        return "it applies to the model, in a <gazebo> without a reference"
    link = conversion.model.links_by_name.get(reference)
    shapes = {"collision": link.collisions, "visual": link.visuals} if link else {}
    if shapes.get(receiver):  # GAZ067 explains which names are
        return f"no {receiver} of '{reference}' has a name that it applies to"
    return f"it applies to a {receiver}, and '{reference}' has none"


def _nothing(reference: str, joint: Joint | None, conversion: SdfConversion) -> str:
    """The reason why a block is ignored."""
    if joint is not None and reference not in conversion.joint_names:
        return f"joint '{reference}' is merged or dropped"
    if reference in conversion.dropped:
        return f"link '{reference}' is dropped"
    return f"no link or joint '{reference}'" if reference else "it is empty"
