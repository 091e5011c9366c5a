"""A `<gazebo>` tag or sensor has another effect, or none, because Gazebo lumps fixed joints.

Gazebo merges the child of a fixed joint into its parent ("fixed joint lumping"):

- A force-torque sensor or `<provideFeedback>` of such a joint is not created, and its topic never
  appears: an error, or a warning if nothing in the robot reads the forces.
- `<turnGravityOff>`, `<gravity>`, `<selfCollide>` and `<self_collide>` of the child also apply to
  the parent. A camera without gravity makes a robot without gravity. A parent without mass or
  collision, such as `base_footprint`, is not affected.
- `<preserveFixedJoint>` prevents merging, but Gazebo still drops a link without mass, together with
  the joint and the links below it.
- `<disableFixedJointLumping>` is older than `<preserveFixedJoint>`: Gazebo creates a revolute joint
  with limits of 0 and 0, which yields under load and costs time in every step: an info.
- A joint that `<gazebo>` adds as SDF cannot refer to a merged link: sdformat before 12.7, as in
  Debian 12, rejects the model; later versions keep a frame, to which the joint is attached.
- Friction, contact parameters and material apply to a collision or visual by its name. A collision
  or visual whose name does not begin with that of its link does not get them: the wheel has a
  friction of 1, regardless of `<mu1>`. A merged link loses them also if its name begins with that
  of its parent.

Keep the joint with `<preserveFixedJoint>true</preserveFixedJoint>` in its `<gazebo reference>`.

Sources:
    SDFormat extensions to URDF: http://sdformat.org/tutorials?tut=sdformat_urdf_extensions
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
    gazebosim/sdformat#131: https://github.com/gazebosim/sdformat/issues/131
    gazebosim/sdformat#333: https://github.com/gazebosim/sdformat/issues/333
    gazebosim/gazebo-classic#2497: https://github.com/gazebosim/gazebo-classic/issues/2497
    gazebosim/gz-sensors#25: https://github.com/gazebosim/gz-sensors/issues/25
    Kinovarobotics/ros_kortex#312: https://github.com/Kinovarobotics/ros_kortex/issues/312
    robotology/icub-models#25: https://github.com/robotology/icub-models/issues/25
    measured: libsdformat 12.3 switches gravity off for the merged link, loses mu1 and material
"""

from urdfkit.lint.rules import Context, Finding, Findings, Fix, Need, Related, Severity, rule
from urdfkit.robot.model import RobotModel
from urdfkit.robot.rigid_bodies import KEEPING_TAGS
from urdfkit.robot.samples import collision_xml, robot_xml
from urdfkit.ros.catalog.extensions import extensions
from urdfkit.ros.gazebo.measured_joints import measured_joints
from urdfkit.ros.gazebo.samples import gazebo_xml, solid_xml
from urdfkit.ros.gazebo.values import is_true, text_of
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import fix_value, insert_before, rename_element

BAD = robot_xml(
    solid_xml("wheel", collision_xml('<sphere radius="0.1"/>')),
    gazebo_xml("<mu1>0.2</mu1>", reference="wheel"),
).replace("<collision", '<collision name="tyre"')
GOOD = BAD.replace(' name="tyre"', "")
FIXED = BAD.replace('"tyre"', '"wheel_tyre"')

#: Flags of a whole body, with the values that change nothing.
_DEFAULTS = {
    "turnGravityOff": ("false", "no", "0"),
    "gravity": ("true", "1"),
    "selfCollide": ("false", "no", "0"),
    "self_collide": ("false", "0"),
}

_MERGED = "_fixed_joint_lump__"
_KEEP = "<preserveFixedJoint>true</preserveFixedJoint>"


@rule(Severity.WARNING, needs=(Need.MODEL, Need.GAZEBO))
def check(context: Context) -> Findings:
    yield from _merged_force_sensors(context)
    yield from _flags(context)
    yield from _kept_joints(context)
    yield from _added_joints(context)
    yield from _lost_on_shapes(context)


def _flags(context: Context) -> Findings:
    flags = [
        (block.get("reference") or "", tag)
        for block in context.model.gazebo
        for tag in block.children
        if tag.tag in _DEFAULTS and text_of(tag).lower() not in _DEFAULTS[tag.tag]
    ]
    names = {(name, tag.tag) for name, tag in flags}
    for name, tag in flags:
        into = context.gazebo.merged.get(name)
        flagged = {name for name, other in names if other == tag.tag}
        if into and into not in flagged and _reaches(context, into, tag.tag, flagged):
            yield Finding(
                tag,
                f"<{tag.tag}> of '{name}' also applies to '{into}', the link it is merged into",
                "keep the joint with <preserveFixedJoint>, or move the tag to the parent",
                group_key=f"{tag.tag} of {into}",
            )


def _reaches(context: Context, top: str, tag: str, flagged: set[str]) -> bool:
    """True if a flag affects a link of the merged body that does not set it."""
    (simulated,) = (link for link in context.gazebo.links if link.name == top)
    others = [link for link, _ in simulated.body.links if link.name not in flagged]
    if tag in ("selfCollide", "self_collide"):
        return any(link.collisions for link in others)
    return any(link.mass for link in others)


