"""The SDF model that sdformat creates from a URDF.

Links of fixed joints are merged, except preserved ones: a link has the mass and the shapes of all
links merged into it, which remain as frames. Source: parser_urdf.cc of sdformat 14 to 16, which
writes the same SDF; names and merged links come from `urdfkit.ros.gazebo.conversion`.
"""

from collections.abc import Iterator, Mapping
from xml.etree.ElementTree import Element as Tag
from xml.etree.ElementTree import SubElement

from urdfkit.core.spatial import ORIGIN, X_AXIS, Transform, to_rpy
from urdfkit.output.conversion.sdf_extensions import GazeboBlocks, child_of, set_value, within
from urdfkit.output.conversion.sdf_inertia import Inertias
from urdfkit.output.conversion.sdf_values import number_text, numbers_text, pose_text, snapped_rpy
from urdfkit.robot.assets.colours import Colours
from urdfkit.robot.joint import Joint, Limit
from urdfkit.robot.link import Body, Material, Shape
from urdfkit.robot.tree import KinematicTree
from urdfkit.robot.values import number, vector
from urdfkit.ros.gazebo.conversion import (
    WORLD,
    SdfConversion,
    SimulatedJoint,
    SimulatedLink,
    children_by_name,
)
from urdfkit.ros.gazebo.values import is_true

#: SDF version that sdformat 14 to 16 write for a URDF.
VERSION = "1.11"


class SdfModel:
    """Builds the SDF model of a robot.

    Args:
        conversion: of the robot, by the newest sdformat.
        uris: of the mesh files, by the ``id`` of the reference.

    Raises:
        UrdfkitError: sdformat would compute NaN or infinity.
    """

    def __init__(self, conversion: SdfConversion, uris: Mapping[int, str]) -> None:
        self._conversion = conversion
        self._uris = uris
        self._colours = Colours(conversion.model)
        self._frames = {
            link.name: frame for body in conversion.links for link, frame in body.body.links
        }
        self.extensions = GazeboBlocks(conversion.model.gazebo)
        self.coloured: set[int] = set()  # visuals with the colour of the URDF, by ``id``
        self._inertias = Inertias(conversion.model.links)
        self.tag = self._made()

    def _made(self) -> Tag:
        model, conversion = self._conversion.model, self._conversion
        tag = Tag("model", {"name": model.name})
        frames = []
        for joint in conversion.merged_joints():
            link, into = joint.child_name, joint.parent_name
            frames += [_frame(joint.name, into, joint.origin), _frame(link, joint.name)]
            self.extensions.merge(link, into, joint.origin)
            self._inertias.merge(link, into, joint.origin)
        links = {link.name: link for link in conversion.links}
        joints = {joint.child: joint for joint in conversion.joints}
        for name in in_order(conversion.tree):
            if name in links:
                if name in joints:
                    tag.append(self._joint(joints[name]))
                tag.append(self._link(links[name]))
        self.extensions.put_into_model(tag)
        tag.extend(frames)
        origin = model.root.child("origin")
        if origin is not None:
            xyz, rpy = (vector(origin.get(name)) or ORIGIN for name in ("xyz", "rpy"))
            set_value(tag, "pose", pose_text(xyz, rpy))
        return tag

    def _link(self, link: SimulatedLink) -> Tag:
        tag = Tag("link", {"name": link.name})
        if link.body.joint is not None:
            SubElement(tag, "pose", {"relative_to": link.body.joint.name})
        tag.append(self._inertias.tag(link.name))
        bodies = {
            id(body.at): (body, self._frames[part.name])
            for part, _ in link.body.links
            for body in (*part.collisions, *part.visuals)
        }
        for name, at in link.collisions:
            part = self._part("collision", name, *bodies[id(at)])
            self.extensions.put_into_collision(part, link.name)
            tag.append(part)
        for name, at in link.visuals:
            body, frame = bodies[id(at)]
            part = self._part("visual", name, body, frame)
            self.extensions.put_into_visual(part, link.name)
            material = self._colours.of(body)
            if material is not None and _colour(part, material):
                self.coloured.add(id(body.at))
            tag.append(part)
        self.extensions.put_into_link(tag, link.name)
        return tag

    def _part(self, kind: str, name: str, body: Body, frame: Transform) -> Tag:
        """A visual or collision in the frame of the link that it is merged into."""
        tag = Tag(kind, {"name": name})
        at = frame @ body.origin
        set_value(tag, "pose", pose_text(at.position, snapped_rpy(at.rotation)))
        assert body.shape is not None
        SubElement(tag, "geometry").append(self._shape(body.shape))
        return tag

    def _shape(self, shape: Shape) -> Tag:
        tag = Tag(shape.kind)
        if shape.kind == "box" and shape.size is not None:
            set_value(tag, "size", numbers_text(shape.size))
        elif shape.filename is not None:
            set_value(tag, "scale", numbers_text(shape.scale))
            set_value(tag, "uri", self._uris[id(shape.filename)])
        for name, length in (("length", shape.length), ("radius", shape.radius)):
            if length is not None and shape.kind in ("cylinder", "sphere"):
                set_value(tag, name, number_text(length))
        return tag

    def _joint(self, simulated: SimulatedJoint) -> Tag:
        joint, parent = simulated.joint, simulated.parent
        tag = Tag("joint", {"type": simulated.type, "name": joint.name})
        at = self._frames.get(joint.parent_name, Transform()) @ joint.origin
        pose = set_value(tag, "pose", pose_text(at.position, to_rpy(at.rotation)))
        pose.set("relative_to", "__model__" if parent == WORLD else parent)
        set_value(tag, "parent", parent)
        set_value(tag, "child", simulated.child)
        if simulated.type != "fixed":
            tag.append(_axis(joint))
        elif is_hinge(joint, self._conversion):
            tag.set("type", "revolute")
            axis = SubElement(tag, "axis")
            for path in ("limit/lower", "limit/upper", "dynamics/damping", "dynamics/friction"):
                part, _, name = path.partition("/")
                set_value(within(axis, part), name, "0")
        self.extensions.put_into_joint(tag, joint.name)
        return tag


