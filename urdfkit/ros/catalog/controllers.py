"""What the controllers of ros_control and ros2_control want of their parameters."""

from __future__ import annotations

from functools import cache

from urdfkit.core.record import Record
from urdfkit.ros.catalog import data

_ROLES = ("required", "positive")


class ControllerParameters(Record):
    """The parameters of one class of controller."""

    required: tuple[str, ...]  # names of those without which it does not start
    positive: tuple[str, ...]  # of the numbers that must be above 0
    #: ``bool``, ``int``, ``double``, ``string`` or ``..._array`` by name, where all versions agree;
    #: ``*`` stands for the name of a joint. None is known in ROS 1, which is lenient.
    types: dict[str, str]

    def type_of(self, name: str) -> str | None:
        """The type of a parameter, with dots between levels; None if it is not known."""
        if name in self.types:
            return self.types[name]
        parts = name.split(".")
        for pattern in (one.split(".") for one in self.types if "*" in one):
            if len(pattern) == len(parts) and all(
                p in ("*", q) for p, q in zip(pattern, parts, strict=True)
            ):
                return self.types[".".join(pattern)]
        return None


@cache
def parameters_of(controller: str, ros: int) -> ControllerParameters | None:
    """What a class of controller wants in ROS 1 or 2; None for one that is not known."""
    entry = data("controllers")[f"ros{ros}"].get(controller)
    return None if entry is None else _parameters(entry)


@cache
def of_manager() -> ControllerParameters:
    """What the controller manager of ROS 2 wants of its own parameters."""
    return _parameters(data("controllers")["manager"])


def successor(controller: str) -> str | None:
    """What took the place of a class of ROS 1 in ROS 2."""
    moved: dict[str, str] = data("controllers")["moved"]
    return moved.get(controller)


def classes(ros: int) -> list[str]:
    return list(data("controllers")[f"ros{ros}"])


def _parameters(entry: dict[str, list[str]]) -> ControllerParameters:
    types = {name: kind for kind, names in entry.items() for name in names if kind not in _ROLES}
    return ControllerParameters(
        tuple(entry.get("required", ())), tuple(entry.get("positive", ())), types
    )
