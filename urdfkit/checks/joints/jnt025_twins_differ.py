"""A joint differs from its twin on the other side.

Builders draw one side and copy it. Where the left elbow may give 80 N m and the right one 1000,
or one steering joint has an end and the other none, one of the two was forgotten in a correction:
the robot pulls to one side, and a policy learnt on it does so too. Twins are found by name (left
and right, l and r, FL and FR, ...) or, for numbers, by joints at mirrored places of one link, and
they hang on different branches. Limits may be equal or mirrored; a twentieth of the range is
allowed for, as real robots differ so much, 1 % of effort and velocity, and a factor of two of
damping and friction. Zeros have rules of their own.

Sources:
    unitreerobotics/unitree_ros#154: https://github.com/unitreerobotics/unitree_ros/issues/154
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.joints import bounds, effort_unit, unit
from urdfkit.robot.model import number
from urdfkit.text.diagnostic import Confidence, Related, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import Joint, Placed

BAD = """\
<link name="torso"/>
<link name="left_arm"/>
<link name="right_arm"/>
<joint name="left_shoulder" type="revolute">
  <parent link="torso"/>
  <child link="left_arm"/>
  <origin xyz="0 0.2 0"/>
  <axis xyz="0 1 0"/>
  <limit lower="-1" upper="2" effort="80" velocity="11"/>
</joint>
<joint name="right_shoulder" type="revolute">
  <parent link="torso"/>
  <child link="right_arm"/>
  <origin xyz="0 -0.2 0"/>
  <axis xyz="0 1 0"/>
  <limit lower="-1" upper="2" effort="1000" velocity="11"/>
</joint>"""
GOOD = BAD.replace("1000", "80")

_TOLERANCE = 0.01
#: Damping and friction are measured, and differ.
_LOSSES = 2.0
#: Of the range; the legs of a NAO differ by 0.005 of it.
_RANGE_TOLERANCE = 0.05


@rule(
    "JNT025",
    "twins-differ",
    Severity.WARNING,
    help="give both the right value",
)
def check(subject: Subject) -> Iterator[Finding]:
    for first, second in subject.symmetric_joints:
        if differences := list(_differences(first, second)):
            yield Finding(
                second.limit.at if second.limit and first.kind == second.kind else second.at,
                f"joint '{second.name}' differs from its twin '{first.name}': "
                + ", ".join(differences),
                related=(Related(first.at.span, f"the twin '{first.name}'"),),
                confidence=Confidence.INFERRED,
                alike="twins",
            )


def _differences(first: Joint, second: Joint) -> Iterator[str]:
    """What differs, as ``effort 1000, not 80 N m``: the second's value before the first's."""
    if first.kind != second.kind:
        yield f"{second.kind}, not {first.kind}"
        return
    yield from _losses(first, second)
    one, other = first.limit, second.limit
    if one is None or other is None:
        return
    for name, a, b, of in (
        ("effort", one.effort, other.effort, effort_unit(first)),
        ("velocity", one.velocity, other.velocity, f"{unit(first)}/s"),
    ):
        if a and b and _differ(a, b):
            yield f"{name} {b.value:g}, not {a.value:g} {of}"
    ours, theirs = bounds(first), bounds(second)
    if ours is None or theirs is None or ours[0] >= ours[1] or theirs[0] >= theirs[1]:
        return
    if not (_same(ours, theirs) or _same((-ours[1], -ours[0]), theirs)):
        yield (
            f"limits {theirs[0]:g} to {theirs[1]:g}, not {ours[0]:g} to {ours[1]:g} {unit(first)}"
        )


def _losses(first: Joint, second: Joint) -> Iterator[str]:
    """Damping and friction, unless one of the two follows the other."""
    one, other = (joint.at.child("dynamics") for joint in (first, second))
    if one is None or other is None or first.mimic or second.mimic:
        return
    of = effort_unit(first)
    for key, dimension in (("damping", f"{of} s/{unit(first)}"), ("friction", of)):
        a, b = number(one.get(key)), number(other.get(key))
        if a and b and max(a, b) > _LOSSES * min(a, b) > 0:
            yield f"{key} {b:g}, not {a:g} {dimension}"


def _differ(a: Placed[float], b: Placed[float]) -> bool:
    high, low = max(a.value, b.value), min(a.value, b.value)
    return low > 0 and high - low > _TOLERANCE * high


def _same(ours: tuple[float, float], theirs: tuple[float, float]) -> bool:
    allowed = _RANGE_TOLERANCE * max(ours[1] - ours[0], theirs[1] - theirs[0])
    return abs(ours[0] - theirs[0]) <= allowed and abs(ours[1] - theirs[1]) <= allowed