def is_hinge(joint: Joint, conversion: SdfConversion) -> bool:
    """True for a fixed joint that a legacy tag turns into a revolute joint without a range."""
    tags = {
        child.tag
        for block in conversion.model.gazebo
        if block.get("reference") == joint.name
        for child in block.children
        if is_true(child)
    }
    return "disableFixedJointLumping" in tags and "preserveFixedJoint" not in tags


def in_order(tree: KinematicTree) -> Iterator[str]:
    """The links in sdformat's order: depth first, by the names of their joints."""
    stack = [tree.roots[0].name]
    while stack:
        name = stack.pop()
        yield name
        joints = children_by_name(tree, name)
        stack += [joint.child_name for joint in reversed(joints)]


def _frame(name: str, attached_to: str, at: Transform | None = None) -> Tag:
    tag = Tag("frame", {"name": name, "attached_to": attached_to})
    at = at or Transform()
    set_value(tag, "pose", pose_text(at.position, to_rpy(at.rotation)))
    return tag


def _axis(joint: Joint) -> Tag:
    tag = Tag("axis")
    set_value(tag, "xyz", numbers_text(joint.axis.value if joint.axis else X_AXIS))
    if joint.mimic and joint.leader:
        mimic = SubElement(tag, "mimic", {"joint": joint.leader})
        set_value(mimic, "multiplier", number_text(joint.mimic.multiplier))
        set_value(mimic, "offset", number_text(joint.mimic.offset))
    limit = SubElement(tag, "limit")
    if joint.limit is not None:
        _limit(limit, joint.limit, has_range=joint.kind != "continuous")
    dynamics, written = SubElement(tag, "dynamics"), joint.at.child("dynamics")
    if written is not None:
        for name in ("damping", "friction"):
            set_value(dynamics, name, number_text(number(written.get(name)) or 0.0))
    return tag


def _limit(tag: Tag, limit: Limit, *, has_range: bool) -> None:
    if has_range:
        for name, bound in zip(("lower", "upper"), sorted(limit.ends), strict=True):
            set_value(tag, name, number_text(bound))
    for name, largest in (("effort", limit.effort), ("velocity", limit.velocity)):
        set_value(tag, name, number_text(largest.value if largest else 0.0))


def _colour(visual: Tag, material: Material) -> bool:
    """Set the colour of a visual; False if ``<gazebo>`` defines its material."""
    tag = child_of(visual, "material")
    tag = SubElement(visual, "material") if tag is None else tag
    if child_of(tag, "diffuse") is not None or child_of(tag, "ambient") is not None:
        return False
    *rgb, alpha = material.rgba.value if material.rgba else (0.0, 0.0, 0.0, 1.0)
    bright = [min(max(value / 0.8, 0.0), 1.0) for value in rgb]
    for name in ("diffuse", "ambient"):
        set_value(tag, name, numbers_text((*bright, alpha)))
    return True
