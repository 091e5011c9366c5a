"""Parameters of the controllers of ros_control and ros2_control."""

from __future__ import annotations

from functools import cache

from urdfkit.core.record import Record
from urdfkit.ros.catalog import data

_ROLES = ("required", "positive")


class ControllerParameters(Record):
    """The parameters of one class of controller."""

    required: tuple[str, ...]  # names of required parameters
    positive: tuple[str, ...]  # names of numbers that must be above 0
    #: ``bool``, ``int``, ``double``, ``string`` or ``..._array`` by name, if all versions agree;
    #: ``*`` is the name of a joint. Empty for ROS 1, which converts types.
    types: dict[str, str]

    def type_of(self, name: str) -> str | None:
        """The type of a parameter, whose name has dots between levels; None if unknown."""
        if name in self.types:
            return self.types[name]
        parts = name.split(".")
        for pattern in (known.split(".") for known in self.types if "*" in known):
            if len(pattern) == len(parts) and all(
                p in ("*", q) for p, q in zip(pattern, parts, strict=True)
            ):
                return self.types[".".join(pattern)]
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


def _parameters(entry: dict[str, list[str]]) -> ControllerParameters:
    types = {name: kind for kind, names in entry.items() for name in names if kind not in _ROLES}
    return ControllerParameters(
        tuple(entry.get("required", ())), tuple(entry.get("positive", ())), types
    )
