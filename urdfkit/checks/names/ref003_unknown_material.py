"""A visual refers to a material that has no colour and no texture when it is needed.

`<material name="blue"/>` uses the colour of a material defined below `<robot>`, or of an earlier
visual with a material of that name. If there is none, urdfdom (RViz, MoveIt, Gazebo) warns and the
part gets the viewer's default colour. Define the material once, below `<robot>`.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    urdfdom, model.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/model.cpp
"""

from urdfkit.core.suggest import Suggester
from urdfkit.lint.rules import Context, Finding, Findings, Fix, Related, Severity, rule
from urdfkit.robot.samples import link_xml, robot_xml, visual_xml
from urdfkit.text.diagnostic import Edit
from urdfkit.text.document import Attribute, Element
from urdfkit.text.editing.edits import fix_value, from_macro, replace_value
from urdfkit.text.grammar import is_expression, owner

BAD = robot_xml(
    '<material name="dark_grey"><color rgba="0.3 0.3 0.3 1"/></material>',
    link_xml("base", visual_xml('<box size="0.4 0.3 0.1"/>', '<material name="dark_gray"/>')),
)
FIXED = GOOD = BAD.replace("gray", "grey")

#: Names for "no material", in lower case.
_NONE = ("", "none")
#: Number of visuals with the same material that a finding lists.
MAX_NAMED = 8


@rule(
    Severity.WARNING,
    help='define it below <robot>, as <material name="..."><color rgba="..."/></material>',
    reports_missing=True,
)
def check(context: Context) -> Findings:
    model = context.model
    top = {material.at.get("name"): material.at for material in model.materials}
    used = [body.material.at for body in model.visuals if body.material]
    filled = {m.get("name"): m for m in reversed(used) if _is_filled(m)}
    suggester = Suggester([name for name in (*top, *filled) if name])
    for word, uses in _uses_without_colour(top, used).items():
        fix = None
        related = tuple(Related(use.span, "used here, too") for use in uses[1:MAX_NAMED])
        if later := filled.get(word):
            reason = "it is defined only later"
            related = (Related(later.span, "defined here, too late"), *related)
        elif word in top:
            reason = "its definition has none"
            related = (Related(top[word].span, "the definition"), *related)
        else:
            reason = "it is not defined" + _hint(word, suggester)
            suggested = suggester.suggested(word)
            names = [material.get("name") for material in used]
            fix = _renamed(top.get(suggested), uses, names) or _fix(uses, suggested)
        visuals = f"{len(uses)} visuals" if len(uses) > 1 else "the visual"
        who = owner(uses[0].element)
        message = f"{who}: material '{word}' has no colour in {visuals}; {reason}"
        yield Finding(uses[0], message, fix=fix, related=related)


def _fix(uses: list[Attribute], suggested: str) -> Fix | None:
    """Renames all uses; several uses of one macro are one place in the file."""
    edits: dict[Edit, None] = {}
    for use in uses if suggested else ():
        replacement = replace_value(use, suggested)
        if replacement is None:
            return None
        edits.update(dict.fromkeys(replacement))
    return Fix.of(f"rename it to '{suggested}'", tuple(edits))


def _renamed(
    definition: Element | None, uses: list[Attribute], names: list[str | None]
) -> Fix | None:
    """Renames an unused definition, if several places use the same other name."""
    if definition is None or definition.get("name") in names or from_macro(definition):
        return None
    if len({use.span for use in uses}) < 2:
        return None
    return fix_value(definition.attributes["name"], uses[0].value)


def _uses_without_colour(
    top: dict[str | None, Element], used: list[Element]
) -> dict[str, list[Attribute]]:
    """Uses of materials that have no colour yet, in the reading order of urdfdom, by name."""
    defined = {name for name, material in top.items() if _is_filled(material)}
    bare: dict[str, list[Attribute]] = {}
    for material in used:
        name = material.attributes.get("name")
        if name is None or name.value.lower() in _NONE or is_expression(name.value):
            continue
        if name.value in defined:
            continue
        if _is_filled(material):
            defined.add(name.value)
        else:
            bare.setdefault(name.value, []).append(name)
    return bare


def _is_filled(material: Element) -> bool:
    """True if a material has a texture or a colour, readable or not."""
    texture = material.child("texture")
    return material.child("color") is not None or bool(texture and texture.get("filename"))


def _hint(name: str, suggester: Suggester) -> str:
    if name.startswith("Gazebo/"):
        return "; Gazebo's own materials work in <gazebo reference> only"
    return suggester.hint(name)
