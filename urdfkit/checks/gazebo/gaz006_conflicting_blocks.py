"""Two `<gazebo>` blocks give the same tag of one link different values, or one is a copy.

Gazebo uses the last value. The same applies to `turnGravityOff`, `selfCollide` and `dampingFactor`
of links that fixed joints merge: the merged body has one value, that of the last merged link. Keep
one value. Two equal blocks of a link are reported if its left or right counterpart has none: the
reference of the copy was not changed.

Sources:
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
"""

from urdfkit.core.grouping import by_key
from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Need, Related, Severity, rule
from urdfkit.robot.samples import robot_xml
from urdfkit.robot.symmetry import pairs
from urdfkit.ros.catalog.extensions import extensions
from urdfkit.ros.gazebo.samples import gazebo_xml, solid_xml
from urdfkit.text.document import Element

BAD = robot_xml(
    solid_xml("wheel"),
    gazebo_xml("<mu1>0.8</mu1>", reference="wheel"),
    gazebo_xml("<mu1>100</mu1>", reference="wheel"),
)
GOOD = BAD.replace("100", "0.8")

#: Tags with one value for a whole body, including the links merged into it.
_OF_THE_BODY = ("turnGravityOff", "selfCollide", "dampingFactor")
_SCALARS = ("float", "int", "bool", "string", "vector3")


@rule(Severity.WARNING, needs=(Need.MODEL, Need.GAZEBO), help="keep one of the two")
def check(context: Context) -> Findings:
    handled = extensions()
    first: dict[tuple[str, str], Element] = {}
    for block in context.model.gazebo:
        reference = block.get("reference") or ""
        for child in block.children:
            if child.tag not in handled or handled[child.tag].type not in _SCALARS:
                continue
            owner = reference
            if child.tag in _OF_THE_BODY:
                owner = context.gazebo.survivor.get(reference, reference)
            other = first.setdefault((owner, child.tag), child)
            if _value(other) != _value(child):
                yield Finding(child, _message(other, child, owner), related=(_note(other),))
    yield from _copies(context)


def _copies(context: Context) -> Findings:
    """Equal blocks of a link whose counterpart has none."""
    blocks = by_key((block.get("reference") or "", block) for block in context.model.gazebo)
    sides = pairs(link.name for link in context.model.links)
    for name, other in (*sides, *((right, left) for left, right in sides)):
        first, *more = blocks.get(name, (None,))
        for block in more if other not in blocks else ():
            if first is not None and block.children and _values(block) == _values(first):
                yield Finding(
                    block.attributes["reference"],
                    f"'{name}' has two equal <gazebo> blocks, and its counterpart '{other}' none",
                    f"write '{other}'",
                    related=(Related(first.span, "first block"),),
                    confidence=Confidence.INFERRED,
                )


def _values(block: Element) -> list[tuple[str, str]]:
    return sorted(
        (element.tag, _value(element)) for element in block.walk() if element is not block
    )


def _message(other: Element, child: Element, owner: str) -> str:
    names = [element.parent.get("reference") or "" for element in (other, child) if element.parent]
    values = f"{_value(other)} and {_value(child)}"
    if names[0] == names[1]:
        who = f"'{owner}'" if owner else "the model"
        return f"conflicting <{child.tag}> of {who}: {values}; Gazebo takes the last"
    return (
        f"conflicting <{child.tag}> of '{names[0]}' and '{names[1]}', which Gazebo merges into "
        f"'{owner}': {values}"
    )


def _note(other: Element) -> Related:
    return Related(other.span, f"{_value(other)} here")


def _value(element: Element) -> str:
    """As Gazebo compares it."""
    text = (element.get("value") or element.text).strip()
    try:
        return f"{float(text):g}"
    except ValueError:
        return text.lower() if text.lower() in ("true", "false") else text
