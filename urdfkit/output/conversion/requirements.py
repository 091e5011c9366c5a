"""Requirements of every conversion: each joint and number of the robot is valid."""

from collections.abc import Iterator

from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.robot.joint import SINGLE_DOF, Joint
from urdfkit.robot.origin import reads_quaternions
from urdfkit.robot.values import number, numbers, vector
from urdfkit.text.document import Element
from urdfkit.text.schema import JOINT_TYPES
from urdfkit.text.source import Span

_VECTORS = {"origin": ("xyz", "rpy"), "axis": ("xyz",), "mesh": ("scale",)}
_NUMBERS = {
    "mass": ("value",),
    "inertia": ("ixx", "iyy", "izz", "ixy", "ixz", "iyz"),
    "limit": ("lower", "upper"),
    "mimic": ("multiplier", "offset"),
}


def require_meaning(robot: Context) -> None:
    """Raise an error at the first invalid number or joint.

    Raises:
        UrdfkitError: links and joints do not form one tree; a joint is invalid; a value is not
            a number.
    """
    if not robot.tree.is_sound:
        raise UrdfkitError(robot.tree.unsound)
    for joint in robot.model.joints:
        for span, problem in (*_unreadable(joint.at), *_invalid(joint)):
            raise UrdfkitError(f"{span}: joint '{joint.name}': {problem}")
    for link in robot.model.links:
        for span, problem in _unreadable(link.at):
            raise UrdfkitError(f"{span}: link '{link.name}': {problem}")


def _unreadable(part: Element) -> Iterator[tuple[Span, str]]:
    for element in part.walk():
        yield from _unreadable_quaternion(element)
        if element.tag == "inertia":
            missing = [name for name in _NUMBERS["inertia"] if name not in element.attributes]
            for name in missing[:1]:
                yield element.span, f"<inertia> has no {name}; write all six moments"
        for names, read, count in (
            (_VECTORS, vector, "3 finite numbers"),
            (_NUMBERS, number, "a finite number"),
        ):
            for name in names.get(element.tag, ()):
                attribute = element.attributes.get(name)
                if attribute is not None and read(attribute.value) is None:
                    problem = f"{name} of <{element.tag}> is '{attribute.value}'"
                    yield attribute.span, f"{problem}; write {count}"


def _unreadable_quaternion(element: Element) -> Iterator[tuple[Span, str]]:
    written = element.attributes.get("quat_xyzw") if element.tag == "origin" else None
    if written is None or not reads_quaternions(element):
        return
    if "rpy" in element.attributes:
        yield written.span, "<origin> has both rpy and quat_xyzw; remove one of them"
    elif len(numbers(written.value) or ()) != 4:
        problem = f"quat_xyzw of <origin> is '{written.value}'"
        yield written.span, f"{problem}; write 4 finite numbers"


def _invalid(joint: Joint) -> Iterator[tuple[Span, str]]:
    if joint.kind not in JOINT_TYPES:
        kinds = ", ".join(JOINT_TYPES)
        yield joint.at.span, f"its type is '{joint.kind}', not a type of URDF; use one of {kinds}"
    moves = joint.kind in (*SINGLE_DOF, "planar")
    if moves and joint.axis is not None and not any(joint.axis.value):
        yield joint.axis.span, "its axis is 0 0 0; write a direction"
    if moves and joint.kind != "continuous" and joint.limit is not None:
        lower, upper = joint.limit.ends
        if lower > upper:
            yield joint.limit.at.span, "its lower limit is above the upper limit; swap them"
