"""Gazebo finds no plugin of this file name or class.

Gazebo does not find a library with exactly the name in `filename`, reports it among other messages
of its start, and continues without the plugin: the robot does not drive, the sensor does not
publish. A name similar to that of a known library is a warning, with a fix; a name with the same
words as a system of gz-sim, such as `libgz_diff_drive.so` for `gz-sim-diff-drive-system`, or with
the class of one, is a warning without a fix. Any other name is assumed to be a vendor's library: an
info.

In gz-sim the `name` of a plugin is the class in the library, not a free label as in Gazebo Classic.
With another name Gazebo writes "library does not contain requested plugin" and continues without
the plugin: an error; so is a class in `filename` and a library in `name`.

Sources:
    gazebo-classic, Plugin.hh: https://github.com/gazebosim/gazebo-classic/blob/gazebo11/gazebo/common/Plugin.hh
    gz-sim, SystemLoader.cc: https://github.com/gazebosim/gz-sim/blob/main/src/SystemLoader.cc
    Gazebo, system plugins: https://github.com/gazebosim/gz-sim/blob/main/tutorials/adding_system_plugins.md
    measured: half of the 66 plugins that 213 public models use are a vendor's
"""

import re

from urdfkit.lint.rules import Context, Finding, Findings, Fix, Need, Severity, rule
from urdfkit.robot.samples import robot_xml
from urdfkit.ros.catalog.plugins import (
    GENERATIONS,
    Plugin,
    all_plugins,
    find,
    misspelt,
    system_of_class,
    system_of_same_words,
)
from urdfkit.ros.gazebo.plugins import PluginUse
from urdfkit.ros.gazebo.samples import gazebo_xml, solid_xml
from urdfkit.text.editing.edits import fix_value

BAD = robot_xml(
    solid_xml("base"), gazebo_xml('<plugin name="drive" filename="libgazebo_ros_planar_mvoe.so"/>')
)
FIXED = GOOD = BAD.replace("mvoe", "move")


@rule(
    Severity.INFO,
    needs=(Need.MODEL, Need.GAZEBO),
    help="if it is a vendor's, add its package to your dependencies",
)
def check(context: Context) -> Findings:
    reported: set[str] = set()
    for use in context.plugins:
        if use.known:
            yield from _unknown_class(use)
        elif not use.filename:
            continue  # GAZ010
        elif "::" in use.filename and "::" not in use.name:
            message = f"the filename of plugin '{use.filename}' is a class, its name a library"
            help = f'write filename="{use.name}" name="{use.filename}"'
            at = use.at.attributes["filename"]
            yield Finding(at, message, help, severity=Severity.ERROR)
        elif suggested := misspelt(use.filename):
            successor = _successor(suggested, context.targets.names)
            finding = _misspelt(use, successor or suggested)
            yield finding._replace(fix=None) if successor else finding
        elif system := (
            system_of_class(use.filename, use.name) or system_of_same_words(use.filename)
        ):
            # Its class has another name as well, so that there is no fix.
            yield _misspelt(use, system)._replace(fix=None)
        elif use.filename not in reported:
            reported.add(use.filename)  # one robot may use a library a hundred times
            message = f"unknown plugin library '{use.filename}'"
            yield Finding(use.at.attributes["filename"], message)


def _successor(library: str, targets: tuple[str, ...]) -> str:
    """What the targets load instead of a library of the other ROS or Gazebo; empty if that."""
    loaded = {name for target in targets for name in GENERATIONS.get(target, ())}
    if not loaded or _loads(loaded, library):
        return ""
    return next((p.successor for p in find(library) if _loads(loaded, p.successor or "")), "") or ""


def _loads(generations: set[str], library: str) -> bool:
    return any(p.generation in generations and not p.removed for p in find(library))


def _misspelt(use: PluginUse, suggested: str) -> Finding:
    at = use.at.attributes["filename"]
    message = f"{use.title}: unknown plugin library"
    help = f"did you mean '{suggested}'?"
    # Without a tag that such a library reads, it may be a vendor's library.
    is_read = any(plugin.reads(item.path) for plugin in find(suggested) for item in use.items)
    fix = fix_value(at, suggested) if is_read or not use.items else None
    return Finding(at, message, help, fix, group_key=suggested, severity=Severity.WARNING)


def _unknown_class(use: PluginUse) -> Findings:
    classes = [_class_of(plugin, use) for plugin in use.known if plugin.class_name]
    name = use.at.attributes.get("name")
    if not classes or not use.name or name is None:
        return  # GAZ010
    if _current_name(use.name) not in map(_current_name, classes):
        message = f"{use.title}: the library has no class '{use.name}', only {' or '.join(classes)}"
        help, fix = f'write name="{classes[0]}"', fix_value(name, classes[0])
        if others := [p for p in all_plugins() if p.class_name == _current_name(use.name)]:
            help += f', or filename="{others[0].files[0]}"'
            fix = _fix_of_two(use, others[0], fix)
        yield Finding(name, message, help, fix, severity=Severity.ERROR)


def _fix_of_two(use: PluginUse, other: Plugin, fix: Fix | None) -> Fix | None:
    """Corrects the name of the class or the library; None if the tags match both, or neither.

    Args:
        other: the library that contains the class in ``name``.
        fix: the fix that writes the class of the library.
    """
    unread = min(len(use.unread(plugin)) for plugin in use.known)
    unread_by_other = len(use.unread(other))
    if unread == unread_by_other:
        return None
    is_right = unread < unread_by_other
    return fix if is_right else fix_value(use.at.attributes["filename"], other.files[0])


def _class_of(plugin: Plugin, use: PluginUse) -> str:
    """By the file name: a library of Fortress has a class of Fortress."""
    return plugin.fortress_class if "ignition" in use.filename else plugin.class_name


def _current_name(name: str) -> str:
    """A class by its current name: Fortress had other words, and may have a version."""
    return re.sub(r"::v\d+\b", "", name.replace("ignition::gazebo", "gz::sim"))
