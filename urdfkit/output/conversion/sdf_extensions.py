"""Contents of ``<gazebo>`` tags in an SDF, distributed as sdformat does.

The tags of a merged link move to the link that it is merged into, with new poses of sensors and
lights. Source: ``ParseSDFExtension``, ``InsertSDFExtension*`` and
``ReduceSDFExtension*`` in parser_urdf.cc of sdformat 14 to 16.
"""

from collections.abc import Iterator
from copy import deepcopy
from math import inf, isinf
from xml.etree.ElementTree import Element as Tag
from xml.etree.ElementTree import SubElement

from urdfkit.core.grouping import by_key
from urdfkit.core.spatial import Transform, from_rpy
from urdfkit.errors import UrdfkitError
from urdfkit.output.conversion.sdf_values import number_text, pose_text, snapped_rpy
from urdfkit.output.exchange import element_tree
from urdfkit.robot.rigid_bodies import KEEPING_TAGS
from urdfkit.robot.values import numbers, vector
from urdfkit.ros.gazebo.conversion import LUMP
from urdfkit.ros.gazebo.values import is_true, leading, text_of, value
from urdfkit.text.document import Element

_SWITCHES = frozenset(
    "cfmDamping implicitSpringDamper provideFeedback selfCollide static turnGravityOff".split()
)
_TEXTS = frozenset(("fdir1", "material"))
#: Settings of a link that SDF has in its collisions, below ``surface``.
_FRICTION = {"mu1": "mu", "mu2": "mu2", "fdir1": "fdir1"}
_CONTACT = {"kp": "kp", "kd": "kd", "maxVel": "max_vel", "minDepth": "min_depth"}
_COLLISION = {"laserRetro": "laser_retro", "maxContacts": "max_contacts"}
#: Settings of a joint.
_AXIS = {"springReference": "spring_reference", "springStiffness": "spring_stiffness"}
_LIMIT = {"stopCfm": "cfm", "stopErp": "erp"}

#: The tag of SDF that receives each setting.
RECEIVERS = {
    "static": "model",
    **dict.fromkeys(("selfCollide", "turnGravityOff", "dampingFactor"), "link"),
    "material": "visual",
    **dict.fromkeys((*_FRICTION, *_CONTACT, *_COLLISION), "collision"),
    **dict.fromkeys((*_AXIS, *_LIMIT, "provideFeedback", "fudgeFactor"), "joint"),
    **dict.fromkeys(("cfmDamping", "implicitSpringDamper"), "joint"),
}

_SCRIPTS = "file://media/materials/scripts/gazebo.material"
#: Largest integer that the converter reads.
_LARGEST_INT = 2**31 - 1
#: Tags with a pose in the frame of their link.
POSED = ("light", "projector", "sensor")


class GazeboBlock:
    """Contents of a ``<gazebo>`` tag."""

    def __init__(self, block: Element) -> None:
        self.block = block
        self.receivers: set[str] = set()  # SDF tags that received a part of it
        self.original_link = (block.get("reference") or "") if block.children else ""
        self.moved = Transform()  # frame of its previous link in its present link
        self.settings: dict[str, str] = {}  # in the format of SDF
        self.visual: list[Tag] = []  # for each visual
        self.collision: list[Tag] = []  # for each collision
        self.others: list[tuple[Tag, Element]] = []  # SDF, and its source
        for child in block.children:
            if child.tag in ("visual", "collision"):
                parts = self.visual if child.tag == "visual" else self.collision
                parts += map(element_tree, child.children)
            elif child.tag in RECEIVERS:
                self.settings[child.tag] = _setting(child)
            elif child.tag not in (*KEEPING_TAGS, "canonicalBody"):
                self.others.append((element_tree(child), child))

    def concerns(self, tag: Tag, link: str) -> bool:
        """True if it applies to a visual or collision of its present link."""
        name = tag.get("name") or ""
        if link == self.original_link:
            return LUMP not in name
        return f"{LUMP}{self.original_link}_{tag.tag}" in name


