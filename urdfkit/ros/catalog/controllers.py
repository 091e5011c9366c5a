"""Parameters of the controllers of ros_control and ros2_control."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from urdfkit.core.record import Record
from urdfkit.core.static_typing import Any
from urdfkit.ros.catalog import data, record

_ROLES = (
    "required",
    "positive",
    "not_negative",
    "not_positive",
    "bounded_since",
    "values",
    "until",
)


class ControllerParameters(Record):
    """The parameters of one class of controller."""

    #: Names of required parameters; of several with ``|`` between them, one is required.
    required: tuple[str, ...] = ()
    positive: tuple[str, ...] = ()  # names of numbers that must be above 0
    #: ``bool``, ``int``, ``double``, ``string`` or ``..._array`` by name, if all versions agree;
    #: ``*`` is the name of a joint. Empty for ROS 1, which converts types.
    types: Mapping[str, str] = {}
    not_negative: tuple[str, ...] = ()  # names of numbers that must be 0 or above
    not_positive: tuple[str, ...] = ()  # names of numbers that must be 0 or below
    bounded_since: str = ""  # the distribution from which these two hold; empty for all
    values: Mapping[str, str] = {}  # the words that a parameter may have, by name as above
    until: Mapping[str, str] = {}  # the last distribution that reads a parameter

    def type_of(self, name: str) -> str | None:
        """The type of a parameter, whose name has dots between levels; None if unknown."""
        return _matching(self.types, name)

    def words_of(self, name: str) -> list[str]:
        """The words that a parameter may have; empty for any."""
        return (_matching(self.values, name) or "").split()


def _matching(known: Mapping[str, str], name: str) -> str | None:
    """The entry of a name, in which ``*`` stands for one level."""
    if name in known:
        return known[name]
    parts = name.split(".")
    for pattern in (key.split(".") for key in known if "*" in key):
        if len(pattern) == len(parts) and all(
            p in ("*", q) for p, q in zip(pattern, parts, strict=True)
        ):
            return known[".".join(pattern)]
    return None


@cache
def parameters_of(controller: str, ros: int) -> ControllerParameters | None:
    """The parameters of a class of controller in ROS 1 or 2; None for an unknown class."""
    entry = data("controllers")[f"ros{ros}"].get(controller)
    return None if entry is None else _parameters(entry)


@cache
def of_manager() -> ControllerParameters:
    """The parameters of the controller manager of ROS 2."""
    return _parameters(data("controllers")["manager"])


def successor(controller: str) -> str | None:
    """The class of ROS 2 that replaces a class of ROS 1; None if there is none."""
    moved: dict[str, str] = data("controllers")["moved"]
    return moved.get(controller)


def classes(ros: int) -> list[str]:
    return list(data("controllers")[f"ros{ros}"])


@cache
def of_servo() -> ControllerParameters:
    """The parameters of MoveIt Servo, which is not a controller, by the last part of their name."""
    return _parameters(data("moveit")["servo"])


def _parameters(entry: dict[str, Any]) -> ControllerParameters:
    types = {name: kind for kind, names in entry.items() for name in names if kind not in _ROLES}
    return record(ControllerParameters, entry, types=types)
