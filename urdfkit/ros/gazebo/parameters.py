"""Tags that a plugin does not read, and why."""

from __future__ import annotations

from urdfkit.core.record import Record
from urdfkit.core.suggest import Suggester
from urdfkit.ros.catalog.plugins import Plugin, often_unread, renames
from urdfkit.ros.gazebo.plugins import PluginParameter, PluginUse


class UnreadParameter(Record):
    """A tag that a plugin does not read."""

    item: PluginParameter  # the tag
    other: Plugin | None  # the plugin of another generation that reads it, or None
    suggested: str | None  # the tag that it is probably a typo of, or None


def unread(use: PluginUse) -> list[UnreadParameter]:
    """Tags that a plugin does not read; empty for an unknown plugin.

    Superfluous tags in shipped examples are ignored.
    """
    plugin = use.plugin
    if plugin is None or not plugin.parameters:
        return []
    unread_items = use.unread(plugin)
    if not unread_items:
        return []
    common = {name for names in often_unread().values() for name in names}
    written = {item.path for item in use.items}
    suggester = Suggester([name for name in plugin.parameters if name not in written])
    tags: list[UnreadParameter] = []
    for item in unread_items:
        other = _other(use, plugin, item)
        suggested = None if "/" in item.path else suggester.suggested(item.path) or None
        is_cut_short = suggested is not None and suggested.startswith(
            item.path
        )  # updateRate(HZ) of an IMU
        if other is None and item.path in common and not is_cut_short:
            continue
        tags.append(
            UnreadParameter(item, other, suggested if suggested and "/" not in suggested else None)
        )
    return tags


def _other(use: PluginUse, plugin: Plugin, item: PluginParameter) -> Plugin | None:
    """The plugin of another generation that reads a tag."""
    for candidate in use.known:
        if (
            candidate.generation != plugin.generation
            and not candidate.removed
            and candidate.reads(item.path)
        ):
            return candidate
    new_name = renames().get(item.path)
    if plugin.generation == "classic-ros2" and new_name and plugin.reads(new_name):
        return next(
            (candidate for candidate in use.known if candidate.generation == "classic-ros1"), None
        )
    return None
