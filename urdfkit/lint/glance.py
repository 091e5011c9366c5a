"""What a glance at a model tells: the rules that cannot have anything to say about it.

Most robots are sound trees with plain names, and importing a rule costs more than running it.
The answers here are cautious: a rule that is not named as silent may still find nothing.
"""

from __future__ import annotations

from math import hypot, pi
from typing import TYPE_CHECKING

from urdfkit.robot.joints import BOUNDED, MOVING, bounds
from urdfkit.robot.model import DEGREES_OF_FREEDOM

if TYPE_CHECKING:
    from collections.abc import Callable

    from urdfkit.robot.model import Joint, Link, RobotModel
    from urdfkit.robot.tree import KinematicTree
    from urdfkit.text.document import Element

#: Silent if links and joints form one tree.
ABOUT_TREES = frozenset("NAM001 NAM002 REF001 TRE001 TRE002 TRE003 TRE004 TRE006".split())

#: Silent if no joint has the child.
ABOUT_CHILDREN = {
    "mimic": frozenset("REF004 JNT014 JNT015 JNT016 JNT017 JNT026 JNT032 JNT036".split()),
    "safety_controller": frozenset(("JNT019", "JNT029")),
    "calibration": frozenset(("JNT024",)),
    "dynamics": frozenset(("JNT018", "JNT041")),
}

#: Silent if no ``<gazebo>`` holds a plugin.
ABOUT_PLUGINS = frozenset(f"GAZ{number:03}" for number in (*range(10, 40), 64, 70))

#: Silent if no ``<gazebo>`` holds a sensor.
ABOUT_SENSORS = frozenset(
    f"GAZ{number:03}" for number in (15, *range(40, 52), *range(53, 58), 60, 61, 62, 65)
)

_DRIVES = ("drive", "Drive", "steering")
_EYES = ("laser", "lidar", "hokuyo", "velodyne", "ouster", "camera", "kinect", "realsense")
_LIDARS = ("ray", "lidar")
_CAMERAS = ("camera", "depth", "rgbd")

#: Silent if none of these words stands in a ``<gazebo>``: in a tag, a type or a file name.
ABOUT_WORDS = {
    "GAZ007": ("material",),
    "GAZ008": ("material",),
    "GAZ024": _DRIVES,
    "GAZ025": _DRIVES,
    "GAZ026": _DRIVES,
    "GAZ033": ("gz", "ignition"),
    "GAZ035": ("gz", "ignition", "ign_"),
    "GAZ063": ("static",),
    "GAZ044": ("update_rate",),
    "GAZ045": _LIDARS,
    "GAZ046": _LIDARS,
    "GAZ047": (*_LIDARS, "pose"),
    "GAZ048": ("clip",),
    "GAZ049": _CAMERAS,
    "GAZ050": _LIDARS,
    "GAZ051": ("contact",),
    "GAZ052": ("force_torque", "provideFeedback"),
    "GAZ054": ("update_rate",),
    "GAZ055": _CAMERAS,
    "GAZ056": ("horizontal_fov",),
    "GAZ065": ("noise",),
    "GAZ066": ("preserveFixedJoint", "disableFixedJointLumping"),
    "GAZ067": ("turnGravityOff", "gravity", "selfCollide", "self_collide"),
    "GAZ069": ("disableFixedJointLumping",),
}

#: Silent without ``<ros2_control>``, and without ``<transmission>``.
ABOUT_COMPONENTS = frozenset(
    f"RCT{number:03}" for number in (5, 6, 7, 8, 9, 11, 17, 18, 19, 20, 22, 23, 28, 31, 32, 33)
)
ABOUT_TRANSMISSIONS = frozenset(("RCT003", "RCT015", "RCT016", "RCT024", "RCT030"))

#: Silent if neither the launch file nor a plugin names a file of parameters.
ABOUT_PARAMETERS = frozenset(
    f"RCT{number:03}" for number in (12, 13, 14, 21, 25, 26, 27, 29, 34, 35, 36, 40, 41)
)

#: Silent if nothing moves, or nothing weighs.
ABOUT_STATICS = frozenset(("DYN003", "DYN004", "DYN005", "DYN006"))

#: Silent if all sizes are positive.
ABOUT_SIZES = frozenset(("GEO001", "GEO012"))

#: Silent if all scales are positive.
ABOUT_SCALES = frozenset(("GEO005", "GEO006"))