class GazeboBlocks:
    """All ``<gazebo>`` tags of a robot, by reference; empty for the model."""

    def __init__(self, blocks: tuple[Element, ...]) -> None:
        self.all = [GazeboBlock(block) for block in blocks]
        self._by_name = by_key((block.block.get("reference") or "", block) for block in self.all)

    def merge(self, link: str, into: str, frame: Transform) -> None:
        """Move the blocks of a link to the link that it is merged into.

        Args:
            frame: of the link, in the frame of ``into``.
        """
        moved = self._by_name.pop(link, [])
        for block in moved:
            block.moved = frame
            for tag, at in block.others:
                if tag.tag in POSED:
                    _move(tag, at, frame)
        if moved:
            self._by_name.setdefault(into, []).extend(moved)
        for blocks in self._by_name.values():
            for block in blocks:
                for tag, _ in block.others:
                    _rename(tag, link, into, block.moved, frame)

    def put_into_model(self, model: Tag) -> None:
        for block in self._of(""):
            block.receivers.add("model")
            if "static" in block.settings:
                set_value(model, "static", block.settings["static"])
            model.extend(tag for tag, _ in block.others)

    def put_into_link(self, tag: Tag, link: str) -> None:
        for block in self._of(link):
            block.receivers.add("link")
            if "turnGravityOff" in block.settings:
                set_value(tag, "gravity", block.settings["turnGravityOff"])
            if "dampingFactor" in block.settings:
                decay = SubElement(tag, "velocity_decay")
                for part in ("linear", "angular"):
                    set_value(decay, part, block.settings["dampingFactor"])
            if "selfCollide" in block.settings:
                set_value(tag, "self_collide", str(int(block.settings["selfCollide"] == "true")))
            tag.extend(deepcopy(child) for child, _ in block.others)

    def put_into_joint(self, tag: Tag, joint: str) -> None:
        for block in self._of(joint):
            block.receivers.add("joint")
            dynamics = within(tag, "axis", "dynamics")
            physics = within(tag, "physics")
            ode = within(physics, "ode")
            _put(block, dynamics, _AXIS)
            _put(block, within(ode, "limit"), _LIMIT)
            if "provideFeedback" in block.settings:
                for place in (physics, ode):
                    set_value(place, "provide_feedback", block.settings["provideFeedback"])
            for name in ("cfmDamping", "implicitSpringDamper"):
                if name in block.settings:
                    set_value(ode, "implicit_spring_damper", block.settings[name])
                    set_value(ode, "cfm_damping", block.settings[name])
            _put(block, ode, {"fudgeFactor": "fudge_factor"})
            tag.extend(deepcopy(child) for child, _ in block.others)

    def put_into_collision(self, tag: Tag, link: str) -> None:
        for block in self._of(link):
            if not block.concerns(tag, link):
                continue
            block.receivers.add("collision")
            _put_parts(tag, block.collision, "surface")
            _put(block, within(tag, "surface", "contact", "ode"), _CONTACT)
            _put(block, within(tag, "surface", "friction", "ode"), _FRICTION)
            _put(block, tag, _COLLISION)

    def put_into_visual(self, tag: Tag, link: str) -> None:
        for block in self._of(link):
            if not block.concerns(tag, link):
                continue
            block.receivers.add("visual")
            _put_parts(tag, block.visual, "material")
            if block.settings.get("material"):
                script = within(tag, "material", "script")
                set_value(script, "name", block.settings["material"])
                set_value(script, "uri", _SCRIPTS)

    def _of(self, name: str) -> Iterator[GazeboBlock]:
        yield from self._by_name.get(name, ())


def set_value(tag: Tag, name: str, text: str) -> Tag:
    """Set the text of a child, which replaces an existing child of that name."""
    old = child_of(tag, name)
    if old is not None:
        tag.remove(old)
    new = SubElement(tag, name)
    new.text = text
    return new


def child_of(tag: Tag, name: str) -> Tag | None:
    """The first child with a name; a colon in the name is not a namespace prefix."""
    return next((child for child in tag if child.tag == name), None)


