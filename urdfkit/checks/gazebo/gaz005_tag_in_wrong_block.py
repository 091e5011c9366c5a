"""A tag is in a `<gazebo>` block of the wrong kind, where it has no effect.

Gazebo's converter applies `mu1`, `kp`, `selfCollide` and the like to links, and
`preserveFixedJoint`, `provideFeedback`, `springStiffness` and the like to joints; in a block that
refers to the other kind they have no effect, and neither does `preserveFixedJoint` for a joint that
is not fixed: a warning.

A block without a reference belongs to the whole model, which has no friction, material or sensor:
the converter stores these tags and never uses them, without a message. That is an error. Write one
block per link, with `reference="..."`. The `<physics>` of a world in such a block is a warning. A
tag with its default value, such as `<gravity>true</gravity>`, is not reported.

Sources:
    SDFormat extensions to URDF: http://sdformat.org/tutorials?tut=sdformat_urdf_extensions
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
"""

from collections.abc import Mapping

from urdfkit.lint.rules import Context, Finding, Findings, Fix, Severity, rule
from urdfkit.robot.joint import Joint
from urdfkit.robot.link import Link
from urdfkit.robot.model import RobotModel
from urdfkit.robot.rigid_bodies import KEEPING_TAGS
from urdfkit.robot.samples import joint_xml, link_xml, robot_xml
from urdfkit.ros.catalog.extensions import Extension, copied, extensions
from urdfkit.ros.gazebo.samples import gazebo_xml, solid_xml
from urdfkit.text.diagnostic import Edit
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import STEP, insert_after, lines_of, remove_element

BAD = robot_xml(
    solid_xml("base"),
    link_xml("camera"),
    joint_xml("fixed", name="camera_joint", child="camera"),
    gazebo_xml("<preserveFixedJoint>true</preserveFixedJoint>", reference="camera"),
)
FIXED = GOOD = BAD.replace('reference="camera"', 'reference="camera_joint"')

#: Without which a robot moves as it does with them: its colour, and which links it is made of.
_HARMLESS = {"material", "visual", *KEEPING_TAGS}
#: Tags of SDF that are false unless they are set, as those of the converter; gravity is true.
_FLAGS = ("enable_wind", "kinematic", "must_be_base_link", "self_collide")
_TRUE, _FALSE = ("1", "true", "yes"), ("0", "false", "no")
#: Number of tags of a block that a message lists.
_MAX_NAMED = 4


@rule(Severity.WARNING)
def check(context: Context) -> Findings:
    model = context.model
    handled = extensions()
    owners = _owners(handled)
    for block in model.gazebo:
        name = block.get("reference") or ""
        is_link, joint = name in model.links_by_name, model.joints_by_name.get(name)
        if not name:
            yield from _without_reference(model, block, owners, handled)
        elif is_link != (joint is not None):  # neither: GAZ001, both: NAM003
            yield from _of_other_kind(context, block, handled, joint)


def _of_other_kind(
    context: Context, block: Element, handled: Mapping[str, Extension], joint: Joint | None
) -> Findings:
    """The tags of joints in the block of a link, and those of links in the block of a joint."""
    name, kind = block.get("reference") or "", "joint" if joint else "link"
    for child in block.children:
        extension = handled.get(child.tag)
        if _is_default(child, extension):
            continue
        if extension and extension.on in ("link", "joint") and extension.on != kind:
            message = f"<{child.tag}> is for a {extension.on}, but '{name}' is a {kind} (ignored)"
            other = _other(context, name, kind)
            help = f'move it into <gazebo reference="{other.name if other else "..."}">'
            fix = _moved(block, child, other) if other else None
            yield Finding(child, message, help, fix, group_key=child.tag)
        elif joint and child.tag in KEEPING_TAGS and joint.kind not in ("fixed", ""):
            message = f"<{child.tag}> has no effect: joint '{name}' is {joint.kind}, not fixed"
            yield Finding(child, message, "remove it, or name a fixed joint", group_key=child.tag)


