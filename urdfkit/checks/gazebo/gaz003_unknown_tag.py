"""A `<gazebo>` block or a sensor contains a tag that is unknown to Gazebo, which ignores it.

Gazebo's converter handles some tags by name (`mu1`, `kp`, `material`...) and copies all others into
the SDF, where the simulator warns about unknown tags and continues. `<mu>` for `<mu1>` and
the snake_case names of SDF (`max_vel`, `laser_retro`) are usual mistakes. The intended setting
keeps its default: a camera with a misspelt `<width>` has images 320 pixels wide.

Sources:
    SDFormat extensions to URDF: http://sdformat.org/tutorials?tut=sdformat_urdf_extensions
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
    SDF, sensor: http://sdformat.org/spec?ver=1.9&elem=sensor
"""

from collections.abc import Iterable

from urdfkit.core.grouping import by_key
from urdfkit.core.suggest import TYPO, Suggester, did_you_mean, hint_for, nearest
from urdfkit.lint.rules import Context, Finding, Findings, Related, Severity, rule
from urdfkit.robot.joint_limits import can_move
from urdfkit.robot.model import RobotModel
from urdfkit.robot.samples import robot_xml
from urdfkit.ros.catalog.extensions import copied, extensions, suggested
from urdfkit.ros.catalog.sensors import children, settings
from urdfkit.ros.gazebo.samples import gazebo_xml, solid_xml
from urdfkit.ros.gazebo.sensors import SettingElement, sensors, written
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import fix_tag

BAD = robot_xml(solid_xml("wheel"), gazebo_xml("<mu>0.8</mu>", reference="wheel"))
FIXED = GOOD = BAD.replace("mu>", "mu1>")

#: Elements that their parsers read only directly in ``<robot>``.
_OF_ROBOT = ("ros2_control", "transmission", "gazebo")
#: Tags of SDF that belong in a ``<collision>``.
_OF_COLLISION = ("surface",)
#: Tags of the friction of a ``<surface>``, for which there are no extensions.
_OF_FRICTION = ("slip1", "slip2")
#: Tags of a ``<sensor>`` that are also tags of a ``<surface>``.
_AMBIGUOUS = ("contact",)

#: Parts of an IMU of which each axis has its own noise.
_WITH_AXES = ("angular_velocity", "linear_acceleration")
_OF_EACH_AXIS = "write it into <x>, <y> and <z>"

#: Replacements for tags of a sensor that belong elsewhere.
_INSTEAD = {
    "frame": "name the frame by <gz_frame_id> in the <sensor>",
    "frame_id": "name the frame by <gz_frame_id> in the <sensor>",
    "origin": "place it by <pose>x y z roll pitch yaw</pose>",
    "vertical_fov": "remove it: width and height of <image> give it",
    "noise": "move it into <ray> or <camera>, or into <imu><angular_velocity><x>",
}
#: Names of the ends of a camera's <clip>, for those of a lidar's <range>.
_OF_CLIP = {"min": "near", "max": "far"}


@rule(Severity.WARNING, help="remove it, or write a tag of Gazebo's URDF extensions")
def check(context: Context) -> Findings:
    known = {*extensions(), *(tag for kind in ("link", "joint", "model") for tag in copied(kind))}
    unknown = by_key(
        (child.tag, child)
        for block in context.model.gazebo
        for child in block.children
        if child.tag not in known and ":" not in child.tag  # prefixes are for other programs
    )
    suggester = Suggester(known)
    for tag, elements in unknown.items():
        is_of_sensor = tag in children() and tag not in _AMBIGUOUS
        right = suggested().get(tag) or (None if is_of_sensor else suggester.suggested(tag))
        if right == "static" and any(map(can_move, context.model.joints)):
            help = "remove it: with <static> no joint moves"
            yield _unknown(tag, elements)._replace(help=help)
        elif right:
            yield from (_misspelt(element, right) for element in elements)
        else:
            yield _unknown(tag, elements)
    yield from _in_sensors(context.model)


