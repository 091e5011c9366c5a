"""The file is XML, but its root element is not `<robot>`.

The file has another format (an SDF model, a launch file, a mesh), or the name is misspelt: XML is
case-sensitive. urdfdom, Drake, MuJoCo and PyBullet find no robot in it.

A Gazebo world is not a robot, either. The WLD rules compare a world with the robot if you check the
launch file that starts both: `urdfkit check PACKAGE`.

Sources:
    URDF, robot: https://wiki.ros.org/urdf/XML/robot
    urdfdom, model.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/model.cpp
"""

from urdfkit.core.suggest import nearest
from urdfkit.lint.rules import Context, Finding, Findings, Fix, Severity, rule
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import rename_element

#: Programs that check other formats, by root element.
_ELSEWHERE = {
    "sdf": "gz sdf --check FILE checks SDF, worlds too",
    "COLLADA": "name the file that holds the <robot>; urdfkit mesh info FILE inspects a mesh",
    "html": "the file is a web page: download the raw file",
    "mujoco": "python -m mujoco.viewer --mjcf=FILE loads MJCF",
}

BAD = '<Robot name="cart">\n  <link name="base"/>\n</Robot>\n'
FIXED = GOOD = BAD.replace("Robot", "robot")


@rule(Severity.ERROR, help="check the file that holds the <robot>")
def check(context: Context) -> Findings:
    xacro = context.reading.xacro
    if xacro is not None and xacro.is_library:
        return
    for element, *_ in context.deviations.get("URD015", ()):
        edits = rename_element(element, "robot") if nearest(element.tag, ["robot"]) else None
        message = f"the root element is <{element.tag}>, not <robot>"
        help = "rename it to <robot>" if edits else _help(element)
        yield Finding(element, message, help, Fix.of(f"rename <{element.tag}> to <robot>", edits))


def _help(element: Element) -> str:
    """The program that checks a file with this root."""
    if element.tag == "sdf" and element.child("world"):
        return (
            "this is a world of Gazebo: check the package or the launch file that starts it with "
            "the robot (urdfkit check PACKAGE); gz sdf --check FILE checks the world alone"
        )
    return _ELSEWHERE.get(element.tag, "")
