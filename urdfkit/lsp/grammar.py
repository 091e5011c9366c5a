"""What URDF's grammar, SRDF and Gazebo say of an element in a text."""

from urdfkit.lsp.markup import TagNode, WrittenAttribute
from urdfkit.text.schema import JOINT, LINK, ROBOT, Grammar


def grammar_of(node: TagNode) -> Grammar | None:
    """What URDF allows in an element; None where URDF has no grammar."""
    way = [node.name]
    for outer in node.around():
        if outer.name == "robot":
            break
        if not outer.name.startswith("xacro:"):
            way.insert(0, outer.name)
    if way == ["robot"]:
        return ROBOT
    grammar = ROBOT if way[0] in ROBOT.children else _holder(way[0])
    for name in way:
        inner = grammar.children.get(name)
        if inner is None or inner.open:
            return None
        grammar = inner
    return grammar


def _holder(tag: str) -> Grammar:
    """The grammar of an element that may hold a tag, for a macro that makes a part of a link."""
    queue = [ROBOT]
    for grammar in queue:
        if tag in grammar.children:
            return grammar
        queue += grammar.children.values()
    return ROBOT


#: Attributes that name a link or a joint outside of URDF's grammar: of SRDF and of Gazebo.
NAMING = {
    ("gazebo", "reference"): "frame",
    ("disable_collisions", "link1"): "link",
    ("disable_collisions", "link2"): "link",
    ("enable_collisions", "link1"): "link",
    ("enable_collisions", "link2"): "link",
    ("chain", "base_link"): "link",
    ("chain", "tip_link"): "link",
    ("end_effector", "parent_link"): "link",
    ("virtual_joint", "child_link"): "link",
    ("passive_joint", "name"): "joint",
}
#: Elements in which ``<link name>`` and ``<joint name>`` are uses.
USERS = ("transmission", "ros2_control", "group", "group_state")


def kind_of_value(node: TagNode, written: WrittenAttribute) -> str:
    """``link`` or ``joint`` for an attribute that refers to one by URDF's grammar."""
    parent = node.parent.name if node.parent else ""
    grammar = ROBOT.children.get(parent)
    inner = grammar.children.get(node.name) if grammar else None
    rule = inner.attributes.get(written.name) if inner else None
    return rule.type if rule and rule.type in (LINK, JOINT) else ""
