"""A driven wheel has almost no friction, or a fixed caster has too much.

- A wheel that a drive turns, with `mu1`, and perhaps `mu2`, below 0.1: it spins in place, and the
  odometry of the plugin, which counts turns, reports a distance that the robot has not moved. A
  contact has the smaller friction of the two surfaces, so the floor does not compensate for it. The
  values are often copied from the caster.
- A caster that is fixed to the body, a ball that slides, with a friction of 0.5 or more: the drive
  drags it sideways in every turn. If it bears enough of the weight, the robot turns less than
  commanded, or not at all. Write 0.01.

- A driven wheel whose friction is a multiple of that of its left or right counterpart: the robot
  drives in a curve.

- The four wheels of a mecanum drive have the same `fdir1` in the frame of the body: the rollers of
  neighbours must be mirrored, or the robot only drives forwards and backwards. Or all of them are
  mirrored, so that it moves to the wrong side; or `mu2` is as large as `mu1`, so that the wheels do
  not roll sideways.

Wheels with a first friction direction (`fdir1`) are reported only if both coefficients are low.
Wheels of mecanum drives without one are not: links of their own may be their rollers.

Sources:
    SDF, friction: http://sdformat.org/spec?ver=1.9&elem=collision
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
    husky/husky#120: https://github.com/husky/husky/issues/120
    gz-sim, mecanum_drive.sdf: https://github.com/gazebosim/gz-sim/blob/gz-sim8/examples/worlds/mecanum_drive.sdf
    ros-controls/ros2_controllers#1681: https://github.com/ros-controls/ros2_controllers/issues/1681
    Gazebo, friction: https://classic.gazebosim.org/tutorials?tut=friction
"""

from collections.abc import Iterable, Iterator

from urdfkit.checks.drives.mecanum_rollers import Roller, wrong_rollers
from urdfkit.lint.context import Context
from urdfkit.lint.rules import Finding, Findings, Need, Related, Severity, rule
from urdfkit.robot.model import RobotModel
from urdfkit.robot.placed import Placed
from urdfkit.robot.rigid_bodies import rigid_bodies
from urdfkit.robot.samples import collision_xml, joint_xml, robot_xml
from urdfkit.robot.symmetry import pairs
from urdfkit.ros.gazebo.drives import drive_of, wheels
from urdfkit.ros.gazebo.samples import gazebo_xml, plugin_xml, solid_xml
from urdfkit.ros.gazebo.values import leading, text_of, value
from urdfkit.text.document import Element

#: Coefficients below which a wheel has no grip, and from which a caster has.
LITTLE, MUCH = 0.1, 0.5
#: Ratio of the coefficients of two wheels from which they differ.
UNEQUAL = 1.5

_TYRE = collision_xml('<sphere radius="0.1"/>')
BAD = robot_xml(
    solid_xml("base"),
    solid_xml("left", _TYRE),
    joint_xml(
        "continuous", '<origin xyz="0 0.2 0"/><axis xyz="0 1 0"/>', name="left", child="left"
    ),
    solid_xml("right", _TYRE),
    joint_xml(
        "continuous", '<origin xyz="0 -0.2 0"/><axis xyz="0 1 0"/>', name="right", child="right"
    ),
    gazebo_xml("<mu1>0.01</mu1>", "<mu2>0.01</mu2>", reference="left"),
    gazebo_xml(
        plugin_xml(
            "drive",
            "libgazebo_ros_diff_drive.so",
            "<left_joint>left</left_joint>",
            "<right_joint>right</right_joint>",
            "<wheel_separation>0.4</wheel_separation>",
            "<wheel_diameter>0.2</wheel_diameter>",
        )
    ),
)
GOOD = BAD.replace("0.01</mu", "0.9</mu")

#: Drives that turn their wheels against one another, and steer.
_MECANUM = "mecanum"
_ROLLERS = (_MECANUM, "omni", "swerve")


@rule(Severity.WARNING, needs=(Need.MODEL, Need.GAZEBO))
def check(context: Context) -> Findings:
    driven = dict.fromkeys(_driven(context))
    for link in driven:
        given = _friction(context.model, link)
        low = [friction for friction in given.values() if friction.value < LITTLE]
        is_directed = _chooses_direction(context.model, link)
        # A low mu2 alone may let a wheel slip sideways, though it does so in any direction.
        has_low_first = not is_directed and given.get("mu1") in low
        if low and (has_low_first or len(low) == (2 if is_directed else len(given))):
            message = (
                f"driven wheel '{link}' has a friction coefficient of {low[0].value:g}: it spins "
                "in place"
            )
            yield Finding(low[0], message, "write about 1", weight=-low[0].value)
    yield from _unequal(context, driven)
    yield from _casters(context, set(driven))
    for wheels_of_drive in _mecanum_wheels(context):
        yield from wrong_rollers(context, list(_rollers(context.model, wheels_of_drive)))


