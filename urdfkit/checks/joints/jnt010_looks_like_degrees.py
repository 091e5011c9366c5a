"""An angle, a limit or a velocity looks like degrees.

In URDF, angles are in radians and velocities in radians per second; all parsers agree.

- Limits of a revolute joint: a limit of 180 rad is 28 turns and does not limit anything. Limits are
  reported if they are whole numbers up to 360, exceed two turns, and are common angles (45, 90,
  135, 180, 270, 360) or multiples of 5 that differ from joint to joint, or if the other joints or
  the other end are in radians. Numbers with one or two decimals, such as 177.6, are reported next
  to joints that differ or are in radians; multiples of pi are not. Radians that were converted by
  mistake are reported, too: 177.617 is 3.1 rad in degrees. So is one end of any number beyond two
  turns if the other end, and other joints, are in radians: `${300 - home}`.
- An `rpy` of a joint, a shape or an inertia: 90 rad is 14.3 turns, so the part is rotated by 116.6
  degrees. It is reported if an angle is more than a turn and a whole or half number, or more than
  two turns with up to two decimals, and not a multiple of 45 degrees in radians.
- The velocity of a revolute joint: data sheets of arms state 150 or 225 degrees per second. It is
  reported if it is a whole number of 45 or more, not a round placeholder, and either other joints
  have other such numbers, or it is a common speed (90, 120, 180, 360 ...), or all other joints are
  slow.

Write radians, or, in xacro, `${radians(90)}`.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
    measured: of 1300 public descriptions none has such a velocity
"""

from collections.abc import Iterator
from functools import lru_cache
from math import pi, radians

from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Fix, Severity, rule
from urdfkit.robot.joint import Joint
from urdfkit.robot.joint_limits import bounds
from urdfkit.robot.model import RobotModel
from urdfkit.robot.placed import Placed
from urdfkit.robot.samples import arm_xml
from urdfkit.robot.values import numbers
from urdfkit.text.document import Attribute, Element
from urdfkit.text.editing.edits import fix_value, scale_limits
from urdfkit.text.grammar import owner

BAD = arm_xml("revolute", '<limit lower="-90" upper="90" effort="10" velocity="1"/>')
FIXED = GOOD = BAD.replace('lower="-90" upper="90"', 'lower="-1.570796327" upper="1.570796327"')

#: Limits beyond two turns are suspect, in rad.
_TWO_TURNS = 4 * pi
#: Limits below this are in radians.
_ONE_TURN = 7.0

#: The end of a range that is not zero, in rad.
_LEAST_END = 0.1
#: Least number of other joints in radians next to one of which one end is in degrees.
_MIN_IN_RADIANS = 2

#: Common angles in degrees.
_COMMON_ANGLES = frozenset((45, 90, 135, 180, 270, 360))

#: Angles in degrees to which wheels are steered.
_STEERING_ANGLES = frozenset(range(15, 91))

#: Words in the names of joints at a wheel that does not roll.
_NOT_ROLLING = ("steer", "swivel", "caster", "castor")
#: Least limits of a wheel that rolls, in rad.
_MIN_ROLLING = 180

#: Placeholders for "far enough".
_ROUND_ANGLES = frozenset((50, 100, 200, 300))

#: A turn in rad, with a tolerance for rounding.
_TURN = 2 * pi + 1e-3

#: In degrees per second; motors of legs reach 40 rad/s.
_MIN_SPEED, _MAX_SPEED = 45, 1000

#: Speeds in data sheets of arms, which are unusual in rad/s.
_COMMON_SPEEDS = frozenset((90, 120, 135, 150, 180, 225, 270, 360))

#: Placeholders for "fast enough".
_ROUND_SPEEDS = frozenset((50, 100, 200, 300, 400, 500, 1000))

#: 1000 degrees in rad; placeholders that were converted to radians are multiples of it.
_ROUND_ANGLE = radians(1000)

#: Largest range of a joint of an arm, in rad; joints with a larger one are wheels.
_MAX_ARM_RANGE = 8 * pi

#: Largest velocity limit of the other joints of a slow arm, in rad/s.
_MAX_SLOW_SPEED = 10.0


@rule(
    Severity.WARNING,
    confidence=Confidence.INFERRED,
    help="write it in radians, or radians per second",
)
def check(context: Context) -> Findings:
    yield from _limits(context.model)
    yield from _rotations(context.document.root)
    yield from _speeds(context.model)


