"""URDF's grammar as data: the elements and attributes, their number and their types.

Sources: the URDF specification of the ROS wiki (http://wiki.ros.org/urdf/XML), urdfdom's
``xsd/urdf.xsd`` and README, and experiments with its ``check_urdf`` 3.0.1 and 6.0.0. Only
``<link>``, ``<joint>`` and ``<material>`` subtrees have a grammar here; ``<gazebo>``,
``<transmission>`` and ``<ros2_control>`` have their own families of rules. Elements that other
programs (Bullet, MuJoCo, Drake) add to URDF without a prefix are in ``urdf_extensions.json``.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from urdfkit.core.record import Record

#: Types of attributes.
NAME = "name"  # a name that is defined here
LINK = "link"  # the name of a link
JOINT = "joint"  # the name of a joint
TEXT = "text"
FLOAT = "number"
XYZ = "x y z"
RGBA = "red green blue alpha"
QUATERNION = "x y z w"

#: Number of values of an attribute. A single scale for all three axes is rejected, too.
LENGTHS = {FLOAT: 1, XYZ: 3, RGBA: 4, QUATERNION: 4}

#: The valid values of ``<robot version>``, oldest first; the first is the default.
VERSIONS = ("1.0", "1.1", "1.2")


class AttributeRule(Record):
    """Type and version of an attribute."""

    type: str  # one of the constants above, or the allowed words: ``true|false``
    required: bool = False  # True if parsers reject the element without it
    since: str = VERSIONS[0]  # the first URDF version that has it


class Grammar(Record):
    """Attributes and children of an element."""

    attributes: dict[str, AttributeRule]  # by name
    children: dict[str, Grammar]  # by tag, the grammar of each
    required: tuple[str, ...] = ()  # tags that must occur
    many: tuple[str, ...] = ()  # tags that may occur more than once
    open: bool = False  # True if any other content is allowed
    choice: bool = False  # True if exactly one of the children is required, as the first child
    any_of: tuple[str, ...] = ()  # attributes of which at least one is required
    since: str = VERSIONS[0]  # the first URDF version that has the element


_REQUIRED_FLOAT = AttributeRule(FLOAT, required=True)
_OPTIONAL_FLOAT = AttributeRule(FLOAT)
_NAME = AttributeRule(NAME)
_REQUIRED_NAME = AttributeRule(NAME, required=True)
_TEXT = AttributeRule(TEXT)

ANYTHING = Grammar({}, {}, open=True)
ORIGIN = Grammar(
    {
        "xyz": AttributeRule(XYZ),
        "rpy": AttributeRule(XYZ),
        "quat_xyzw": AttributeRule(QUATERNION, since="1.1"),
    },
    {},
)

SHAPES = {
    "box": Grammar({"size": AttributeRule(XYZ, required=True)}, {}),
    "cylinder": Grammar({"radius": _REQUIRED_FLOAT, "length": _REQUIRED_FLOAT}, {}),
    "capsule": Grammar({"radius": _REQUIRED_FLOAT, "length": _REQUIRED_FLOAT}, {}, since="1.1"),
    "sphere": Grammar({"radius": _REQUIRED_FLOAT}, {}),
    "mesh": Grammar(
        {"filename": AttributeRule(TEXT, required=True), "scale": AttributeRule(XYZ)}, {}
    ),
}
GEOMETRY = Grammar({}, SHAPES, choice=True)

MATERIAL = Grammar(
    {"name": _REQUIRED_NAME},
    {
        "color": Grammar({"rgba": AttributeRule(RGBA, required=True)}, {}),
        "texture": Grammar({"filename": _TEXT}, {}),
    },
)

VISUAL = Grammar(
    {"name": _NAME},
    {"origin": ORIGIN, "geometry": GEOMETRY, "material": MATERIAL},
    required=("geometry",),
)

COLLISION = Grammar(
    {"name": _NAME}, {"origin": ORIGIN, "geometry": GEOMETRY}, required=("geometry",)
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
    {"name": _REQUIRED_NAME, "type": _TEXT},
    {"inertial": INERTIAL, "visual": VISUAL, "collision": COLLISION},
    many=("visual", "collision"),
)

JOINT_TYPES = ("revolute", "continuous", "prismatic", "fixed", "floating", "planar")

JOINT_GRAMMAR = Grammar(
    {"name": _REQUIRED_NAME, "type": AttributeRule(TEXT, required=True)},
    {
        "origin": ORIGIN,
        "parent": Grammar({"link": AttributeRule(LINK, required=True)}, {}),
        "child": Grammar({"link": AttributeRule(LINK, required=True)}, {}),
        "axis": Grammar({"xyz": AttributeRule(XYZ)}, {}),
        "calibration": Grammar(
            {
                "rising": _OPTIONAL_FLOAT,
                "falling": _OPTIONAL_FLOAT,
                "reference_position": _TEXT,  # in the specification, never read
            },
            {},
        ),
        "dynamics": Grammar(
            {"damping": _OPTIONAL_FLOAT, "friction": _OPTIONAL_FLOAT},
            {},
            any_of=("damping", "friction"),
        ),
        # JNT002 checks for which joint types effort and velocity are required.
        "limit": Grammar(
            dict.fromkeys(("lower", "upper", "effort", "velocity"), _OPTIONAL_FLOAT)
            # URDF 1.2, and ignored in older versions
            | dict.fromkeys(("acceleration", "deceleration", "jerk"), _TEXT),
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
    {"name": _REQUIRED_NAME, "version": _TEXT},
    {
        "link": LINK_GRAMMAR,
        "joint": JOINT_GRAMMAR,
        "material": MATERIAL,
        "gazebo": ANYTHING,
        "transmission": ANYTHING,
        "ros2_control": ANYTHING,
        "sensor": ANYTHING,
    },
    many=("link", "joint", "material"),
)

#: Tags that Gazebo reads only in a ``<gazebo>`` block. Source: the names that sdformat's URDF
#: converter handles, and the children of SDF's ``<link>``, ``<joint>`` and ``<model>`` that URDF
#: does not have.
GAZEBO_TAGS = frozenset(
    "mu1 mu2 fdir1 kp kd maxVel minDepth maxContacts laserRetro selfCollide turnGravityOff "
    "dampingFactor canonicalBody static stopCfm stopErp cfmDamping fudgeFactor provideFeedback "
    "implicitSpringDamper springReference springStiffness preserveFixedJoint "
    "disableFixedJointLumping self_collide gravity kinematic enable_wind must_be_base_link "
    "velocity_decay sensor plugin light projector pose surface friction max_contacts "
    "laser_retro".split()
)

#: Elements of SRDF, which has the same root element as URDF.
SRDF_TAGS = frozenset(
    "group group_state end_effector virtual_joint passive_joint disable_collisions "
    "disable_default_collisions enable_collisions link_sphere_approximation joint_property".split()
)

#: Tags of xacro, which have no effect without their prefix, and the required attribute of each.
XACRO_TAGS = {
    "include": "filename",
    "property": "name",
    "macro": "name",
    "insert_block": "name",
    "arg": "name",
    "if": "value",
    "unless": "value",
}


def elements() -> Iterator[tuple[str, Grammar]]:
    """All tags of URDF with their grammars, from ``<robot>`` down; tags may repeat."""
    stack = [("robot", ROBOT)]
    while stack:
        tag, grammar = stack.pop()
        yield tag, grammar
        stack.extend(grammar.children.items())


@cache
def _places() -> dict[str, dict[str, None]]:
    places: dict[str, dict[str, None]] = {}
    for parent, grammar in elements():
        for tag in grammar.children:
            places.setdefault(tag, {})[parent] = None
    return places


def places_of(tag: str) -> list[str]:
    """Tags of the elements that may contain a tag, such as ``visual`` for ``material``."""
    return list(_places().get(tag, ()))


def numeric_attributes() -> frozenset[str]:
    """Names of all attributes with numeric values, of any element."""
    return frozenset(
        name
        for _, grammar in elements()
        for name, rule in grammar.attributes.items()
        if rule.type in LENGTHS
    )
