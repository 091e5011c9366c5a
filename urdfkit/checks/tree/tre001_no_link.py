"""The robot has no link.

urdfdom (RViz, MoveIt, Gazebo, Pinocchio) and PyBullet reject the robot. In a xacro, usually the
macro that creates the links is defined, but never called. A list of joints without parents and
children, such as the thrusters of the BlueROV, is for another program, and a URDF with nothing but
`<ros2_control>` for another file: an info.

Sources:
    urdfdom, model.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/model.cpp
"""

from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.text.document import Element
from urdfkit.text.file_kinds import is_list_of_joints
from urdfkit.text.grammar import owner

BAD = '<robot name="cart">\n</robot>\n'
GOOD = '<robot name="cart">\n  <link name="base"/>\n</robot>\n'

_CONTROL = ("ros2_control", "transmission", "gazebo")


@rule(
    Severity.ERROR,
    help='add a link, as <link name="base_link"/>',
    reports_missing=True,
    depends_on_arguments=True,
)
def check(context: Context) -> Findings:
    root = context.document.root
    if root.tag != "robot" or root.child("link") or context.is_part:
        return
    if root.child("webots"):
        return  # settings of the Webots driver; the links are in the world file
    is_other = is_list_of_joints(root) or (context.reading.xacro is None and _is_control(root))
    severity = Severity.INFO if is_other else None
    yield Finding(root, f"{owner(root)} has no link", severity=severity)


def _is_control(root: Element) -> bool:
    """True for a file with nothing but the hardware and the plugins of a robot."""
    return bool(root.children) and all(child.tag in _CONTROL for child in root.children)
