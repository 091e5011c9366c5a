"""Joints of one finger that differ from the same joint of all other fingers."""

from __future__ import annotations

from collections.abc import Iterator
from math import isclose, pi

from urdfkit.core.record import Record
from urdfkit.core.spatial import times
from urdfkit.core.words import spaced
from urdfkit.lint.context import Context
from urdfkit.robot.fingers import finger_of, odd_one, series
from urdfkit.robot.joint import Joint
from urdfkit.robot.joint_limits import bounds
from urdfkit.robot.kinematics import direction
from urdfkit.robot.placed import Placed
from urdfkit.text.document import Attribute, Element

#: Ratio of an effort or a velocity to that of the other fingers: a little finger is weaker.
_MAX_RATIO = 5.0
#: Ratios of a position limit to that of the others: a decimal point, degrees, a sign.
_MISTAKES = (10.0, 0.1, 100.0, 0.01, 180 / pi, pi / 180, -1.0)
#: Relative tolerance of such a ratio.
_TOLERANCE = 0.02
_DIFFERS = "differs from the joints of all other fingers:"


class OddJoint(Record):
    """A joint of one finger or leg that differs from those of all others by mistake."""

    joint: Joint
    at: Element | Attribute  # what differs
    difference: str  # a predicate whose subject is the joint
    help: str
    other: Joint  # one that is as it should be


def odd_fingers(context: Context) -> Iterator[OddJoint]:
    joints = {joint.name: joint for joint in context.model.joints if joint.is_single_dof}
    for names in series(joints):
        fingers = [joints[name] for name in names]
        yield from _limits(fingers)
        yield from _axes(fingers)
        yield from _parents(fingers)


def _limits(fingers: list[Joint]) -> Iterator[OddJoint]:
    for key in ("effort", "velocity", "lower", "upper"):
        placed: dict[str, Placed[float]] = {
            joint.name: value
            for joint in fingers
            if (value := getattr(joint.limit, key) if joint.limit else None)
        }
        odd = odd_one({name: value.value for name, value in placed.items()})
        if odd is None or len(placed) < len(fingers):
            continue
        (name, expected), value = odd, placed[odd[0]].value
        if _is_mistake(key, value, expected):
            joint, other = _named(fingers, name)
            unit = {"effort": joint.effort_unit, "velocity": f"{joint.unit}/s"}.get(key, joint.unit)
            what = f"{key} limit" if key in ("lower", "upper") else key
            difference = f"{_DIFFERS} {what} {value:g}, not {expected:g} {unit}"
            yield OddJoint(joint, placed[name].at, difference, f"write {expected:g}", other)


def _is_mistake(key: str, value: float, expected: float) -> bool:
    if not value or not expected:
        return False
    ratio = value / expected
    if key in ("effort", "velocity"):
        return not 1 / _MAX_RATIO < ratio < _MAX_RATIO
    return any(isclose(ratio, mistake, rel_tol=_TOLERANCE) for mistake in _MISTAKES)


def _axes(fingers: list[Joint]) -> Iterator[OddJoint]:
    """The joint with the same limits as all others that turns the other way."""
    odd = odd_one({joint.name: direction(joint) for joint in fingers})
    if odd is None or len({bounds(joint) for joint in fingers}) != 1:
        return
    joint, other = _named(fingers, odd[0])
    if direction(joint) == times(direction(other), -1):
        at = joint.at.child_or_self("axis")
        axes = f"axis {spaced(direction(joint), 3)}, not {spaced(direction(other), 3)}"
        difference = f"{_DIFFERS} {axes}"
        yield OddJoint(joint, at, difference, "write the same axis, or mirror the limits", other)


def _parents(fingers: list[Joint]) -> Iterator[OddJoint]:
    """The joint whose parent is a link of another finger."""
    is_own = {
        joint.name: finger_of(joint.name) == finger_of(joint.parent_name) for joint in fingers
    }
    if (odd := odd_one(is_own)) is None or not odd[1]:
        return
    joint, other = _named(fingers, odd[0])
    expected = other.parent_name.replace(finger_of(other.name), finger_of(joint.name))
    if finger_of(joint.parent_name):
        difference = f"{_DIFFERS} parent '{joint.parent_name}', not '{expected}'"
        at = joint.at.child_or_self("parent")
        yield OddJoint(joint, at, difference, f"name '{expected}' as its parent", other)


def _named(fingers: list[Joint], name: str) -> tuple[Joint, Joint]:
    """The joint of a name, and another one."""
    joint = next(joint for joint in fingers if joint.name == name)
    return joint, next(other for other in fingers if other is not joint)
