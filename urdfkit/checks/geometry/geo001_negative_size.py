"""A size of a shape is negative.

MuJoCo refuses such a robot. Other engines differ: a box inside out that holds things fast, a
failed assertion, a shape that nothing touches; RViz draws it inside out. Often a formula in the
xacro subtracts more than there is. Write the size in m.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    MuJoCo, user_objects.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_objects.cc
    Drake, URDF geometry: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_geometry.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.shapes import shaped, sizes
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import replace_value

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.text.document import Attribute

BAD = """\
<link name="arm">
  <collision>
    <geometry><box size="0.1 -0.2 0.3"/></geometry>
  </collision>
</link>"""
GOOD = BAD.replace("-0.2", "0.2")
FIXED = GOOD


@rule("GEO001", "negative-size", Severity.ERROR, help="write a positive size in m", fixable=True)
def check(subject: Subject) -> Iterator[Finding]:
    for link, body, shape in shaped(subject.model):
        for attribute, values in sizes(shape):
            if min(values) < 0:
                yield Finding(
                    attribute,
                    f"link '{link.name}': {attribute.name} of the <{shape.kind}> in its "
                    f"{body.at.tag} is {min(values):g} m",
                    fix=_fix(attribute),
                )


def _fix(attribute: Attribute) -> Fix | None:
    """The same numbers without their signs."""
    text = " ".join(part.lstrip("-") for part in attribute.value.split())
    edits = replace_value(attribute, text)
    return Fix.of(f'write {attribute.name}="{text}"', edits)
