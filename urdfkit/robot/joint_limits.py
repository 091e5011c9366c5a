"""Limits, ranges and units of joints, as URDF parsers read them."""

from collections.abc import Collection, Iterable, Sequence
from math import pi

from urdfkit.core.words import listed
from urdfkit.robot.joint import Joint
from urdfkit.robot.model import RobotModel
from urdfkit.robot.placed import Placed
from urdfkit.robot.values import number
from urdfkit.text.diagnostic import Related
from urdfkit.text.source import Span

#: Joints with a lower and an upper limit.
BOUNDED = ("revolute", "prismatic")

#: The soft limits of a ``<safety_controller>``, the lower one first.
SOFT_LIMITS = ("soft_lower_limit", "soft_upper_limit")

#: In m: limits of prismatic joints are clipped to this distance from zero.
MAX_TRAVEL = 1000.0

#: Part of a range by which limits may differ because of rounding.
_ROUNDING = 0.02

#: Parts of the names of joints that turn freely.
_PASSIVE = ("caster", "castor", "roller", "passive")

#: Related locations of a finding about many joints.
_MAX_RELATED = 20


def can_move(joint: Joint) -> bool:
    """True for a joint with one degree of freedom whose limits are not equal."""
    ends = bounds(joint)
    return joint.is_single_dof and (ends is None or ends[0] != ends[1])


def bounds(joint: Joint) -> tuple[float, float] | None:
    """The lower and the upper limit of a revolute or prismatic joint, in rad or m.

    A missing limit is 0, as in urdfdom. None for joints of another type, without ``<limit>``, or
    with an unreadable limit.
    """
    limit = joint.limit
    if limit is None or joint.kind not in BOUNDED:
        return None
    for key, placed in (("lower", limit.lower), ("upper", limit.upper)):
        if placed is None and key in limit.at.attributes:
            return None
    return limit.ends


def overshoot(driven: tuple[float, float], own: tuple[float, float]) -> float:
    """Distance by which a range exceeds the limits of a joint; not positive within rounding."""
    allowed = _ROUNDING * max(driven[1] - driven[0], own[1] - own[0])
    return max(own[0] - driven[0], driven[1] - own[1]) - allowed


def span(joint: Joint) -> tuple[float, float]:
    """The range of a joint, in rad or m; the full range if its limits are invalid.

    An angle without limits, or with the lower limit above the upper one, covers one turn; a range
    of more than one turn is cut to the turn nearest to zero. A prismatic joint stays within
    `MAX_TRAVEL` of zero, and at zero without limits. A joint of another type stays at 0.
    """
    if not joint.is_single_dof:
        return 0.0, 0.0
    lower, upper = bounds(joint) or (0.0, -1.0)
    if joint.is_prismatic:
        lower, upper = (min(max(end, -MAX_TRAVEL), MAX_TRAVEL) for end in (lower, upper))
        return (lower, upper) if lower <= upper else (0.0, 0.0)
    if lower > upper:
        return -pi, pi
    if upper - lower < 2 * pi:
        return lower, upper
    start = min(max(-pi, lower), upper - 2 * pi)
    return start, start + 2 * pi


def start_of(joint: Joint) -> float:
    """The initial position as in MoveIt, in rad or m: 0, or the middle of limits that exclude 0."""
    lower, upper = span(joint)
    return 0.0 if lower <= 0 <= upper else lower + (upper - lower) / 2


def soft_bounds(joint: Joint) -> tuple[float, float] | None:
    """The soft limits of a joint's ``<safety_controller>``, in rad or m.

    A missing soft limit is 0, as in urdfdom. None without the element, or if one is unreadable.
    """
    safety = joint.at.child("safety_controller")
    if safety is None:
        return None
    values = [number(safety.get(key)) if key in safety.attributes else 0.0 for key in SOFT_LIMITS]
    lower, upper = values
    return None if lower is None or upper is None else (lower, upper)


def driven(model: RobotModel) -> frozenset[str]:
    """Names of the joints that a transmission or ros2_control drives; empty without either."""
    names = {
        joint.get("name") or ""
        for transmission in model.transmissions
        for joint in transmission.all("joint")
    }
    names |= {
        joint.get("name") or ""
        for control in model.ros2_controls
        for joint in control.all("joint")
        if joint.child("command_interface")
    }
    return frozenset(names)


def is_passive(joint: Joint, driven_joints: Collection[str]) -> bool:
    """True for a joint without a motor: only others are `driven`, or it is a caster by its name."""
    if joint.name in driven_joints:
        return False
    names = f"{joint.name} {joint.child_name}".lower()
    turns_freely = joint.kind == "continuous" and any(part in names for part in _PASSIVE)
    return bool(driven_joints) or turns_freely


def limits_of(joints: Iterable[Joint], key: str) -> list[tuple[Joint, Placed[float]]]:
    """The joints with a limit of ``effort`` or ``velocity``, each with this limit."""
    limits = [(joint, getattr(joint.limit, key)) for joint in joints if joint.limit]
    return [(joint, limit) for joint, limit in limits if limit]


def several(joints: Sequence[Joint]) -> str:
    """``joint 'a'``, ``joints 'a' and 'b'`` or ``joints 'a', 'b' and 7 more``."""
    names = [f"'{joint.name}'" for joint in joints]
    return f"{'joints' if len(names) > 1 else 'joint'} {listed(names, 2)}"


def related(places: Iterable[tuple[Joint, Span]]) -> tuple[Related, ...]:
    """Related locations of joints with the same defect, without repetitions by a macro."""
    spans: dict[Span, Joint] = {}
    for joint, span in places:
        spans.setdefault(span, joint)
    return tuple(
        Related(span, f"joint '{joint.name}'")
        for span, joint in list(spans.items())[1 : _MAX_RELATED + 1]
    )
