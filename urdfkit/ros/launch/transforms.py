"""The transforms that ``static_transform_publisher`` publishes in a launch file.

Its frames are the values of ``--frame-id`` and ``--child-frame-id``, or the two words after the
numbers: https://github.com/ros2/geometry2/blob/rolling/tf2_ros/src/static_transform_broadcaster_program.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise, takewhile
from math import radians

from urdfkit.core.record import Record
from urdfkit.core.spatial import Vector
from urdfkit.core.suggest import did_you_mean
from urdfkit.robot.values import number
from urdfkit.ros.launch.contents import StartedProgram, Word

#: The options of the program in ROS 2, each with a value.
_OPTIONS = frozenset(
    "--x --y --z --qx --qy --qz --qw --roll --pitch --yaw --frame-id --child-frame-id".split()
)
_ANGLES = ("--roll", "--pitch", "--yaw")
_TURN = 6.3  # rad
#: Numbers before the two frames: with angles, and with a quaternion.
_COUNTS = (6, 7)
_PROGRAM = "tf2_ros/static_transform_publisher"


class StaticTransform(Record):
    """A static transform that a program publishes."""

    #: parent and child: the frames.
    parent: Word
    child: Word
    position: Vector  # of the child in the parent, in m


def static_transform(program: StartedProgram) -> StaticTransform | None:
    """The transform that a program publishes; None for other programs, or unknown arguments."""
    is_publisher = program.executable == "static_transform_publisher"
    if program.package not in ("tf", "tf2_ros") or not is_publisher:
        return None
    words = [word for word in program.words if word.text is not None]
    if len(words) < len(program.words):
        return None
    options = {flag.text: value for flag, value in pairwise(words)}
    parent, child = options.get("--frame-id"), options.get("--child-frame-id")
    if parent and child:
        x, y, z = (options[key].text if key in options else "0" for key in ("--x", "--y", "--z"))
        return StaticTransform(parent, child, (number(x) or 0, number(y) or 0, number(z) or 0))
    numbers = [value for word in words if (value := number(word.text)) is not None]
    names = [word for word in words if number(word.text) is None]
    if len(numbers) < 6 or len(names) < 2:
        return None
    return StaticTransform(names[0], names[1], (numbers[0], numbers[1], numbers[2]))


def has_unknown_child(program: StartedProgram) -> bool:
    """True for a static transform to a frame whose name is known only at run time."""
    if program.executable != "static_transform_publisher" or not program.words:
        return False
    options = {flag.text: value for flag, value in pairwise(program.words)}
    return options.get("--child-frame-id", program.words[-1]).text is None


def wrong_words(program: StartedProgram) -> Iterator[tuple[Word, str, str]]:
    """Words that ``static_transform_publisher`` of ROS 2 rejects, with message and help."""
    if not program.is_ros_2 or program.key != _PROGRAM:
        return
    words = list(takewhile(lambda word: word.text != "--ros-args", program.words))
    if not words or any(word.text is None for word in words):
        return
    flags = [word for word in words if (word.text or "").startswith("--")]
    for word in flags:
        if word.text not in _OPTIONS:
            hint = did_you_mean(word.text or "", _OPTIONS)
            known = "known options: --frame-id, --child-frame-id, --x, --yaw and others"
            yield word, f"static_transform_publisher has no option '{word.text}'{hint}", known
    for flag, word in pairwise(words):
        angle = number(word.text) if flag.text in _ANGLES else None
        if angle is not None and abs(angle) > _TURN:
            message = f"{flag.text} of static_transform_publisher is {word.text} rad"
            yield word, message, f"write {round(radians(angle), 4)}, if it is in degrees"
    numbers = [word for word in words if number(word.text) is not None]
    are_numbers = words[: len(numbers)] == numbers
    if not flags and not (len(numbers) in _COUNTS and are_numbers and len(words) - 2 in _COUNTS):
        message = f"static_transform_publisher has {len(words)} arguments, but requires 6 numbers"
        help = "write x y z yaw pitch roll PARENT CHILD, without the period of ROS 1"
        yield words[0], f"{message}, or 7 with a quaternion, and two frames", help