def silent(model: RobotModel, tree: KinematicTree) -> set[str]:
    """The codes of rules that need not be imported for a model."""
    codes: set[str] = set()
    if tree.is_sound:
        codes |= ABOUT_TREES
    codes |= _about_names(model)
    if len(model.materials) < 2:
        codes.add("NAM006")
    if not any(body.material for link in model.links for body in link.visuals):
        codes |= {"NAM009", "REF003"}
    codes |= (
        _about_joints(model) | _about_mimics(model) | _about_shapes(model) | _about_colours(model)
    )
    codes |= _about_gazebo(model)
    if not model.ros2_controls:
        codes |= ABOUT_COMPONENTS
    codes |= _about_transmissions(model)
    if not any(root.inertial for root in tree.roots):
        codes.add("TRE007")
    if not any(name.endswith("base_footprint") for name in model.links_by_name):
        codes.add("TRE008")
    codes |= _about_statics(model, tree)
    if not _may_see(model):
        codes.add("GEO018")
    if len(model.joints) < 1000:
        codes.add("TRE009")
    return codes


def may_collide(model: RobotModel) -> bool:
    """True if two links have collision geometry."""
    return sum(bool(link.collisions) for link in model.links) > 1


def is_controlled(model: RobotModel) -> bool:
    """True if a model has transmissions, ros2_control or a plugin that runs controllers."""
    if model.transmissions or model.ros2_controls:
        return True
    plugins = (plugin for block in model.gazebo for plugin in block.all("plugin"))
    return any("control" in (plugin.get("filename") or "") for plugin in plugins)


def names_parameters(model: RobotModel) -> bool:
    """True if a plugin names a file of parameters."""
    plugins = (plugin for block in model.gazebo for plugin in block.all("plugin"))
    return any(plugin.child("parameters") for plugin in plugins)


def _about_transmissions(model: RobotModel) -> set[str]:
    if not model.transmissions:
        return set(ABOUT_TRANSMISSIONS)
    names = [transmission.get("name") for transmission in model.transmissions]
    moved = [joint.get("name") for one in model.transmissions for joint in one.all("joint")]
    codes = {"RCT030"} if len({*names}) == len(names) and len({*moved}) == len(moved) else set()
    moving = {joint.name for joint in model.joints if joint.kind != "fixed"}
    if all(_is_whole(transmission, moving) for transmission in model.transmissions):
        codes |= {"RCT003", "RCT016"}
        if not model.ros2_controls:
            codes |= {"RCT001", "RCT002"}
    return codes


def _is_whole(transmission: Element, moving: set[str]) -> bool:
    """True if a transmission has a name, a type, actuators, and joints that move."""
    kind, joints = transmission.child("type"), transmission.all("joint")
    actuators = transmission.all("actuator")
    interfaces = [joint.child("hardwareInterface") for joint in joints]
    return (
        bool(transmission.get("name") and kind and kind.text.strip() and joints and actuators)
        and all(joint.get("name") in moving for joint in joints)
        and all(actuator.get("name") for actuator in actuators)
        and all(interface and interface.text.strip() for interface in interfaces)
    )


def _about_statics(model: RobotModel, tree: KinematicTree) -> set[str]:
    """Gravity has nothing to ask where nothing moves or weighs."""
    moves = any(joint.kind in DEGREES_OF_FREEDOM for joint in model.joints)
    if not moves or not any(link.mass for link in model.links):
        return set(ABOUT_STATICS)
    from urdfkit.robot.joint_loads import idle, light, overloadable

    about = {"DYN003": overloadable, "DYN005": light, "DYN006": idle}
    codes = {code for code, doubtful in about.items() if not doubtful(tree)}
    # What stands on one end of a row of links is bolted down.
    if not any(len(joints) > 1 for joints in tree.children.values()):
        codes.add("DYN004")
    return codes


def _about_joints(model: RobotModel) -> set[str]:
    joints = model.joints
    codes: set[str] = set()
    children = {child.tag for joint in joints for child in joint.at.children}
    for tag, about in ABOUT_CHILDREN.items():
        if tag not in children:
            codes |= about
    for named, is_plain in ABOUT_JOINTS.items():
        if all(map(is_plain, joints)):
            codes.update(named)
    if not any(joint.kind == "fixed" and joint.at.child("axis") for joint in joints):
        codes.add("JNT020")
    if all(abs(part) < 5 for joint in joints for part in joint.origin.position):
        codes.add("JNT012")  # which begins at 10 m
    return codes | _about_sense(model) | _about_types([joint.kind for joint in joints])