def _setting(child: Element) -> str:
    """The value of a setting in the format of SDF.

    Raises:
        UrdfkitError: it does not begin with a required number, or the number is too large.
    """
    text = text_of(child)
    if child.tag in _TEXTS:
        return text
    if child.tag == "turnGravityOff":
        return "true" if text.lower() in ("false", "no", "0") else "false"
    if child.tag in _SWITCHES:
        return "true" if is_true(child) else "false"
    is_whole = child.tag == "maxContacts"
    digits, _ = leading(text, whole=is_whole)
    number = value(digits) if digits else inf
    is_large = (
        abs(number) > _LARGEST_INT if is_whole else isinf(number) and "inf" not in digits.lower()
    )
    if not digits or is_large:
        raise UrdfkitError(
            f"{child.span}: <{child.tag}> is not a number that Gazebo reads: its converter fails; "
            "write a number"
        )
    return number_text(number)


def within(tag: Tag, *names: str) -> Tag:
    """A descendant of a tag, created if it is missing."""
    for name in names:
        child = child_of(tag, name)
        tag = SubElement(tag, name) if child is None else child
    return tag


def _put(block: GazeboBlock, tag: Tag, names: dict[str, str]) -> None:
    for name, sdf_name in names.items():
        if block.settings.get(name):
            set_value(tag, sdf_name, block.settings[name])


def _put_parts(tag: Tag, parts: list[Tag], single: str) -> None:
    """Add parts to a visual or collision; a part with the tag ``single`` replaces earlier ones."""
    for part in parts:
        old = child_of(tag, single) if part.tag == single else None
        if old is not None:
            tag.remove(old)
        tag.append(deepcopy(part))


def is_read_as_rpy(pose: Element, *, is_moved: bool) -> bool:
    """True if sdformat moves a pose with its link, but misreads its format."""
    is_other = pose.get("rotation_format") == "quat_xyzw" or pose.get("degrees") in ("true", "1")
    return is_moved and is_other and not pose.get("relative_to")


def _move(tag: Tag, at: Element, frame: Transform) -> None:
    """Set the pose of a sensor, light or projector in the link that its link is merged into."""
    pose = child_of(tag, "pose")
    values: tuple[float, ...] = (0.0,) * 6
    if pose is not None:
        if pose.get("relative_to") is not None:
            return
        parsed = numbers(pose.text or "") if pose.text else values
        if parsed is None or len(parsed) < 6:
            raise UrdfkitError(
                f"{at.span}: the <pose> of <{tag.tag}> does not have six numbers: "
                "Gazebo cannot move it with its link; write x y z roll pitch yaw"
            )
        values = parsed
        tag.remove(pose)
    x, y, z, roll, pitch, yaw = values[:6]
    moved_pose = frame @ Transform(from_rpy(roll, pitch, yaw), (x, y, z))
    set_value(tag, "pose", pose_text(moved_pose.position, snapped_rpy(moved_pose.rotation)))


def _rename(tag: Tag, link: str, into: str, moved: Transform, frame: Transform) -> None:
    """Replace the name of a merged link in a plugin or joint."""
    if tag.tag == "joint":
        for name in ("parent", "child"):
            end = child_of(tag, name)
            if end is not None and _text(end) == link:
                set_value(tag, name, into)
    elif tag.tag == "plugin":
        for name in ("bodyName", "frameName"):
            body = child_of(tag, name)
            if body is not None and _text(body) == link:
                set_value(tag, name, into)
                _shift(tag, moved, frame)


def _shift(plugin: Tag, moved: Transform, frame: Transform) -> None:
    """Set the offset of a plugin's link in the link that it is merged into."""
    xyz, rpy = child_of(plugin, "xyzOffset"), child_of(plugin, "rpyOffset")
    position, rotation = moved.position, moved.rotation
    if xyz is not None:
        position = vector(_text(xyz)) or (0.0, 0.0, 0.0)
    if rpy is not None:
        rotation = from_rpy(*(vector(_text(rpy)) or (0.0, 0.0, 0.0)))
    moved_pose = frame @ Transform(rotation, position)
    set_value(plugin, "xyzOffset", " ".join(map(number_text, moved_pose.position)))
    set_value(plugin, "rpyOffset", " ".join(map(number_text, snapped_rpy(moved_pose.rotation))))
    set_value(plugin, "gz::corrected_offsets", "1")


def _text(tag: Tag) -> str:
    return (tag.get("value") or tag.text or "").strip()
