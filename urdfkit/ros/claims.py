"""Command interfaces of joints that a controller claims exclusively."""

from urdfkit.ros.controllers import Controller
from urdfkit.text.located_yaml import Value

_BY_PACKAGE = {f"{kind}_controllers": kind for kind in ("position", "velocity", "effort")}


def commands(controller: Controller) -> list[str]:
    """The command interfaces that a controller requires of each joint; empty if unknown."""
    if controller.ros == 1 and (kind := _BY_PACKAGE.get(controller.type.partition("/")[0])):
        return [kind]
    known = controller.kind
    if known is None:
        return []
    if known.interface:
        return [known.interface]
    named = controller.values([known.interfaces]) if known.interfaces else []
    return [value.text for value in named if value.text]


def claims(controller: Controller) -> list[tuple[list[str], list[Value]]]:
    """The command interfaces that a controller requires, with their joints."""
    if not controller.type.endswith("SteeringController"):
        return [(commands(controller), commanded_joints(controller))]
    drives_front = any(
        value.text.lower() == "false" for value in controller.values(["front_steering"])
    )
    steered, driven = ("rear", "front") if drives_front else ("front", "rear")
    return [
        (["position"], controller.values(["steering_joints_names", f"{steered}_wheels_names"])),
        (["velocity"], controller.values(["traction_joints_names", f"{driven}_wheels_names"])),
    ]


def commanded_joints(controller: Controller) -> list[Value]:
    """The joints that a controller commands; ``command_joints`` overrides ``joints``."""
    kind = controller.kind
    commanded = controller.values(["command_joints"])
    return commanded or (controller.values(kind.joints) if kind else [])
