"""One of four wheels turns against the other three.

Drive plugins and controllers give all wheels of a side one speed, positive for forwards. With the
`<axis>` of one wheel the other way round, that wheel drives backwards: the robot skids, turns or
stands still, and its odometry tells nothing of it. Robots whose left wheels all turn against the
right ones are left alone.

Sources:
    ros2_controllers, diff_drive_controller: https://control.ros.org/rolling/doc/ros2_controllers/diff_drive_controller/doc/userdoc.html
    measured: of 1300 public descriptions none has it.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.spatial import dot, rotate
from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.kinematics import direction
from urdfkit.text.diagnostic import Confidence, Related, Severity

if TYPE_CHECKING:
    from urdfkit.core.spatial import Vector
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import Joint

_WHEEL = """\
<link name="{name}"/>
<joint name="{name}_joint" type="continuous">
  <parent link="base"/>
  <child link="{name}"/>
  <origin xyz="{x} {y} 0"/>
  <axis xyz="0 {axis} 0"/>
</joint>
"""
_PLACES = {"front_left": (1, 1), "front_right": (1, -1), "rear_left": (-1, 1)}
_THREE = "".join(
    _WHEEL.format(name=f"{name}_wheel", x=0.2 * x, y=0.15 * y, axis=1)
    for name, (x, y) in _PLACES.items()
)
_LAST = _WHEEL.format(name="rear_right_wheel", x=-0.2, y=-0.15, axis="{axis}")
BAD = f'<link name="base"/>\n{_THREE}{_LAST.format(axis=-1)}'
GOOD = BAD.replace("0 -1 0", "0 1 0")

#: Names of joints that do not roll a wheel along.
_OTHERS = ("caster", "castor", "swivel", "steer", "mecanum", "omni", "roller")

#: Cosine of the angle of two axles that are parallel.
_PARALLEL = 0.95


@rule(
    "JNT043",
    "wheel-against-the-others",
    Severity.WARNING,
    help="turn its <axis> round",
)
def check(subject: Subject) -> Iterator[Finding]:
    axles = list(_axles(subject))
    if len(axles) != 4:
        return
    (_, first), *others = axles
    along = [1.0, *(dot(first, axle) for _, axle in others)]
    if min(map(abs, along)) < _PARALLEL:
        return
    for sign in (1, -1):
        odd = [joint for (joint, _), part in zip(axles, along, strict=True) if part * sign > 0]
        if len(odd) == 1:
            yield Finding(
                odd[0].at.child("axis") or odd[0].at,
                f"joint '{odd[0].name}' turns its wheel against the other three",
                related=tuple(
                    Related((joint.at.child("axis") or joint.at).span, f"joint '{joint.name}'")
                    for joint, _ in axles
                    if joint is not odd[0]
                ),
                confidence=Confidence.INFERRED,
            )


def _axles(subject: Subject) -> Iterator[tuple[Joint, Vector]]:
    """The joints of wheels that turn without end, and the axis of each in the root's frame."""
    frames = subject.tree.frames
    for joint in subject.model.joints:
        if joint.kind != "continuous" or joint.child is None or joint.mimic:
            continue
        name = f"{joint.name} {joint.child.value}".lower()
        frame = frames.get(joint.child.value)
        if frame and "wheel" in name and not any(word in name for word in _OTHERS):
            yield joint, rotate(frame.rotation, direction(joint))