def _unequal(context: Context, driven: Iterable[str]) -> Findings:
    """Left and right wheels with different coefficients of one direction."""
    for pair in pairs(driven):
        if any(_chooses_direction(context.model, wheel) for wheel in pair):
            continue
        left, right = (_friction(context.model, wheel) for wheel in pair)
        for name in left if right else ():
            sides = [(left[name], pair[0]), (right.get(name, left[name]), pair[1])]
            (low, wheel), (high, other) = sorted(sides, key=lambda side: side[0].value)
            if low.value >= LITTLE and low.value * UNEQUAL <= high.value:
                yield Finding(
                    low,
                    f"driven wheel '{wheel}' has a friction coefficient of {low.value:g}, "
                    f"its counterpart '{other}' {high.value:g}: the robot drives in a curve",
                    f"write {high.value:g}",
                    related=(Related(high.span, f"the coefficient of '{other}'"),),
                )
                break


def _driven(context: Context) -> Iterator[str]:
    """The links of the wheels that drive plugins and drive controllers turn."""
    for use in context.plugins:
        for wheel in wheels(use, context.tree) if drive_of(use) else ():
            link = wheel.wheel.joint.child_name
            if not _has_rollers(use.filename) or _chooses_direction(context.model, link):
                yield link
    for _, controller in context.controllers:
        kind = controller.kind
        if kind is None:
            continue
        has_rollers = _has_rollers(controller.type.lower())
        names = (name for measure in kind.measures for side in measure.sides for name in side)
        for written in controller.values(dict.fromkeys(names)):
            joint = context.model.joints_by_name.get(written.text)
            if joint is None or not joint.child or joint.kind != "continuous":
                continue
            if not has_rollers or _chooses_direction(context.model, joint.child_name):
                yield joint.child_name


def _mecanum_wheels(context: Context) -> Iterator[list[str]]:
    """The links of the four wheels of mecanum drives."""
    for use in context.plugins:
        if _MECANUM in use.filename and drive_of(use):
            yield [wheel.wheel.joint.child_name for wheel in wheels(use, context.tree)]
    for _, controller in context.controllers:
        if _MECANUM in controller.type.lower() and controller.kind:
            names = [value.text for value in controller.values(controller.kind.joints)]
            joints = (context.model.joints_by_name.get(name) for name in names)
            yield [joint.child_name for joint in joints if joint]


def _rollers(model: RobotModel, links: list[str]) -> Iterator[Roller]:
    """The rollers of wheels whose first friction direction is in the frame of the body."""
    for link in links:
        direction = _direction(model, link)
        of_frame = direction.attributes if direction else {}
        body = next((one.value for key, one in of_frame.items() if "expressed_in" in key), "")
        if direction:
            yield Roller(link, direction, body, _friction(model, link))


def _direction(model: RobotModel, link: str) -> Element | None:
    """The first friction direction of a link in the frame of the body; None if there is none."""
    blocks = (block for block in model.gazebo if block.get("reference") == link)
    tags = (one for block in blocks for one in block.walk() if one.tag == "fdir1")
    return next((one for one in tags if any("expressed_in" in key for key in one.attributes)), None)


def _has_rollers(drive: str) -> bool:
    return any(word in drive for word in _ROLLERS)


def _friction(model: RobotModel, link: str) -> dict[str, Placed[float]]:
    """The coefficients of a link, of each direction the last."""
    found: dict[str, Placed[float]] = {}
    for block in model.gazebo:
        if block.get("reference") != link:
            continue
        for element in block.walk():
            name = {"mu": "mu1"}.get(element.tag, element.tag)
            text, _ = leading(text_of(element)) if name in ("mu1", "mu2") else ("", "")
            if text:
                found[name] = Placed(value(text), element)
    return found


def _chooses_direction(model: RobotModel, link: str) -> bool:
    """True if ``mu1`` and ``mu2`` of a link may differ on purpose."""
    blocks = (block for block in model.gazebo if block.get("reference") == link)
    return any(element.tag == "fdir1" for block in blocks for element in block.walk())


def _casters(context: Context, driven: set[str]) -> Findings:
    """What is fixed to the body, touches the ground next to driven wheels, and does not slide."""
    stability = context.stability_on_primitives if driven and context.tree.is_sound else None
    if stability is None or driven.isdisjoint(stability.links):
        return
    fixed = rigid_bodies(context.tree)[0].names
    for link in filter(fixed.__contains__, stability.links):
        is_directed = _chooses_direction(context.model, link)
        given = [] if is_directed else list(_friction(context.model, link).values())
        if given and min(friction.value for friction in given) >= MUCH:
            yield Finding(
                given[0],
                f"'{link}' slides on the ground next to driven wheels, with a friction coefficient "
                f"of {given[0].value:g}: it brakes every turn",
                "write 0.01",
            )