def _owners(handled: Mapping[str, Extension]) -> dict[str, str]:
    """``link`` or ``joint`` for each tag that a model does not have."""
    owners = {
        tag: extension.on for tag, extension in handled.items() if extension.on in ("link", "joint")
    }
    of_model = set(copied("model"))
    for kind in ("joint", "link"):
        owners.update((tag, kind) for tag in copied(kind) if tag not in of_model)
    return owners


def _is_default(child: Element, extension: Extension | None) -> bool:
    """True if a tag has its default value, so that nothing is lost without it."""
    text = child.text.strip().lower()
    is_flag = child.tag in _FLAGS or (extension is not None and extension.type == "bool")
    return text in _FALSE if is_flag else child.tag == "gravity" and text in _TRUE


def _without_reference(
    model: RobotModel, block: Element, owners: Mapping[str, str], handled: Mapping[str, Extension]
) -> Findings:
    """At the misspelt attribute, at the tag, or at the block if it holds several."""
    for attribute in block.attributes.values():
        name, value = attribute.name, attribute.value
        if name != "reference" and (value in model.links_by_name or value in model.joints_by_name):
            message = f'unknown attribute {name}="{value}" in <gazebo> (ignored): the block has no'
            help = f'write reference="{value}"'
            yield Finding(attribute, f"{message} reference", help, severity=Severity.ERROR)
            return
    of_world = [child for child in block.children if _is_of_world(child)]
    for child in of_world:
        message = "<physics> in a <gazebo> without a reference (ignored): it is that of a world"
        yield Finding(child, message, "write it into the <world> of the SDF file")
    misplaced = [
        child
        for child in block.children
        if child.tag in owners
        and child not in of_world
        and not _is_default(child, handled.get(child.tag))
    ]
    if not misplaced:
        return
    child, owner = misplaced[0], owners[misplaced[0].tag]
    names = [f"<{tag}>" for tag in dict.fromkeys(element.tag for element in misplaced)]
    what = ", ".join(names[:_MAX_NAMED]) + (" and others" if len(names) > _MAX_NAMED else "")
    yield Finding(
        block if len(misplaced) > 1 else child,
        f"{what} in a <gazebo> without a reference (ignored): it is for a {owner}",
        f'write <gazebo reference="...">, with the name of the {owner}',
        group_key=child.tag,
        severity=None if {element.tag for element in misplaced} <= _HARMLESS else Severity.ERROR,
    )


def _is_of_world(child: Element) -> bool:
    """True for the engine and the step of a simulation, which a robot cannot set."""
    steps = ("max_step_size", "real_time_update_rate", "real_time_factor")
    return child.tag == "physics" and any(child.child(tag) for tag in steps)


def _other(context: Context, name: str, kind: str) -> Link | Joint | None:
    """The only joint above a link, or the link below a joint."""
    model = context.model
    if kind == "link":
        above = context.tree.parents.get(name, [])
        return above[0] if len(above) == 1 else None
    below = model.joints_by_name[name].child
    return model.links_by_name.get(below.value) if below else None


def _moved(block: Element, child: Element, other: Link | Joint) -> Fix | None:
    """Changes the reference of a block without other tags, or adds a separate block."""
    name, reference = other.at.attributes.get("name"), block.attributes["reference"]
    is_same_macro = other.at.frame is block.frame is child.frame  # where expressions mean the same
    if name is None or name.written_in or reference.written_in or not is_same_macro:
        return None
    if isinstance(other, Joint) and child.tag in KEEPING_TAGS and other.kind != "fixed":
        return None
    title = f'move it into <gazebo reference="{other.name}">'
    if len(block.children) == 1:
        return Fix(title, (Edit(reference.span, name.span.text),))
    lines = (
        f'<gazebo reference="{name.span.text}">',
        *(STEP + line for line in lines_of(child)),
        "</gazebo>",
    )
    return Fix(title, (*remove_element(child), *insert_after(block, lines)))
