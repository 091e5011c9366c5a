"""The transforms that a launch file has published by ``static_transform_publisher``.

Its frames are the values of ``--frame-id`` and ``--child-frame-id``, or the two words behind the
numbers: https://github.com/ros2/geometry2/blob/rolling/tf2_ros/src/static_transform_broadcaster_program.cpp
"""

from __future__ import annotations

from itertools import pairwise

from urdfkit.core.record import Record
from urdfkit.core.spatial import Vector
from urdfkit.robot.values import number
from urdfkit.ros.launch.contents import StartedProgram, Word


class StaticTransform(Record):
    """A transform that a program publishes."""

    #: parent and child: the frames.
    parent: Word
    child: Word
    position: Vector  # of the child in the parent, in m


def static_transform(started: StartedProgram) -> StaticTransform | None:
    """The transform that a program publishes; None for another program, or if not all is known."""
    is_publisher = started.executable == "static_transform_publisher"
    if started.package not in ("tf", "tf2_ros") or not is_publisher:
        return None
    words = [word for word in started.words if word.text is not None]
    if len(words) < len(started.words):
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
