"""Two links, joints or materials of the robot have the same name.

urdfdom (RViz, MoveIt, Gazebo, Pinocchio) and Drake reject the robot, for materials even if both
have the same colour; MuJoCo rejects it for links, PyBullet for links and joints. It is a warning if
all given targets accept the duplicate. The usual cause is a macro that is called twice without a
prefix, a copied link, or two included files that define the same materials. Give one of them
another name, and use it in the joints that refer to it; keep one of the materials. A robot of two
arms whose prefixes are arguments that are empty by default is a warning: pass them.

Visuals that give one material name two colours are a warning: urdfdom uses the first colour for all
parts, with materials defined below `<robot>` before all others; other parsers use each part's own
colour. Drake rejects the robot: an error if it is a target. Give each colour its own name.

Sources:
    urdfdom, model.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/model.cpp
    MuJoCo, user_model.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_model.cc
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
    IntelRealSense/realsense-ros#2282: https://github.com/IntelRealSense/realsense-ros/issues/2282
    ros-industrial/motoman#314: https://github.com/ros-industrial/motoman/issues/314
"""

from collections.abc import Iterable

from urdfkit.core.grouping import repeated
from urdfkit.core.words import spaced
from urdfkit.lint.empty_arguments import prefixes_to_pass
from urdfkit.lint.rules import Context, Finding, Findings, Related, Severity, rule
from urdfkit.robot.link import Material
from urdfkit.robot.samples import joint_xml, link_xml, robot_xml
from urdfkit.text.document import Element

BAD = robot_xml(
    link_xml("base"),
    link_xml("wheel"),
    link_xml("wheel"),
    joint_xml("continuous", name="left", child="wheel"),
)
GOOD = BAD.replace('<link name="wheel"/>\n', "", 1)

#: Of two colours that look the same: half of the least step on a screen.
_MAX_DIFFERENCE = 0.5 / 255


@rule(Severity.ERROR)
def check(context: Context) -> Findings:
    model, to_pass = context.model, prefixes_to_pass(context)
    for parts in (model.links, model.joints):
        for finding in _duplicates(context, (part.at for part in parts), to_pass):
            yield finding._replace(severity=Severity.WARNING) if to_pass else finding
    materials = (material.at for material in model.materials)
    yield from _duplicates(context, materials, "keep one of them", group_key="material")
    yield from _redefined(context)


def _duplicates(
    context: Context, elements: Iterable[Element], help: str = "", group_key: str = ""
) -> Findings:
    given = context.given_facts
    keyed = ((element.get("name"), element) for element in elements)
    for element, first in repeated(pair for pair in keyed if pair[0]):
        name = element.attributes["name"]
        is_taken = (
            bool(given)
            and all(element.tag in facts.repeatable_names for facts in given)
            # An element that is there twice gives its child two parents.
            and (element.tag != "joint" or _child(element) != _child(first))
        )
        yield Finding(
            name,
            f"duplicate {element.tag} '{name.value}'",
            help or f"give each {element.tag} its own name, in a macro by a prefix",
            related=(Related(first.span, "first defined here"),),
            group_key=group_key,
            severity=Severity.WARNING if is_taken else None,
        )


def _child(joint: Element) -> str | None:
    child = joint.child("child")
    return child.get("link") if child else None


def _redefined(context: Context) -> Findings:
    """Materials of visuals whose name has another colour or texture before."""
    model = context.model
    rejecting = [facts for facts in context.given_facts if facts.rejects_recoloured]
    effect = "parsers keep the first"
    if rejecting:
        effect = f"{' and '.join(target.title for target in rejecting)} rejects the robot"
    first: dict[str, Material] = {}
    for material in model.materials:
        if material.name and _appearance(material):
            first.setdefault(material.name.value, material)
    visuals = [(link, body.material) for link in model.links for body in link.visuals]
    for link, used in visuals:
        if not used or not used.name or not used.name.value or not (given := _appearance(used)):
            continue
        name = used.name.value
        known = first.setdefault(name, used)
        if given != _appearance(known) and (rejecting or not _look_alike(used, known)):
            yield Finding(
                used.rgba or used.texture or used.at,
                f"link '{link.name}': material '{name}' is {given} here and "
                f"{_appearance(known)} before; {effect}",
                "give each colour its own name",
                related=(Related(known.at.span, "the first"),),
                group_key=name,
                severity=Severity.ERROR if rejecting else Severity.WARNING,
                targets=tuple(facts.name for facts in rejecting),
            )


def _look_alike(one: Material, other: Material) -> bool:
    """True for colours that are rounded differently."""
    if one.texture or other.texture or not one.rgba or not other.rgba:
        return False
    differences = zip(one.rgba.value, other.rgba.value, strict=False)
    return all(abs(a - b) < _MAX_DIFFERENCE for a, b in differences)


def _appearance(material: Material) -> str:
    """The texture, or the colour as ``1 0 0 1``; empty if there is none to read."""
    if material.texture:
        return material.texture.value
    return spaced(material.rgba.value) if material.rgba else ""
