"""A wheel turns in the opposite direction of the others.

Drive plugins and controllers give all wheels of a side one speed, positive for forwards.

- One of four wheels has a reversed `<axis>`, a warning: it drives backwards, and the robot skids,
  turns or stands still, while its odometry shows nothing of it. Robots whose left wheels all turn
  against the right ones are not reported.
- The axes of the only left and right wheel are opposite, an info: the robot turns on the spot
  instead of going straight. Some robots are built so, and their driver inverts one sign: then
  ignore this. Where the drive plugin of Gazebo or the controller is known, a rule about it reports
  the same.

Sources:
    ros2_controllers, diff_drive_controller: https://control.ros.org/rolling/doc/ros2_controllers/diff_drive_controller/doc/userdoc.html
    measured: of 671 public robots six have an opposite pair, of 1300 none has one of four
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.core.spatial import Vector, dot, rotate
from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.robot.kinematics import direction
from urdfkit.robot.model import Joint
from urdfkit.text.diagnostic import Confidence, Related, Severity

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


@rule(Severity.WARNING)
def check(subject: Subject) -> Findings:
    yield from _one_of_four(list(_axles(subject)))
    yield from _opposite(subject)


def _one_of_four(axles: list[tuple[Joint, Vector]]) -> Findings:
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
                "invert its <axis>",
                related=tuple(
                    Related((joint.at.child("axis") or joint.at).span, f"joint '{joint.name}'")
                    for joint, _ in axles
                    if joint is not odd[0]
                ),
                confidence=Confidence.INFERRED,
            )


def _axles(subject: Subject) -> Iterator[tuple[Joint, Vector]]:
    """The joints of wheels that turn without end, and the axis of each in the root's frame."""
    for joint in subject.model.joints:
        axle = _axle(subject, joint)
        if _rolls(joint) and axle:
            yield joint, axle


def _opposite(subject: Subject) -> Findings:
    """The only pair of wheels, if their axes are opposite."""
    wheels = [pair for pair in subject.symmetric_joints if all(map(_rolls, pair))]
    if len(wheels) != 1:
        return
    ((left, right),) = wheels
    one, other = _axle(subject, left), _axle(subject, right)
    if one and other and dot(one, other) < -_PARALLEL:
        yield Finding(
            right.at.child("axis") or right.at,
            f"joint '{right.name}' turns its wheel against the other one, '{left.name}'",
            "invert one <axis>, unless the driver of the robot inverts a sign",
            related=(Related((left.at.child("axis") or left.at).span, f"joint '{left.name}'"),),
            confidence=Confidence.INFERRED,
            severity=Severity.INFO,
        )


def _rolls(joint: Joint) -> bool:
    name = f"{joint.name} {joint.child.value if joint.child else ''}".lower()
    is_wheel = "wheel" in name and not any(word in name for word in _OTHERS)
    return is_wheel and joint.kind == "continuous" and joint.mimic is None


def _axle(subject: Subject, joint: Joint) -> Vector | None:
    """The axis of a joint in the frame of the root."""
    frame = subject.tree.frames.get(joint.child.value) if joint.child else None
    return rotate(frame.rotation, direction(joint)) if frame else None