def _about_sense(model: RobotModel) -> set[str]:
    """Rules about what is legal and hardly meant."""
    joints = model.joints
    codes = _about_strengths(joints)
    if not any(joint.kind == "fixed" and joint.limit for joint in joints):
        codes.add("JNT035")
    if len({joint.limit is None for joint in joints if joint.kind == "continuous"}) < 2:
        codes.add("JNT021")
    if all(abs(part) < 0.5 for joint in joints for part in joint.origin.position):
        codes.add("JNT037")  # which begins at 0.5 m
    names = " ".join(model.links_by_name).lower()
    if "wheel" not in names and not any("wheel" in joint.name.lower() for joint in joints):
        codes |= {"JNT033", "JNT034", "JNT043", "JNT044"}
    kinds = {shape.kind for shape in model.shapes}
    if "cylinder" not in kinds:
        codes.add("JNT034")
        if "mesh" not in kinds:
            codes.add("JNT033")
    if not any(joint.kind == "revolute" for joint in joints):
        codes.add("JNT034")
    if "optical" not in names:
        codes.add("JNT030")
    return codes


def _may_see(model: RobotModel) -> bool:
    """True if a link may be a lidar or a camera."""
    if any(block.child("sensor") for block in model.gazebo):
        return True
    names = " ".join(model.links_by_name).lower()
    return any(word in names for word in _EYES)


def _about_strengths(joints: tuple[Joint, ...]) -> set[str]:
    """Rules about efforts and velocities: silent if those of all joints are much the same."""
    limits = [joint.limit for joint in joints if joint.limit]
    speeds = [limit.velocity.value for limit in limits if limit.velocity]
    efforts = [limit.effort.value for limit in limits if limit.effort]
    codes: set[str] = set()
    if max(speeds, default=0.0) < 45:
        codes.add("JNT040")  # which begins there
    if len(limits) < 4 or (_are_alike(speeds, 20) and _are_alike(efforts, 200)):
        codes.add("JNT039")  # which compares one joint with three others, by these factors
    return codes


def _are_alike(values: list[float], times: float) -> bool:
    known = [value for value in values if value > 0]
    return not known or max(known) < times * min(known)


def _about_mimics(model: RobotModel) -> set[str]:
    """Joints that follow one that moves by itself."""
    mimics = [(joint, joint.mimic) for joint in model.joints if joint.mimic]
    codes = {"JNT036"} if all(mimic.multiplier for _, mimic in mimics) else set()
    for joint, mimic in mimics:
        leader = mimic.joint and model.joints_by_name.get(mimic.joint.value)
        if not leader or leader.mimic or not {leader.kind, joint.kind} <= set(MOVING):
            return codes
    return codes | {"JNT014", "JNT015", "JNT017", "REF004"}


def _about_gazebo(model: RobotModel) -> set[str]:
    words: set[str] = set()
    for block in model.gazebo:
        for part in block.walk():
            words.update((part.tag, part.get("type") or "", part.get("filename") or ""))
    text = " ".join(words)
    codes = {code for code, about in ABOUT_WORDS.items() if not any(w in text for w in about)}
    if "plugin" not in words:
        codes |= ABOUT_PLUGINS
    if "sensor" not in words:
        codes |= ABOUT_SENSORS
    if not {"plugin", "sensor"} & words:
        codes.add("GAZ058")
    return codes


def _about_shapes(model: RobotModel) -> set[str]:
    codes: set[str] = set()
    if all(link.collisions or not link.visuals for link in model.links):
        codes.add("GEO002")
    if all(link.visuals or not link.collisions for link in model.links):
        codes.add("GEO003")
    if any(link.visuals or link.collisions for link in model.links):
        codes.add("GEO008")
    if all(link.visuals or link.collisions or not link.mass for link in model.links):
        codes.add("COL005")
    shapes = model.shapes
    if all(min(shape.scale) > 0 for shape in shapes):
        codes |= ABOUT_SCALES
    lengths = [(*(shape.size or ()), shape.radius, shape.length) for shape in shapes]
    if all(value is None or value > 0 for values in lengths for value in values):
        codes |= ABOUT_SIZES
    if all(value is None or value < 1.6 for values in lengths for value in values):
        codes.add("GEO013")  # which begins at 5 m, as a capsule has with a length and two radii
    if not any(len(link.visuals) > 1 or len(link.collisions) > 1 for link in model.links):
        codes.add("GEO015")
    if not any(_radii(link) for link in model.links):
        codes.add("GEO014")
    return codes


def _radii(link: Link) -> bool:
    """True if visual and collision have radii that differ."""
    if len(link.visuals) != 1 or len(link.collisions) != 1:
        return False
    seen, touched = link.visuals[0].shape, link.collisions[0].shape
    return bool(seen and touched and seen.radius != touched.radius)


