"""An rpy looks like degrees.

Roll, pitch and yaw are radians in URDF. Nobody turns a frame by more than once round, so 90 is a
quarter turn that came out as 14 turns and 116.6 degrees: the part stands askew, and no reader can
tell. An `<origin>` of a joint, a shape or an inertia is reported if an angle is more than a turn
in radians and a whole or half number of degrees. Write 1.5708, or, in xacro, `${pi/2}` or
`${radians(90)}`.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from math import pi, radians
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.model import numbers
from urdfkit.text.diagnostic import Confidence, Fix, Severity
from urdfkit.text.editing.edits import replace_value
from urdfkit.text.grammar import owner

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.text.document import Attribute, Element

BAD = """\
<link name="base"/>
<link name="wheel"/>
<joint name="axle" type="continuous">
  <parent link="base"/>
  <child link="wheel"/>
  <origin xyz="0 0.1 0" rpy="-90 0 0"/>
  <axis xyz="0 0 1"/>
</joint>"""
GOOD = BAD.replace("-90", "-1.570796327")
FIXED = GOOD

#: A turn in rad, with room for rounding.
_TURN = 2 * pi + 1e-3


@rule(
    "JNT011",
    "rpy-looks-like-degrees",
    Severity.WARNING,
    help="write the angles in radians",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for origin in _origins(subject.document.root):
        rpy = origin.attributes.get("rpy")
        angles = _with_degrees(rpy.value) if rpy else ()
        if not rpy or not angles:
            continue
        assert origin.parent is not None
        at = origin.parent
        what = owner(at) if at.tag == "joint" else f"{owner(at)}: <{at.tag}>"
        worst = max(filter(_is_degrees, angles), key=abs)
        yield Finding(
            rpy,
            f"{what} is turned by {worst:g} rad, {abs(worst) / (2 * pi):.1f} times round; that "
            "looks like degrees",
            fix=_in_radians(rpy, angles),
            confidence=Confidence.INFERRED,
        )


def _origins(root: Element) -> Iterator[Element]:
    """Of joints, and of the shapes and inertias of links."""
    for part in root.children:
        if part.tag == "joint":
            yield from part.all("origin")
        elif part.tag == "link":
            for child in part.children:
                if child.tag in ("visual", "collision", "inertial"):
                    yield from child.all("origin")


@lru_cache(maxsize=1024)
def _with_degrees(rpy: str) -> tuple[float, ...]:
    """The three angles of a text, if one of them looks like degrees; models repeat a few texts."""
    angles = numbers(rpy) or ()
    return angles if len(angles) == 3 and any(map(_is_degrees, angles)) else ()


def _is_degrees(angle: float) -> bool:
    return _TURN < abs(angle) <= 360 and _is_half_number(angle)


def _is_half_number(angle: float) -> bool:
    return 2 * angle == int(2 * angle)


def _in_radians(rpy: Attribute, angles: tuple[float, ...]) -> Fix | None:
    """All angles are degrees if none of them is a fraction; else those beyond a turn."""
    whole = all(map(_is_half_number, angles))
    texts = [
        f"{radians(angle):.10g}" if angle and (whole or _is_degrees(angle)) else text
        for angle, text in zip(angles, rpy.value.split(), strict=True)
    ]
    edits = replace_value(rpy, " ".join(texts))
    return Fix.of(f'write rpy="{" ".join(texts)}"', edits)
