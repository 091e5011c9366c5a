"""ros_control and ros2_control: contents of their blocks, and parameters with joint names."""

from __future__ import annotations

from functools import cache

from urdfkit.core.record import Record
from urdfkit.core.static_typing import Any
from urdfkit.ros.catalog import data, record


class ControlTag(Record):
    """A tag in ``<ros2_control>``."""

    #: attributes and children: valid names.
    attributes: tuple[str, ...]
    children: tuple[str, ...]
    required: frozenset[str]  # names of required attributes and children


class Hardware(Record):
    """A hardware plugin of a simulator."""

    name: str  # the class, as ``<plugin>`` writes it
    simulator: str  # its name in messages
    control: str  # the control plugin that loads it
    commands: tuple[str, ...]  # the only command interfaces that its joints have


class Measure(Record):
    """A parameter of a controller that repeats a dimension of the model."""

    parameter: str
    #: ``radius``, ``separation`` (of two sides, along the axle), ``track`` (of the joints in one
    #: list, along the axle), ``wheelbase`` (of two axles) or ``projection`` (half of the distances
    #: of two wheels on a diagonal along x and y, as of a mecanum drive). In metres.
    kind: str
    sides: tuple[tuple[str, ...], ...]  # parameters with joint names, for each side or axle


class ControllerType(Record):
    """A type of controller."""

    joints: tuple[str, ...]  # parameters with joint names
    measures: tuple[Measure, ...]  # parameters with lengths
    interface: str = ""  # the command interface that each joint requires; empty if it differs
    interfaces: str = ""  # the parameter with command interfaces; empty if missing


def words(subject: str, kind: str) -> list[str]:
    """Names that ros_control or ros2_control defines.

    Args:
        subject: ``transmission`` (of ROS 1) or ``interfaces`` (of ROS 2).
        kind: ``types``, ``interfaces``, ``gazebo``, ``unprefixed`` for the first; ``joint``,
            ``imu``, ``force_torque`` for the second.
    """
    return list(data("ros_control")[subject][kind])


def mock_parameters() -> list[str]:
    """The parameters of mock hardware, also former ones."""
    return str(data("ros_control")["mock"]).split()


def component_types() -> list[str]:
    return list(data("ros_control")["types"])


@cache
def grammar() -> dict[str, ControlTag]:
    """The tags in ``<ros2_control>``, by name."""
    return {name: _tag(entry) for name, entry in data("ros_control")["grammar"].items()}


def since(tag: str, part: str) -> str:
    """The first distribution that reads a child (``/group``) or attribute (``@mimic``) of a tag.

    Empty if all distributions read it.
    """
    return str(data("ros_control")["since"].get(tag + part, ""))


def _tag(entry: dict[str, list[str]]) -> ControlTag:
    attributes, children = entry["attributes"], entry["children"]
    return ControlTag(
        tuple(name.rstrip("!") for name in attributes),
        tuple(name.rstrip("!") for name in children),
        frozenset(name[:-1] for name in (*attributes, *children) if name.endswith("!")),
    )


@cache
def simulated_hardware() -> dict[str, Hardware]:
    entries = data("ros_control")["hardware"]
    return {name: record(Hardware, entry, name=name) for name, entry in entries.items()}


def control_plugin_libraries() -> dict[str, str]:
    """The library or class that Gazebo loads, by the name of the control plugin."""
    return {name: entry["load"] for name, entry in data("ros_control")["control"].items()}


def control_plugin(filename: str) -> str | None:
    """The control plugin of a ``filename``, with or without ``lib`` and ``.so``."""
    stem = filename.rpartition("/")[2].removesuffix(".so").removeprefix("lib")
    known: dict[str, Any] = data("ros_control")["control"]
    return next((name for name, entry in known.items() if stem in entry["files"]), None)


@cache
def controller_types() -> dict[str, ControllerType]:
    """The types of controller that have parameters with joint names."""
    entries = data("ros_control")["controllers"]
    return {
        name: record(ControllerType, entry, measures=_measures(entry.get("geometry", ())))
        for name, entry in entries.items()
    }


def _measures(rows: list[Any]) -> tuple[Measure, ...]:
    return tuple(
        Measure(parameter, kind, tuple(map(tuple, sides))) for parameter, kind, *sides in rows
    )


def parameters(controller: str) -> list[str]:
    """Names of the parameters of a type of controller; empty if not all are known."""
    return list(data("ros_control")["controllers"].get(controller, {}).get("parameters", []))
