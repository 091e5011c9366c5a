"""Grammar of elements in a text: URDF, SRDF and Gazebo."""

from urdfkit.lsp.markup import TagNode
from urdfkit.text.schema import JOINT, LINK, ROBOT, Grammar


def grammar_of(node: TagNode) -> Grammar | None:
    """The URDF grammar of an element; None if URDF does not define it."""
    path = [node.name]
    for outer in node.ancestors():
        if outer.name == "robot":
            break
        if not outer.name.startswith("xacro:"):
            path.insert(0, outer.name)
    if path == ["robot"]:
        return ROBOT
    grammar = ROBOT if path[0] in ROBOT.children else _parent_grammar(path[0])
    for name in path:
        inner = grammar.children.get(name)
        if inner is None or inner.open:
            return None
        grammar = inner
    return grammar


def _parent_grammar(tag: str) -> Grammar:
    """The grammar of a parent element of a tag, for a macro that creates a part of a link."""
    queue = [ROBOT]
    for grammar in queue:
        if tag in grammar.children:
            return grammar
        queue += grammar.children.values()
    return ROBOT


#: Tags of xacro, and the attributes of each.
XACRO_TAGS = {
    "xacro:arg": ("name", "default"),
    "xacro:attribute": ("name", "value"),
    "xacro:call": ("macro",),
    "xacro:element": ("xacro:name",),
    "xacro:if": ("value",),
    "xacro:include": ("filename", "ns", "optional"),
    "xacro:insert_block": ("name",),
    "xacro:macro": ("name", "params"),
    "xacro:property": ("name", "value", "default", "scope"),
    "xacro:unless": ("value",),
}
#: Attributes of SRDF and Gazebo that refer to links or joints.
REFERENCES = {
    ("gazebo", "reference"): "frame",
    ("disable_collisions", "link1"): "link",
    ("disable_collisions", "link2"): "link",
    ("enable_collisions", "link1"): "link",
    ("enable_collisions", "link2"): "link",
    ("chain", "base_link"): "link",
    ("chain", "tip_link"): "link",
    ("end_effector", "parent_link"): "link",
    ("virtual_joint", "child_link"): "link",
    ("disable_default_collisions", "link"): "link",
    ("joint_property", "joint_name"): "joint",
    ("link_sphere_approximation", "link"): "link",
    ("passive_joint", "name"): "joint",
}
#: Elements of SDF whose text refers to a link, and parameters of ros2_control.
_FRAMES = ("gz_frame_id", "ignition_frame_id")
_PARAMETERS = {"frame_id": "link", "mimic": "joint"}
#: Elements in which ``<link name>`` and ``<joint name>`` are references.
REFERRING_ELEMENTS = ("transmission", "ros2_control", "group", "group_state")


def kind_of_reference(node: TagNode, attribute: str) -> str:
    """What an attribute refers to: ``link``, ``joint`` or ``frame``; empty for other attributes."""
    grammar = grammar_of(node)
    rule = grammar.attributes.get(attribute) if grammar else None
    kind = rule.type if rule and rule.type in (LINK, JOINT) else ""
    return REFERENCES.get((node.name, attribute), kind)


def kind_of_text(node: TagNode) -> str:
    """What the text of an element refers to: ``link``, ``joint``, or nothing."""
    if node.name == "param" and node.ancestor("ros2_control"):
        return _PARAMETERS.get(node.get("name"), "")
    if node.ancestor("gazebo") is None:
        return ""
    is_of_joint = node.parent is not None and node.parent.name == "joint"
    is_end = is_of_joint and node.name in ("parent", "child")
    return "link" if is_end or node.name in _FRAMES else ""