def _limits(model: RobotModel) -> Findings:
    revolute = [(joint, ends) for joint in model.joints if (ends := _ends(joint))]
    suspects = [
        (joint, ends)
        for joint, ends in revolute
        if _may_be_degrees(ends) and max(map(abs, ends)) > _TWO_TURNS
    ]
    sizes = {abs(end) for _, ends in suspects for end in ends if abs(end) > _ONE_TURN}
    # A limit of at most about one turn is in radians.
    in_radians = sum(0 < max(map(abs, ends)) < _ONE_TURN for _, ends in revolute)
    are_exceptions = in_radians >= max(2, len(suspects)) and not sizes & _ROUND_ANGLES
    are_various = len(sizes) > 1 and all(map(_is_chosen, sizes)) and not sizes <= _ROUND_ANGLES
    for joint, ends in revolute:
        if _is_converted(ends) or (in_radians >= _MIN_IN_RADIANS and _is_mixed(ends)):
            yield _limit(joint, *ends)
    for joint, ends in suspects:
        is_common = {abs(end) for end in ends} & (_COMMON_ANGLES | _steering_angles(joint))
        if are_various or are_exceptions or is_common:
            yield _limit(joint, *ends)


def _steering_angles(joint: Joint) -> frozenset[float]:
    """The angles that are in degrees for a joint that steers a wheel: it does not turn twice."""
    return _STEERING_ANGLES if "steer" in joint.name.lower() else frozenset()


def _ends(joint: Joint) -> tuple[float, float] | None:
    return bounds(joint) if joint.kind == "revolute" else None


def _limit(joint: Joint, lower: float, upper: float) -> Finding:
    assert joint.limit is not None
    turns = max(abs(lower), abs(upper)) / (2 * pi)
    if _rolls(joint) and min(-lower, upper) >= _MIN_ROLLING:
        return Finding(
            joint.limit.at,
            f"joint '{joint.name}' of wheel '{joint.child_name}' has limits [{lower:g}, {upper:g}] "
            f"rad, after which it stops: {turns:.1f} turns",
            'write type="continuous", without lower and upper',
        )
    are_degrees = all(end == int(end) or abs(end) > _ONE_TURN for end in (lower, upper))
    edits = scale_limits(joint.limit.at, pi / 180) if are_degrees else None
    return Finding(
        joint.limit.at,
        f"joint '{joint.name}' has limits [{lower:g}, {upper:g}] rad, {turns:.1f} turns, which "
        f"looks like degrees{'' if are_degrees else ' or a missing decimal point'}",
        fix=Fix.of("write the limits in radians", edits),
    )


def _rolls(joint: Joint) -> bool:
    names = f"{joint.name} {joint.child_name}".lower()
    return "wheel" in names and not any(word in names for word in _NOT_ROLLING)


def _may_be_degrees(ends: tuple[float, float]) -> bool:
    """True if at least one end looks like an angle that a person wrote in degrees."""
    small, large = sorted(map(abs, ends))
    if ends[0] >= ends[1] or large > 360 or not _looks_like_degrees(large):
        return False
    return small < _ONE_TURN or _looks_like_degrees(small)


def _looks_like_degrees(size: float) -> bool:
    """True for a number with up to two decimals that is not a round angle in radians."""
    if size == int(size):
        return True
    is_rounded = abs(100 * size - round(100 * size)) < 1e-6
    return is_rounded and not (_is_near_multiple(size, pi) or _is_near_multiple(size, _ROUND_ANGLE))


def _is_converted(ends: tuple[float, float]) -> bool:
    """True for ends beyond two turns that are whole hundredths of a rad, converted to degrees."""
    is_suspect = _TWO_TURNS < max(map(abs, ends)) <= 360
    if not is_suspect or any(map(_looks_like_degrees, filter(None, ends))):
        return False
    hundredths = [100 * radians(end) for end in ends]
    return all(abs(number - round(number)) < 1e-3 for number in hundredths)


def _is_mixed(ends: tuple[float, float]) -> bool:
    """True if one end is within a turn and the other one beyond two turns, as in ``300 - home``.

    Joints that turn several times do so in both directions, or from zero on.
    """
    small, large = sorted(map(abs, ends))
    is_written = _looks_like_degrees(large)  # such ends are suspect for another reason
    return _LEAST_END < small < _ONE_TURN and _TWO_TURNS < large <= 360 and not is_written


