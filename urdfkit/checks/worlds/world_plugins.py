"""Plugins of a world that the started Gazebo does not load.

Sources: ``SystemLoader.cc`` of gz-sim: `filename` is the library and `name` the class, and a plugin
of which either does not exist is reported once and not loaded.
"""

import re

from urdfkit.checks.worlds.opened_worlds import OpenedWorld
from urdfkit.lint.rules import Finding, Findings, Severity
from urdfkit.ros.catalog.plugins import TITLES, find, misspelt, system_of_class
from urdfkit.ros.gazebo.worlds import World
from urdfkit.ros.launch.worlds import GZ
from urdfkit.text.document import Element

#: Gazebo Classic and gz-sim.
_TITLES = ("Gazebo Classic", TITLES[GZ])
#: Libraries that only Gazebo Classic has.
_CLASSIC = re.compile(r"(lib)?gazebo_ros_\w+(\.so)?$")


def unloaded_plugins(opened: OpenedWorld, world: World) -> Findings:
    """All plugins if they are for the other Gazebo, otherwise each one that is not loaded."""
    yield from _other_gazebo(opened, world) or _plugins(opened, world)


def _other_gazebo(opened: OpenedWorld, world: World) -> list[Finding]:
    """A world whose plugins are all for the other Gazebo, so that the wrong Gazebo is started."""
    is_gz = opened.started.generation == GZ
    kinds = [_generations(plugin) for plugin in world.plugins]
    if len(kinds) < 2 or any(kind != {not is_gz} for kind in kinds):
        return []
    other, own = _TITLES[not is_gz], _TITLES[is_gz]
    message = f"{opened.title} is for {other}, but is started in {own}, which loads none of its "
    message += f"{len(kinds)} plugins"
    help = f"start it in {other}, or name a world for {own}"
    return [Finding(opened.started.at, message, help, severity=Severity.WARNING)]


def _generations(plugin: Element) -> set[bool]:
    """Whether a plugin is for gz sim: both values if both have it, empty if it is unknown."""
    file = (plugin.get("filename") or "").strip()
    generations = {known.generation == GZ for known in find(file)}
    return generations or ({False} if _CLASSIC.match(file) else set())


def _plugins(opened: OpenedWorld, world: World) -> Findings:
    is_gz = opened.started.generation == GZ
    for plugin in world.plugins:
        at = plugin.attributes.get("filename")
        file = (at.value if at else "").strip()
        is_of_gz = _generations(plugin)
        title = f"plugin '{plugin.get('name') or ''}' ({file})"
        suggested = misspelt(file) or system_of_class(file, plugin.get("name") or "")
        if at is not None and not is_of_gz and suggested:
            message = f"{title}: unknown plugin library"
            help = f"did you mean '{suggested}'?"
            yield Finding(at, message, help)
        elif at is not None and is_of_gz and is_gz not in is_of_gz:
            other, own = _TITLES[not is_gz], _TITLES[is_gz]
            yield Finding(
                at,
                f"{title} is for {other}, but {opened.title} is started in {own}: it is not loaded",
                "remove it",
                group_key=opened.path,
                severity=Severity.WARNING,
            )
        elif is_gz:
            yield from _classes(opened, plugin, title)


def _classes(opened: OpenedWorld, plugin: Element, title: str) -> Findings:
    """A class that the library does not have."""
    name = plugin.attributes.get("name")
    known = find((plugin.get("filename") or "").strip())
    classes = [plugin.class_name for plugin in known if plugin.generation == GZ]
    written = re.sub(r"::v\d+\b", "", name.value if name else "")
    if name is None or not classes or not all(classes):
        return
    if written.replace("ignition::gazebo", "gz::sim") not in classes:
        message = f"{title}: the library has no class '{name.value}', only {' or '.join(classes)}"
        yield Finding(name, message, f'write name="{classes[0]}"')