def _kept_joints(context: Context) -> Findings:
    joints = context.model.joints_by_name
    massless = {body.top.name for body in context.gazebo.massless}
    tags = [
        (joint, tag)
        for block in context.model.gazebo
        if (joint := joints.get(block.get("reference") or "")) and joint.kind == "fixed"
        for tag in block.children
        if tag.tag in KEEPING_TAGS and is_true(tag)
    ]
    preserved = {joint.name for joint, tag in tags if tag.tag == "preserveFixedJoint"}
    for joint, tag in tags:
        if joint.child_name in massless:
            link = joint.child_name
            message = f"<{tag.tag}> of joint '{joint.name}' has no effect: Gazebo drops link "
            message += f"'{link}', which has no mass"
            help = "give the link an <inertial>, or remove the tag"
            yield Finding(tag, message, help)
        elif tag.tag == "disableFixedJointLumping" and joint.name not in preserved:
            edits = rename_element(tag, "preserveFixedJoint")
            yield Finding(
                tag,
                f"<{tag.tag}> makes joint '{joint.name}' a revolute joint in Gazebo",
                "write <preserveFixedJoint>",
                Fix.of("write <preserveFixedJoint>", edits),
                severity=Severity.INFO,
            )


def _added_joints(context: Context) -> Findings:
    for joint, end, into in context.gazebo.lost_joint_ends():
        name = end.text.strip()
        if into:
            yield Finding(
                end,
                f"joint '{joint.get('name')}' in <gazebo>: {end.tag} '{name}' is merged into "
                f"'{into}': sdformat before 12.7 rejects the model",
                f"name '{into}', or keep the joint of '{name}' with <preserveFixedJoint>",
            )


def _lost_on_shapes(context: Context) -> Findings:
    for simulated in context.gazebo.links:
        collisions = (("collision", *named) for named in simulated.collisions)
        visuals = (("visual", *named) for named in simulated.visuals)
        for kind, name, shape in (*collisions, *visuals):
            link = (shape.parent and shape.parent.get("name")) or ""
            is_lost = not _gets_tags(name, link, kind, is_merged=link != simulated.name)
            if is_lost and (tags := _tags(context.model, link, kind)):
                yield _lost(shape, link, simulated.name, tags)


def _tags(model: RobotModel, link: str, kind: str) -> list[Element]:
    """The tags of a link that its collisions, or its visuals, should have."""
    known = {
        kind,
        *(tag for tag, extension in extensions().items() if extension.sdf.startswith(f"{kind}/")),
    }
    blocks = (block for block in model.gazebo if block.get("reference") == link)
    return [child for block in blocks for child in block.children if child.tag in known]


def _gets_tags(name: str, link: str, kind: str, *, is_merged: bool) -> bool:
    """True if the converter assigns a shape of this name to its link."""
    return f"{_MERGED}{link}_{kind}" in name if is_merged else _MERGED not in name


def _lost(shape: Element, link: str, top: str, tags: list[Element]) -> Finding:
    listed = ", ".join(dict.fromkeys(f"<{tag.tag}>" for tag in tags))
    lost = f"Gazebo does not apply {listed} of link '{link}'"
    name = shape.attributes.get("name")
    if name is None:
        message = f"{lost}: the name begins with '{top}', the link it is merged into"
        return Finding(tags[0], message, "rename the link")
    message = f"{lost} to <{shape.tag}> '{name.value}', because of its name"
    help = "remove the name, or begin it with the name of the link"
    fix = fix_value(name, f"{link}_{name.value}") if link == top else None
    return Finding(name, message, help, fix, (Related(tags[0].span, "set here"),), group_key="name")


def _merged_force_sensors(context: Context) -> Findings:
    """The fixed joints whose forces are measured, but which Gazebo merges.

    A joint that a tag keeps may have a parent in a package that is not found.
    """
    kept = {joint.joint.name for joint in context.gazebo.joints} | context.gazebo.preserved
    for name, at, who in measured_joints(context.model):
        joint = context.model.joints_by_name.get(name)
        if joint is not None and joint.kind == "fixed" and name not in kept:
            yield Finding(
                at,
                f"{who} is on fixed joint '{name}', which Gazebo merges: nothing is measured",
                f"add {_KEEP} to the <gazebo reference> of the joint",
                Fix("keep the joint in Gazebo", insert_before(at, (_KEEP,))),
                severity=Severity.ERROR if _is_read(context, name, at) else None,
            )


def _is_read(context: Context, name: str, at: Element) -> bool:
    """True if the sensor has a topic or a plugin, or something else reads the forces."""
    if at.tag == "sensor" and (at.child("topic") or at.child("plugin")):
        return True
    # One that moves the joint, as for a mimic, does not read its forces.
    readers = [use.at for use in context.plugins if not (use.plugin and use.plugin.moves)]
    if any(value.text.strip() == name for plugin in readers for value in plugin.children):
        return True
    sensors_of_control = [
        sensor for block in context.model.ros2_controls for sensor in block.all("sensor")
    ]
    interfaces = [state for sensor in sensors_of_control for state in sensor.all("state_interface")]
    return any((state.get("name") or "").startswith(("force", "torque")) for state in interfaces)
