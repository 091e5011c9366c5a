"""The limits of a joint look like degrees.

Angles are radians in URDF, and every reader takes them so: a limit of 180 lets the joint turn 28
times, which is no limit at all. Joints that turn more than once have limits such as 6.28 or 12.57,
or round numbers such as 100. A joint is reported if its limits are whole numbers up to 360, reach
further than two turns, and either are angles that people name (45, 90, 135, 180, 270, 360) or are
multiples of 5 that differ from joint to joint, as the ranges of motors do; the other joints may
give them away, too, and so may the other end, where that alone was written in radians. Write them
in radians, or, in xacro, as `${radians(90)}`.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
"""

from __future__ import annotations

from collections.abc import Iterator
from math import pi
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.joints import bounds
from urdfkit.text.diagnostic import Confidence, Fix, Severity
from urdfkit.text.editing.edits import scale_limits

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import Joint

BAD = """\
<link name="base"/>
<link name="arm"/>
<joint name="elbow" type="revolute">
  <parent link="base"/>
  <child link="arm"/>
  <limit lower="-90" upper="90" effort="10" velocity="1"/>
</joint>"""
GOOD = BAD.replace('lower="-90" upper="90"', 'lower="-1.570796327" upper="1.570796327"')
FIXED = GOOD

#: Further than two turns to one side, in rad.
_FAR = 4 * pi
_ONE_TURN = 7.0

#: Angles that have a name of their own.
_NAMED = frozenset((45, 90, 135, 180, 270, 360))

#: Numbers that stand for "far enough".
_ROUND = frozenset((50, 100, 200, 300))


@rule(
    "JNT010",
    "limits-look-like-degrees",
    Severity.WARNING,
    help="write them in radians",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    suspects: list[tuple[Joint, tuple[float, float]]] = []
    for joint in subject.model.joints:
        ends = bounds(joint)
        if ends and joint.kind == "revolute" and _whole(ends) and max(map(abs, ends)) > _FAR:
            suspects.append((joint, ends))
    sizes = {abs(end) for _, ends in suspects for end in ends if abs(end) > _ONE_TURN}
    rest = [ends for joint in subject.model.joints if (ends := _small(joint))]
    lonely = len(rest) >= max(2, len(suspects)) and not sizes & _ROUND
    many = len(sizes) > 1 and all(size % 5 == 0 for size in sizes) and not sizes <= _ROUND
    for joint, (lower, upper) in suspects:
        if not (many or lonely) and not {abs(lower), abs(upper)} & _NAMED:
            continue
        assert joint.limit is not None
        turns = max(abs(lower), abs(upper)) / (2 * pi)
        both = lower == int(lower) and upper == int(upper)
        edits = scale_limits(joint.limit.at, pi / 180) if both else None
        yield Finding(
            joint.limit.at,
            f"joint '{joint.name}' may turn from {lower:g} to {upper:g} rad, {turns:.1f} times "
            f"round; that looks like degrees{'' if both else ', or lacks a decimal point'}",
            fix=Fix.of("write the limits in radians", edits),
            confidence=Confidence.INFERRED,
        )


def _small(joint: Joint) -> tuple[float, float] | None:
    """The limits of a joint that turns about once at most: there somebody thought in radians."""
    ends = bounds(joint)
    is_small = ends is not None and 0 < max(map(abs, ends)) < _ONE_TURN
    return ends if joint.kind == "revolute" and is_small else None


def _whole(ends: tuple[float, float]) -> bool:
    """True for whole numbers of degrees, at one end at least: the other one may be in radians."""
    small, large = sorted(map(abs, ends))
    if ends[0] >= ends[1] or large > 360 or large != int(large):
        return False
    return small == int(small) or small < _ONE_TURN
