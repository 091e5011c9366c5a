"""What a controller claims: command interfaces of joints, which one at a time may write."""

from urdfkit.ros.controllers import Controller
from urdfkit.text.located_yaml import Value

_BY_PACKAGE = {f"{kind}_controllers": kind for kind in ("position", "velocity", "effort")}


def commands(controller: Controller) -> list[str]:
    """The command interfaces that it needs of each joint; empty if that is not known."""
    if controller.ros == 1 and (kind := _BY_PACKAGE.get(controller.type.partition("/")[0])):
        return [kind]
    known = controller.kind
    if known is None:
        return []
    if known.interface:
        return [known.interface]
    named = controller.values([known.interfaces]) if known.interfaces else []
    return [value.text for value in named if value.text]


def commanded_joints(controller: Controller) -> list[Value]:
    """The joints that it commands; ``command_joints`` takes precedence over ``joints``."""
    kind = controller.kind
    commanded = controller.values(["command_joints"])
    return commanded or (controller.values(kind.joints) if kind else [])
