"""Whether a name is misspelt where it is used, or where it is defined."""

from collections import Counter
from collections.abc import Iterator

from urdfkit.lint.context import Context
from urdfkit.robot.model import Joint, Link
from urdfkit.ros.ros_control import components, driven_joints
from urdfkit.text.diagnostic import Fix
from urdfkit.text.editing.edits import fix_value, from_macro


def corrected_definition(context: Context, defined: Link | Joint | None, name: str) -> Fix | None:
    """Rename what no other place calls by its name, where several agree on another one.

    Args:
        defined: the link or joint that an unknown name is like; None if there is none.
        name: the unknown name.
    """
    if defined is None or from_macro(defined.at):
        return None
    uses = Counter(_names(context, "link" if isinstance(defined, Link) else "joint"))
    if uses[defined.name] or uses[name] < 2:
        return None
    return fix_value(defined.at.attributes["name"], name)


def _names(context: Context, kind: str) -> Iterator[str]:
    """The names by which links, or joints, are called; each as often as it is written."""
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
        yield from (one.name for one in plugin.references() if one.kind == kind)
    if context.srdf:  # it repeats a name, which counts once
        yield from {name.value for other, name in context.srdf.references() if other == kind}