def _is_near_multiple(size: float, unit: float) -> bool:
    """True for a multiple, also if rounded to one decimal, such as 12.6 for four times pi."""
    return abs(size / unit - round(size / unit)) < 0.02


def _is_chosen(size: float) -> bool:
    """True for the end of a range that was chosen: a multiple of 5 degrees, or a fraction."""
    return size % 5 == 0 or size != int(size)


def _rotations(root: Element) -> Findings:
    for origin in _origins(root):
        rpy = origin.attributes.get("rpy")
        angles = _with_degrees(rpy.value) if rpy else ()
        if not rpy or not angles:
            continue
        assert origin.parent is not None
        at = origin.parent
        part = owner(at) if at.tag == "joint" else f"{owner(at)}: <{at.tag}>"
        worst = max(filter(_is_degrees, angles), key=abs)
        message = (
            f"{part} has an rpy of {worst:g} rad, {abs(worst) / (2 * pi):.1f} turns, which looks "
            "like degrees"
        )
        yield Finding(rpy, message, fix=_in_radians(rpy, angles))


def _origins(root: Element) -> Iterator[Element]:
    """The origins of joints, and of the shapes and inertias of links."""
    in_links = (part for link in root.all("link") for part in link.children)
    parts = (part for part in in_links if part.tag in ("visual", "collision", "inertial"))
    for part in (*root.all("joint"), *parts):
        yield from part.all("origin")


@lru_cache(maxsize=1024)
def _with_degrees(rpy: str) -> tuple[float, ...]:
    """The three angles of an rpy, if one of them looks like degrees; models repeat texts."""
    angles = numbers(rpy) or ()
    return angles if len(angles) == 3 and any(map(_is_degrees, angles)) else ()


def _is_degrees(angle: float) -> bool:
    size = abs(angle)
    if not _TURN < size <= 360:
        return False
    is_written = _looks_like_degrees(size) and not _is_near_multiple(size, pi / 4)
    return _is_half_number(angle) or (size > _TWO_TURNS and is_written)


def _is_half_number(angle: float) -> bool:
    return 2 * angle == int(2 * angle)


def _in_radians(rpy: Attribute, angles: tuple[float, ...]) -> Fix | None:
    """Converts all angles if each is a whole or half number; else only those beyond a turn."""
    are_all_degrees = all(map(_is_half_number, angles))
    texts = [
        f"{radians(angle):.10g}" if angle and (are_all_degrees or _is_degrees(angle)) else text
        for angle, text in zip(angles, rpy.value.split(), strict=True)
    ]
    return fix_value(rpy, " ".join(texts))


def _speeds(model: RobotModel) -> Findings:
    known = [
        (joint, joint.limit.velocity)
        for joint in model.joints
        if joint.kind == "revolute" and joint.limit and joint.limit.velocity and not _spins(joint)
    ]
    suspects = [(joint, velocity) for joint, velocity in known if _is_suspect(velocity.value)]
    values = {velocity.value for _, velocity in suspects}
    rest = [velocity.value for _, velocity in known if velocity.value not in values]
    is_slow = bool(rest) and max(rest) <= _MAX_SLOW_SPEED
    for joint, velocity in suspects:
        if len(values) > 1 or is_slow or velocity.value in _COMMON_SPEEDS:
            yield _speed(joint, velocity)


def _spins(joint: Joint) -> bool:
    """True for a wheel or roller: its limits are too far apart to be mechanical stops."""
    limit = joint.limit
    if limit is None or limit.lower is None or limit.upper is None:
        return False
    return limit.upper.value - limit.lower.value > _MAX_ARM_RANGE


def _is_suspect(velocity: float) -> bool:
    whole = velocity == round(velocity) if _MIN_SPEED <= velocity <= _MAX_SPEED else False
    return whole and velocity not in _ROUND_SPEEDS


def _speed(joint: Joint, velocity: Placed[float]) -> Finding:
    in_radians = f"{radians(velocity.value):.10g}"
    message = (
        f"joint '{joint.name}' has velocity limit {velocity.value:g} rad/s, which looks like "
        f"degrees per second ({float(in_radians):.3g} rad/s)"
    )
    fix = fix_value(velocity.at, in_radians)
    return Finding(velocity, message, fix=fix, group_key="velocity")