def _unknown(tag: str, elements: list[Element]) -> Finding:
    """One finding for all tags of a name: one mistake, copied many times."""
    count = f" ({len(elements)} times)" if len(elements) > 1 else ""
    others = tuple(Related(one.span, f"<{tag}>") for one in elements[1:5])
    help = f"move <{tag}> out of the <gazebo>, into <robot>" if tag in _OF_ROBOT else ""
    if tag in _OF_COLLISION:
        help = f"move <{tag}> into a <collision>, inside the <gazebo>"
    if tag in _OF_FRICTION:
        help = f"write it as <collision><surface><friction><ode><{tag}>, inside the <gazebo>"
    if tag in children() and tag not in _AMBIGUOUS:
        blocks = [one.parent.children for one in elements if one.parent]
        has_sensor = all(any(child.tag == "sensor" for child in block) for block in blocks)
        help = "move it into the <sensor>" if has_sensor else "remove it: it is for a <sensor>"
    message = f"unknown element <{tag}> in <gazebo> (ignored){count}"
    return Finding(elements[0], message, help, related=others)


def _misspelt(element: Element, right: str) -> Finding:
    message = f"unknown element <{element.tag}> in <gazebo> (ignored)"
    return Finding(element, message, f"did you mean <{right}>?", fix_tag(element, right))


def _in_sensors(model: RobotModel) -> Findings:
    known = children()
    for sensor in sensors(model):
        for child in sensor.at.children:
            if child.tag not in known and ":" not in child.tag:
                blocks = (block.tag for block in sensor.at.children)
                block = next((block for block in blocks if child.tag in settings(block)), "")
                deeper = f"move it into <{block}>" if block else ""
                yield _in_sensor(child, sensor.who, "sensor", known, deeper)
        for inner in written(sensor):
            if inner.setting is None and ":" not in inner.at.tag:
                yield _in_sensor(inner.at, sensor.who, inner.parent, inner.siblings, _nested(inner))


def _nested(inner: SettingElement) -> str:
    """Replacement for a tag that belongs one level deeper: ``image_width``, and ``near``."""
    tag = inner.path  # without a slash: directly in the block
    below = [path for path in inner.known if path.count("/") == 1]
    deeper = [path for path in below if tag in (path.replace("/", "_"), path.split("/")[1])]
    if len(deeper) != 1:
        return ""
    return f"write it as <{inner.parent}><{deeper[0].replace('/', '><')}>"


def _in_sensor(
    child: Element, who: str, parent: str, known: Iterable[str], nested: str = ""
) -> Finding:
    message = f"{who}: unknown element <{child.tag}> in <{parent}> (ignored)"
    instead = _OF_EACH_AXIS if parent in _WITH_AXES and child.tag == "noise" else ""
    if instead := instead or _INSTEAD.get(child.tag) or nested:
        return Finding(child, message, instead, group_key=child.tag)
    of_clip = _OF_CLIP.get(child.tag) if parent == "clip" else None
    intended = of_clip or nearest(child.tag, known, TYPO)
    others = child.parent.children if child.parent else ()
    # <center_x> and <center_y> do not both become <center>.
    is_taken = any(
        one is not child and intended in (one.tag, nearest(one.tag, known, TYPO)) for one in others
    )
    fix = None if is_taken else fix_tag(child, intended)
    if child.children and not intended:  # <orientation> is not <enable_orientation>
        return Finding(child, message, "remove it", group_key=child.tag)
    # A text is no block: <lidarName> is not <lidar>.
    likely = [tag for tag in known if not (settings(tag) and child.text.strip())]
    hint = hint_for(of_clip) or did_you_mean(child.tag, likely)
    help = "fix the name of the element" if hint else "remove it"
    # The tags of a plugin, written in its sensor, are one mistake.
    return Finding(child, message + hint, help, fix, group_key=child.tag if hint else who)
