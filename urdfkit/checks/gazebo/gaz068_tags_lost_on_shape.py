"""Gazebo does not give a shape the friction or material of its link's `<gazebo>` block.

The converter tells by the name of a collision or visual whether the tags are meant for it. A shape
whose own name does not begin with that of its link is passed over, without a word: the wheel has a
friction of 1, whatever `<mu1>` says. A link that is merged into its parent loses them also where
its name begins with that of the parent, and takes the parent's. Leave the name of the shape out, or
let it begin with the name of the link.

Sources:
    gazebosim/sdformat#333: https://github.com/gazebosim/sdformat/issues/333
    gazebosim/gazebo-classic#2497: https://github.com/gazebosim/gazebo-classic/issues/2497
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
    measured: libsdformat 12.3 loses mu1 and material
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.text.diagnostic import Fix, Related, Severity
from urdfkit.text.editing.edits import replace_value

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import RobotModel
    from urdfkit.text.document import Element

BAD = """\
<link name="wheel">
  <collision name="tyre">
    <geometry><sphere radius="0.1"/></geometry>
  </collision>
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo reference="wheel">
  <mu1>0.2</mu1>
</gazebo>"""
GOOD = BAD.replace(' name="tyre"', "")
FIXED = BAD.replace('"tyre"', '"wheel_tyre"')

#: The tags that go to each collision and to each visual.
_TAGS = {
    "collision": (
        *("mu1", "mu2", "kp", "kd", "fdir1", "minDepth", "maxVel", "maxContacts", "laserRetro"),
        "collision",
    ),
    "visual": ("material", "visual"),
}
_MERGED = "_fixed_joint_lump__"


@rule(
    "GAZ068",
    "tags-lost-on-shape",
    Severity.WARNING,
    needs=(Need.MODEL, Need.GAZEBO),
    help="leave the name out, or let it begin with that of the link",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for simulated in subject.gazebo.links:
        for kind, shapes in (
            ("collision", simulated.collisions),
            ("visual", simulated.visuals),
        ):
            for name, shape in shapes:
                link = (shape.parent and shape.parent.get("name")) or ""
                tags = _tags(subject.model, link, _TAGS[kind])
                if tags and not _takes(name, link, kind, is_merged=link != simulated.name):
                    yield _finding(shape, link, simulated.name, tags)


def _tags(model: RobotModel, link: str, known: tuple[str, ...]) -> list[Element]:
    """The tags of a link that its shapes should have."""
    blocks = (block for block in model.gazebo if block.get("reference") == link)
    return [child for block in blocks for child in block.children if child.tag in known]


def _takes(name: str, link: str, kind: str, *, is_merged: bool) -> bool:
    """True if the converter takes a shape of this name for one of its link."""
    return f"{_MERGED}{link}_{kind}" in name if is_merged else _MERGED not in name


def _finding(shape: Element, link: str, top: str, tags: list[Element]) -> Finding:
    listed = ", ".join(dict.fromkeys(f"<{tag.tag}>" for tag in tags))
    lost = f"link '{link}': {listed} of its <gazebo> block"
    related = (Related(tags[0].span, "lost here"),)
    name = shape.attributes.get("name")
    if name is None:
        message = f"{lost} is lost: Gazebo merges it into '{top}', whose name its own begins with"
        return Finding(tags[0], message, "give the link a name that begins otherwise")
    edits = replace_value(name, f"{link}_{name.value}") if link == top else None
    fix = Fix.of(f"rename it to '{link}_{name.value}'", edits)
    message = f"{lost} does not reach <{shape.tag}> '{name.value}', because of its name"
    return Finding(name, message, fix=fix, related=related, alike="named")
