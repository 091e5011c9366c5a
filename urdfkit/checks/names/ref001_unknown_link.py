"""A joint names a link that the model does not have.

Then there is no tree: urdfdom (RViz, MoveIt, Gazebo, Pinocchio), MuJoCo, Drake and PyBullet refuse
the robot. The name is misspelt, a prefix is missing, or the macro that makes the link was not
called. `world` is no exception: it needs a `<link name="world"/>` like every other link, but for
Drake, which has that link itself.

Sources:
    urdfdom, model.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/model.cpp
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import Suggester
from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import from_macro, insert_before, replace_value
from urdfkit.text.grammar import is_expression

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import Joint
    from urdfkit.text.document import Attribute

BAD = """\
<link name="base_link"/>
<link name="lid"/>
<joint name="hinge" type="fixed">
  <parent link="base_lnk"/>
  <child link="lid"/>
</joint>"""
GOOD = BAD.replace("base_lnk", "base_link")
FIXED = GOOD


@rule(
    "REF001",
    "unknown-link",
    Severity.ERROR,
    help="correct the name, or add the link",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    known = subject.model.links_by_name
    children = {joint.child.value for joint in subject.model.joints if joint.child}
    # A second parent would be another error.
    spellers = {"parent": Suggester(known), "child": Suggester(known.keys() - children)}
    for joint in subject.model.joints:
        for role in ("parent", "child"):
            element = joint.at.child(role)
            link = element.attributes.get("link") if element else None
            if link is None or link.value in known or is_expression(link.value):
                continue
            if link.value == "world" and subject.targets.are_only("drake"):
                continue
            if subject.is_part:  # the file that includes it has the link
                return
            suggested = spellers[role].suggested(link.value)
            if suggested in _ends(joint):
                suggested = ""
            hint = f"; did you mean '{suggested}'?" if suggested else ""
            yield Finding(
                link,
                f"joint '{joint.name}': {role} link '{link.value}' is not in the model{hint}",
                fix=_fix(joint, link, suggested),
            )


def _ends(joint: Joint) -> list[str]:
    """The names of the links that a joint has as its ends."""
    return [end.value for end in (joint.parent, joint.child) if end]


def _fix(joint: Joint, link: Attribute, suggested: str) -> Fix | None:
    """The remedy: another name, or the link that is always the same."""
    if suggested:
        edits = replace_value(link, suggested)
        return Fix.of(f"rename '{link.value}' to '{suggested}'", edits)
    if link.value != "world" or from_macro(joint.at):
        return None
    return Fix('add <link name="world"/>', insert_before(joint.at, ('<link name="world"/>',)))
