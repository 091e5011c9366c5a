"""An element lacks a required child element.

urdfdom (RViz, MoveIt, Gazebo, Pinocchio) rejects a robot with a joint without `<parent>` or
`<child>`. It ignores an `<inertial>` without `<mass>` or `<inertia>`; if a visual or collision has
no `<geometry>`, or the `<geometry>` does not begin with a shape, it drops all visuals and
collisions of the link, with one line in the log. The shapes are box, cylinder, sphere, mesh and,
from version 1.1, capsule. Write a plane as a thin box: only Bullet reads `<plane>`, which is an
info unless a target is known, and so is a `<density>` in place of mass and inertia, which only
Isaac Gym reads. A `<material>` belongs after the `<geometry>`.

Sources:
    urdfdom, joint.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/joint.cpp
    urdfdom, link.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/link.cpp
    Bullet, UrdfParser.cpp: https://github.com/bulletphysics/bullet3/blob/master/examples/Importers/ImportURDFDemo/UrdfParser.cpp
"""

from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.robot.samples import inertial_xml, link_xml
from urdfkit.text.document import Element
from urdfkit.text.grammar import owner
from urdfkit.text.schema import SHAPES
from urdfkit.text.urdf_extensions import read_in

BAD = link_xml("base", '<inertial><mass value="2"/></inertial>')
GOOD = link_xml("base", inertial_xml("2", "0.01 0.01 0.02"))


@rule(Severity.ERROR, help="add the element")
def check(context: Context) -> Findings:
    dense: list[Element] = []
    for element, _, missing, _ in context.deviations.get("URD004", ()):
        who = owner(element)
        if element.tag == "inertial" and element.child("density"):
            dense += [element] if element not in dense else []
            continue
        if not missing:
            if element.tag != "plane" or not context.targets.all_are("reads_planes"):
                yield _without_shape(context, element, who)
            continue
        if _calls_macro(context, element):
            continue  # without the prefix: XAC002
        inside = "" if who.startswith(element.tag) else f": <{element.tag}>"
        yield Finding(element, f"{who}{inside} has no <{missing}>", f"add <{missing}>")
    for element in dense:
        yield Finding(
            element,
            f"{owner(element)}: <inertial> has a <density>, which only Isaac Gym reads",
            "for other programs, add <mass> and <inertia>",
            severity=Severity.ERROR if context.targets.names else Severity.INFO,
        )


def _calls_macro(context: Context, element: Element) -> bool:
    """True if a child has the name of a macro, which may create the missing element."""
    xacro = context.reading.xacro
    macros = {macro.name for macro in xacro.macros} if xacro else set()
    return any(child.tag in macros for child in element.children)


def _without_shape(context: Context, element: Element, who: str) -> Finding:
    """Finding about a geometry without a shape, or whose first element is not a shape."""
    message, severity = f"{who}: <geometry> has no shape", Severity.ERROR
    if element.tag in read_in("geometry"):
        message = f"{who}: <geometry> begins with <{element.tag}>, which only Bullet reads"
        severity = Severity.ERROR if context.targets.names else Severity.INFO
    elif element.tag != "geometry":
        message = f"{who}: <geometry> begins with <{element.tag}>, which is not a shape"
    help = f"let its first element be one of {', '.join(SHAPES)}"
    return Finding(element, message, help, severity=severity)
