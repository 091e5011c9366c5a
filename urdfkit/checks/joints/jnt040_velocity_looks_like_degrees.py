"""The velocity of a joint looks like degrees per second.

Velocities are radians per second in URDF. Data sheets of arms have 150 or 225 degrees per second,
which taken for radians is faster than any arm: planners and controllers are limited by nothing. A
joint with ends is reported if its velocity is a whole number of 45 or more, no round one that
stands for "fast", and either other joints have other such numbers, or it is one that angles have
(90, 120, 180, 360 ...), or the rest of the robot moves at a walk. Write it in radians, or, in
xacro, as `${radians(150)}`.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
    measured: of 1300 public descriptions none has such a number.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import pi, radians
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Confidence, Fix, Severity
from urdfkit.text.document import Attribute
from urdfkit.text.editing.edits import replace_value

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import Joint, Placed

BAD = """\
<link name="base"/>
<link name="arm"/>
<joint name="elbow" type="revolute">
  <parent link="base"/>
  <child link="arm"/>
  <limit lower="-2" upper="2" effort="10" velocity="180"/>
</joint>"""
GOOD = BAD.replace('"180"', '"3.141592654"')
FIXED = GOOD

#: In degrees per second; motors of legs reach 40 rad/s.
_LEAST, _MOST = 45, 1000

#: Speeds that data sheets of arms have and nothing else.
_NAMED = frozenset((90, 120, 135, 150, 180, 225, 270, 360))

#: Numbers that stand for "fast enough".
_ROUND = frozenset((50, 100, 200, 300, 400, 500, 1000))

#: Between the ends of a joint of an arm, in rad.
_TURNS = 8 * pi

#: The fastest of the other joints of an arm, in rad/s.
_WALK = 10.0


@rule(
    "JNT040",
    "velocity-looks-like-degrees",
    Severity.WARNING,
    help="write it in radians per second",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    known = [
        (joint, joint.limit.velocity)
        for joint in subject.model.joints
        if joint.kind == "revolute" and joint.limit and joint.limit.velocity and not _spins(joint)
    ]
    suspects = [(joint, velocity) for joint, velocity in known if _is_suspect(velocity.value)]
    numbers = {velocity.value for _, velocity in suspects}
    rest = [velocity.value for _, velocity in known if velocity.value not in numbers]
    is_slow = bool(rest) and max(rest) <= _WALK
    for joint, velocity in suspects:
        if len(numbers) > 1 or is_slow or velocity.value in _NAMED:
            yield _finding(joint, velocity)


def _spins(joint: Joint) -> bool:
    """True for a wheel or roller: its ends are too far apart to be ends."""
    limit = joint.limit
    if limit is None or limit.lower is None or limit.upper is None:
        return False
    return limit.upper.value - limit.lower.value > _TURNS


def _is_suspect(velocity: float) -> bool:
    whole = velocity == round(velocity) if _LEAST <= velocity <= _MOST else False
    return whole and velocity not in _ROUND


def _finding(joint: Joint, velocity: Placed[float]) -> Finding:
    right = f"{radians(velocity.value):.10g}"
    at = velocity.at
    edits = replace_value(at, right) if isinstance(at, Attribute) else None
    return Finding(
        velocity,
        f"joint '{joint.name}' may turn at {velocity.value:g} rad/s; that looks like degrees per "
        f"second, {float(right):.3g} rad/s",
        fix=Fix.of("write the velocity in radians per second", edits),
        confidence=Confidence.INFERRED,
        alike="velocity",
    )
