"""A value is not a number that URDF's readers understand.

They take digits with a decimal point and an exponent, such as `-1.5e-3`, with spaces between the
numbers. A decimal comma, a unit, `inf`, `nan`, a tab between two numbers and white space after
the last are all refused: in a joint urdfdom (RViz, MoveIt, Gazebo, Pinocchio) then rejects the
whole robot, in a link it drops the inertia or every shape of that link. PyBullet goes on with a
wrong number.

Sources:
    urdfdom, joint.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/joint.cpp
    urdfdom, link.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/link.cpp
    ros/urdfdom#98: https://github.com/ros/urdfdom/issues/98
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text import schema
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import as_written, replace_value
from urdfkit.text.grammar import has_break, is_number, owner

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="ball">
  <collision>
    <origin xyz="0, 0, 0,05"/>
    <geometry><sphere radius="0,05"/></geometry>
  </collision>
</link>"""
GOOD = BAD.replace('"0, 0, 0,05"', '"0 0 0.05"').replace('"0,05"', '"0.05"')
FIXED = GOOD


@rule(
    "URD005",
    "bad-number",
    Severity.ERROR,
    help="write digits with a decimal point, and spaces between the numbers",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for element, attribute, kind, _ in subject.deviations.get("URD005", ()):
        assert attribute is not None
        text = as_written(attribute)
        title, edits = "", None
        length = schema.LENGTHS.get(kind, 1)
        if better := _fixed(text, length):
            title, edits = f'write {attribute.name}="{better}"', replace_value(attribute, better)
        reason = _reason(text, length)
        yield Finding(
            attribute,
            f"{owner(element)}: {attribute.name} of <{element.tag}> {reason}",
            title,
            Fix.of(title, edits),
            alike=reason,
        )


def _reason(text: str, length: int) -> str:
    """What is wrong with a value, after its name."""
    count = len(text.split())
    if count == 0:
        return "is empty"
    if count > length == 1:
        return f"holds {count} numbers, not 1"
    if has_break(text):
        return "has a tab or a line break between its numbers; readers want spaces"
    bad = next((part for part in text.split(" ") if part and not is_number(part)), "")
    if not bad:
        return "has white space after the number"
    if "," in bad:
        return f"is written with a comma ('{bad[:40]}'); the decimal sign is a point"
    if bad.strip("+-").lower() in ("inf", "infinity", "nan"):
        return f"is '{bad}', which URDF does not have"
    return f"holds '{bad[:40]}', which is not a number"


def _fixed(text: str, length: int) -> str | None:
    """The value with its commas and white space as readers want them, if that mends it."""
    parts = [part.rstrip(",") for part in text.split()]
    spaced = " ".join(parts)
    for candidate in (spaced, spaced.replace(",", "."), " ".join(text.replace(",", " ").split())):
        found = candidate.split(" ")
        if len(found) == length and all(map(is_number, found)):
            return candidate
    return None
