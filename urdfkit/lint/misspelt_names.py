"""Corrections of names that are misspelt in their definition, not in their uses."""

from collections import Counter
from collections.abc import Iterator

from urdfkit.lint.context import Context
from urdfkit.robot.joint import Joint
from urdfkit.robot.link import Link
from urdfkit.ros.ros_control import components, driven_joints
from urdfkit.text.diagnostic import Fix
from urdfkit.text.editing.edits import fix_value, from_macro


def corrected_definition(context: Context, defined: Link | Joint | None, name: str) -> Fix | None:
    """A fix that renames an unreferenced link or joint to a name that several places reference.

    Args:
        defined: the link or joint whose name resembles the unknown name; None if there is none.
        name: the unknown name.
    """
    if defined is None or from_macro(defined.at):
        return None
    uses = Counter(_names(context, "link" if isinstance(defined, Link) else "joint"))
    if uses[defined.name] or uses[name] < 2:
        return None
    return fix_value(defined.at.attributes["name"], name)


def _names(context: Context, kind: str) -> Iterator[str]:
    """All references to link or joint names, with repetitions."""
    model = context.model
    for joint in model.joints:
        if kind == "link":
            yield from (end.value for end in (joint.parent, joint.child) if end)
        elif joint.mimic:
            yield joint.mimic.at.get("joint") or ""
    if kind == "joint":
        for component in components(model):
            yield from (joint.name for joint in component.joints)
        yield from (element.get("name") or "" for element, _ in driven_joints(model.transmissions))
    yield from (block.get("reference") or "" for block in model.gazebo)
    for plugin in context.plugins:
        yield from (reference.name for reference in plugin.references() if reference.kind == kind)
    if context.srdf:  # counts a name once, as an SRDF repeats names
        yield from {name.value for other, name in context.srdf.references() if other == kind}