def _about_colours(model: RobotModel) -> set[str]:
    codes: set[str] = set()
    materials = [
        *model.materials,
        *(b.material for k in model.links for b in k.visuals if b.material),
    ]
    colours = [material.rgba.value for material in materials if material.rgba]
    if all(0 <= part <= 1 for colour in colours for part in colour):
        codes.add("GEO007")
    if all(colour[-1] > 0 for colour in colours):
        codes.add("GEO010")
    if not colours or not any(block.child("material") for block in model.gazebo):
        codes.add("GEO009")
    if not any(material.texture for material in materials):
        codes.add("GEO011")
    return codes


def _about_types(kinds: list[str]) -> set[str]:
    codes: set[str] = set()
    if all(kind == "fixed" or kind in DEGREES_OF_FREEDOM for kind in kinds):
        codes.add("JNT001")
    if "continuous" not in kinds:
        codes.add("JNT013")
    if kinds.count("continuous") < 4:
        codes.add("JNT043")
    if not {"floating", "planar"}.intersection(kinds):
        codes.add("JNT022")
    if len(kinds) < 2:
        codes.add("JNT031")
    if sum(kind in DEGREES_OF_FREEDOM for kind in kinds) < 2:
        codes |= {"JNT025", "JNT042", "JNT044"}
    if "prismatic" not in kinds:
        codes |= {"JNT032", "JNT038"}
    return codes


def _axis_is_written(joint: Joint) -> bool:
    return joint.axis is not None or joint.kind not in DEGREES_OF_FREEDOM


def _axis_is_unit(joint: Joint) -> bool:
    if joint.kind not in DEGREES_OF_FREEDOM:
        return True
    return joint.axis is not None and abs(hypot(*joint.axis.value) - 1) < 0.01


def _axis_is_plain_or_slanting(joint: Joint) -> bool:
    if joint.axis is None:
        return True
    across = sorted(map(abs, joint.axis.value))[1]
    return across == 0 or across > 0.01


def _limit_is_written(joint: Joint) -> bool:
    limit = joint.limit
    if limit is None:
        return joint.kind not in BOUNDED
    return limit.effort is not None and limit.velocity is not None


def _motor_is_limited(joint: Joint) -> bool:
    limits = (joint.limit.effort, joint.limit.velocity) if joint.limit else ()
    return all(limit is None or limit.value > 0 for limit in limits)


def _range_is_open(joint: Joint) -> bool:
    ends = bounds(joint)
    return ends is None or ends[0] < ends[1]


def _range_is_a_few_turns(joint: Joint) -> bool:
    return all(abs(end) < 4 * pi for end in bounds(joint) or ())


def _turns_without_end(joint: Joint) -> bool:
    written = joint.limit.at.attributes if joint.limit else {}
    return joint.kind != "continuous" or {"lower", "upper"}.isdisjoint(written)


def _range_is_around_zero(joint: Joint) -> bool:
    ends = bounds(joint)
    return ends is None or ends[0] <= 0 <= ends[1]


#: Silent if all joints are plain in this way.
ABOUT_JOINTS: dict[tuple[str, ...], Callable[[Joint], bool]] = {
    ("JNT002",): _limit_is_written,
    ("JNT003", "JNT004"): _range_is_open,
    ("JNT005", "JNT006"): _axis_is_unit,
    ("JNT007",): _axis_is_written,
    ("JNT008", "JNT009", "JNT028"): _motor_is_limited,
    ("JNT010",): _range_is_a_few_turns,
    ("JNT013",): _turns_without_end,
    ("JNT023",): _range_is_around_zero,
    ("JNT027",): _axis_is_plain_or_slanting,
}


def _about_names(model: RobotModel) -> set[str]:
    names = {name.value for name in model.names}
    codes: set[str] = set()
    codes |= {code for code, is_plain in ABOUT_NAMES.items() if all(map(is_plain, names))}
    if not any(joint.name in model.links_by_name for joint in model.joints):
        codes.add("NAM003")
    if len({name.casefold() for name in names}) == len(names):
        codes.add("NAM011")
    if not any(name == "world" or name.startswith("__") for name in names):
        codes.add("NAM005")
    return codes


def _is_plain(name: str) -> bool:
    """True for a name such as ``wheel_2-tyre``."""
    return name.isascii() and name[:1].isalpha() and name.replace("-", "_").isidentifier()


#: Silent if all names are plain in this way.
ABOUT_NAMES: dict[str, Callable[[str], bool]] = {
    "NAM004": _is_plain,
    "NAM007": lambda name: not name.startswith("/"),
    "NAM008": lambda name: not name[:1].isdigit(),
    "NAM010": lambda name: bool(name.strip()),
}
