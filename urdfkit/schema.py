"""URDF's grammar as data: which elements and attributes there are, how often, of which type.

Sources: the URDF specification of the ROS wiki (http://wiki.ros.org/urdf/XML), urdfdom's
parsers and its ``xsd/urdf.xsd``. ``capsule`` is read by urdfdom 5 (REP 2016's version 1.2).
Only ``<link>``, ``<joint>`` and ``<material>`` subtrees have a grammar here; ``<gazebo>``,
``<transmission>`` and ``<ros2_control>`` have their own families of rules.
"""

from __future__ import annotations

from typing import NamedTuple

#: Types of attributes.
NAME = "name"  # a name that is defined here
LINK = "link"  # the name of a link
JOINT = "joint"  # the name of a joint
TEXT = "text"
FLOAT = "number"
XYZ = "3 numbers"
RGBA = "4 numbers"
SCALE = "1 or 3 numbers"

#: How many numbers a vector attribute has.
LENGTHS = {FLOAT: (1,), XYZ: (3,), RGBA: (4,), SCALE: (3,)}


class AttributeRule(NamedTuple):
    type: str
    required: bool = False


class Grammar(NamedTuple):
    """What an element may hold.

    Attributes:
        attributes: by name.
        children: by tag, the grammar of each.
        required: tags that must occur.
        many: tags that may occur more than once.
        open: True if anything else may stand here too.
    """

    attributes: dict[str, AttributeRule]
    children: dict[str, Grammar]
    required: tuple[str, ...] = ()
    many: tuple[str, ...] = ()
    open: bool = False


_REQUIRED_FLOAT = AttributeRule(FLOAT, required=True)
_OPTIONAL_FLOAT = AttributeRule(FLOAT)
_LEAF_NAME = AttributeRule(NAME)

ANYTHING = Grammar({}, {}, open=True)
ORIGIN = Grammar({"xyz": AttributeRule(XYZ), "rpy": AttributeRule(XYZ)}, {})

SHAPES = {
    "box": Grammar({"size": AttributeRule(XYZ, required=True)}, {}),
    "cylinder": Grammar({"radius": _REQUIRED_FLOAT, "length": _REQUIRED_FLOAT}, {}),
    "capsule": Grammar({"radius": _REQUIRED_FLOAT, "length": _REQUIRED_FLOAT}, {}),
    "sphere": Grammar({"radius": _REQUIRED_FLOAT}, {}),
    "mesh": Grammar(
        {"filename": AttributeRule(TEXT, required=True), "scale": AttributeRule(SCALE)}, {}
    ),
}
GEOMETRY = Grammar({}, SHAPES)

MATERIAL = Grammar(
    {"name": AttributeRule(NAME, required=True)},
    {
        "color": Grammar({"rgba": AttributeRule(RGBA, required=True)}, {}),
        "texture": Grammar({"filename": AttributeRule(TEXT, required=True)}, {}),
    },
)

VISUAL = Grammar(
    {"name": _LEAF_NAME},
    {"origin": ORIGIN, "geometry": GEOMETRY, "material": MATERIAL},
    required=("geometry",),
)

COLLISION = Grammar(
    {"name": _LEAF_NAME},
    {"origin": ORIGIN, "geometry": GEOMETRY, "verbose": ANYTHING},
    required=("geometry",),
)

INERTIAL = Grammar(
    {},
    {
        "origin": ORIGIN,
        "mass": Grammar({"value": _REQUIRED_FLOAT}, {}),
        "inertia": Grammar(
            dict.fromkeys(("ixx", "ixy", "ixz", "iyy", "iyz", "izz"), _REQUIRED_FLOAT), {}
        ),
    },
    required=("mass", "inertia"),
)

LINK_GRAMMAR = Grammar(
    {"name": AttributeRule(NAME, required=True), "type": AttributeRule(TEXT)},
    {"inertial": INERTIAL, "visual": VISUAL, "collision": COLLISION},
    many=("visual", "collision"),
)

JOINT_TYPES = ("revolute", "continuous", "prismatic", "fixed", "floating", "planar")

JOINT_GRAMMAR = Grammar(
    {"name": AttributeRule(NAME, required=True), "type": AttributeRule(TEXT, required=True)},
    {
        "origin": ORIGIN,
        "parent": Grammar({"link": AttributeRule(LINK, required=True)}, {}),
        "child": Grammar({"link": AttributeRule(LINK, required=True)}, {}),
        "axis": Grammar({"xyz": AttributeRule(XYZ)}, {}),
        "calibration": Grammar(
            {
                "rising": _OPTIONAL_FLOAT,
                "falling": _OPTIONAL_FLOAT,
                "reference_position": _OPTIONAL_FLOAT,
            },
            {},
        ),
        "dynamics": Grammar({"damping": _OPTIONAL_FLOAT, "friction": _OPTIONAL_FLOAT}, {}),
        # effort and velocity: JNT002 and JNT021 know for which types they are required.
        "limit": Grammar(
            dict.fromkeys(("lower", "upper", "effort", "velocity"), _OPTIONAL_FLOAT)
            | dict.fromkeys(("acceleration", "deceleration", "jerk"), _OPTIONAL_FLOAT),
            {},
        ),
        "mimic": Grammar(
            {
                "joint": AttributeRule(JOINT, required=True),
                "multiplier": _OPTIONAL_FLOAT,
                "offset": _OPTIONAL_FLOAT,
            },
            {},
        ),
        "safety_controller": Grammar(
            {
                "soft_lower_limit": _OPTIONAL_FLOAT,
                "soft_upper_limit": _OPTIONAL_FLOAT,
                "k_position": _OPTIONAL_FLOAT,
                "k_velocity": _REQUIRED_FLOAT,
            },
            {},
        ),
    },
    required=("parent", "child"),
)

#: The grammar of ``<robot>``.
ROBOT = Grammar(
    {"name": AttributeRule(NAME, required=True), "version": AttributeRule(TEXT)},
    {
        "link": LINK_GRAMMAR,
        "joint": JOINT_GRAMMAR,
        "material": MATERIAL,
        "gazebo": ANYTHING,
        "transmission": ANYTHING,
        "ros2_control": ANYTHING,
        "sensor": ANYTHING,
    },
    many=("link", "joint", "material", "gazebo", "transmission", "ros2_control", "sensor"),
)


def places_of(tag: str) -> list[str]:
    """The elements that may hold a tag, such as ``visual`` for ``material``."""
    found: list[str] = []
    stack = [("robot", ROBOT)]
    while stack:
        parent, grammar = stack.pop()
        for child, inner in grammar.children.items():
            if child == tag and parent not in found:
                found.append(parent)
            stack.append((child, inner))
    return found
