"""The axis of a joint is nearly, but not quite, x, y or z.

CAD exporters leave such noise behind. It does little harm: a joint that is off by 0.002 rad moves
a hand at one metre by 2 mm. Closed-form inverse kinematics, which needs axes that are exactly
parallel or at right angles, fails, and Pinocchio takes its slower joint for an axis of any
direction. Write the axis that was meant.

Sources:
    Pinocchio, URDF joints: https://github.com/stack-of-tasks/pinocchio/blob/devel/include/pinocchio/parsers/urdf/model.hxx
"""

from __future__ import annotations

from collections.abc import Iterator
from math import hypot
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.joints import MOVING
from urdfkit.robot.model import length
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.document import Attribute
from urdfkit.text.editing.edits import replace_value

if TYPE_CHECKING:
    from urdfkit.core.spatial import Vector
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import Placed

BAD = """\
<link name="base"/>
<link name="wheel"/>
<joint name="axle" type="continuous">
  <parent link="base"/>
  <child link="wheel"/>
  <axis xyz="0.0039668 0 -0.99999"/>
</joint>"""
GOOD = BAD.replace("0.0039668 0 -0.99999", "0 0 -1")
FIXED = GOOD

#: In rad: a third of a degree. What is further off is likely meant.
_MOST = 5e-3
#: In rad; what is nearer is the rounding of a number with sixteen digits.
_LEAST = 1e-9
#: Axes of another length are JNT006's.
_TOLERANCE = 0.01


@rule(
    "JNT027",
    "axis-nearly-a-basis-vector",
    Severity.INFO,
    help="write the axis that was meant",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for joint in subject.model.joints:
        axis = joint.axis
        if axis is None or joint.kind not in MOVING or abs(length(axis.value) - 1) > _TOLERANCE:
            continue
        sizes = [abs(part) for part in axis.value]
        main = sizes.index(max(sizes))
        off = hypot(*sizes[:main], *sizes[main + 1 :])
        if _LEAST < off < _MOST:
            sign = "-" if axis.value[main] < 0 else ""
            suggested = " ".join(f"{sign}1" if index == main else "0" for index in range(3))
            yield Finding(
                axis,
                f"joint '{joint.name}': the axis is {off:.2g} rad off {sign}{'xyz'[main]}",
                fix=_snapped(axis, suggested),
            )


def _snapped(axis: Placed[Vector], suggested: str) -> Fix | None:
    assert isinstance(axis.at, Attribute)
    edits = replace_value(axis.at, suggested)
    return Fix.of(f'write xyz="{suggested}"', edits)
