"""MoveIt's joint_limits.yaml, which is next to the SRDF and overrides limits of the robot.

Source: ``robot_model`` and ``robot_model_loader`` of MoveIt 1 and 2.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import radians

from urdfkit.core.record import Record
from urdfkit.robot.values import number
from urdfkit.ros import RosDescription
from urdfkit.text.located_yaml import Value, items, mapping

_FILE = "joint_limits.yaml"
_ON = ("true", "yes", "on", "1")
#: In a name that a launch file replaces: ``$(var tf_prefix)joint_1``, or ``<prefix>joint_1``, which
#: is for ``ReplaceString`` of Nav2.
_REPLACED = ("$(", "<")


class PlannedLimit(Record):
    """The limits of a joint in the file."""

    joint: str  # name
    at: Value  # the name with its location
    values: dict[str, Value]  # by name, such as ``max_velocity``

    def is_on(self, switch: str) -> bool:
        """True if a switch such as ``has_velocity_limits`` is on."""
        on = self.values.get(switch)
        return on is not None and on.text.strip().lower() in _ON

    def bound(self, name: str, switch: str) -> float | None:
        """A bound in units of rad, m and s, if its switch is on; None without a bound."""
        value = self.values.get(name)
        if value is None or not self.is_on(switch):
            return None
        found = number(value.text)
        # Launch files of ROS 1 and xacro read these tags; the default unit is radians.
        return radians(found) if found is not None and value.tag == "!degrees" else found


def planned_limits(description: RosDescription) -> Iterator[PlannedLimit]:
    """The limits that MoveIt plans with, in the order of the file; empty without a file."""
    if description.srdf is None:
        return
    root = description.moveit_config.parameter(_FILE, "robot_description_planning")
    entries = list(items(root, "joint_limits"))
    if any(mark in name for name, _ in entries for mark in _REPLACED):
        return
    for name, entry in entries:
        given = {key: value for key, value in mapping(entry).items() if isinstance(value, Value)}
        if given:
            yield PlannedLimit(name, name.at, given)
