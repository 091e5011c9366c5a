"""The Gazebo plugins of a model, with the catalogue entries of their libraries."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from functools import cached_property

from urdfkit.core.record import Record
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.ros.catalog.plugins import GENERATIONS, REFERENCES, Parameter, Plugin, find

if TYPE_CHECKING:
    from urdfkit.robot.model import RobotModel
    from urdfkit.ros.gazebo.conversion import SdfConversion
    from urdfkit.ros.targets import Targets
    from urdfkit.text.document import Attribute, Element

#: Blocks of ROS 2 whose tags are not all catalogued.
_FREE = ("ros/qos", "ros/parameter")

_CLASSIC = ("classic-ros1", "classic-ros2")
#: Packages whose libraries are all catalogued, for ROS 1 and ROS 2.
_GAZEBO_ROS = ("gazebo_plugins", "gazebo_ros", "gazebo_ros_control", "gazebo_ros2_control")


class PluginParameter(Record):
    """A tag or an attribute in a plugin."""

    path: str  # from the plugin, such as ``leftJoint`` or ``wheel/@link_name``
    at: Element | Attribute  # the element or attribute
    text: str  # value, without surrounding white space


class Reference(Record):
    """A name of a link or joint that a plugin looks up in the simulated model."""

    parameter: Parameter
    item: PluginParameter
    name: str

    @property
    def kind(self) -> str:
        """``link`` or ``joint``."""
        return "link" if self.parameter.type == "link" else "joint"


class PluginUse:
    """A ``<plugin>`` of a model."""

    def __init__(self, at: Element, block: Element, wanted: Collection[str]) -> None:
        self.at = at  # its element
        self.block = block  # the ``<gazebo>`` that it is in
        #: Plugins with its file name, one for each generation; empty if unknown.
        self.known = find((at.get("filename") or "").strip())
        #: The known plugins that a target Gazebo loads; a robot may have several targets.
        self.candidates = [
            plugin
            for plugin in self.known
            if not plugin.removed and (plugin.generation in wanted or not wanted)
        ]
        #: The candidate that reads most of the tags, or None.
        self.plugin = self._best()

    def _best(self) -> Plugin | None:
        if len(self.candidates) < 2:
            return self.candidates[0] if self.candidates else None
        return min(self.candidates, key=lambda plugin: len(self.unread(plugin)))

    @property
    def filename(self) -> str:
        return (self.at.get("filename") or "").strip()

    @property
    def name(self) -> str:
        return self.at.get("name") or ""

    @property
    def title(self) -> str:
        return f"plugin '{self.name}' ({self.filename or 'without filename'})"

    @property
    def outcome(self) -> str:
        """Effect of a missing link or joint, as the end of a message; empty if unknown."""
        return f": {self.plugin.missing}" if self.plugin and self.plugin.missing else ""

    @property
    def place(self) -> str:
        """``model``, ``link`` (a block with a reference), or the tag of its parent."""
        assert self.at.parent is not None
        if self.at.parent is not self.block:
            return self.at.parent.tag
        return "link" if self.block.get("reference") else "model"

    @cached_property
    def items(self) -> tuple[PluginParameter, ...]:
        """All its tags and attributes, outer tags before inner tags."""
        return tuple(self._items())

    def _items(self) -> Iterator[PluginParameter]:
        stack = [("", child) for child in reversed(self.at.children)]
        while stack:
            path, element = stack.pop()
            path += element.tag
            yield PluginParameter(path, element, element.text.strip())
            for attribute in element.attributes.values():
                yield PluginParameter(
                    f"{path}/@{attribute.name}", attribute, attribute.value.strip()
                )
            stack += [(f"{path}/", child) for child in reversed(element.children)]

    def values(self, path: str) -> list[PluginParameter]:
        return [item for item in self.items if item.path == path]

    def value(self, path: str) -> str:
        """The first value, else the default of its plugin; empty without a default."""
        values = self.values(path)
        if values:
            return values[0].text
        parameter = self.plugin.parameters.get(path) if self.plugin else None
        return (parameter.default or "") if parameter else ""

    def unread(self, plugin: Plugin) -> list[PluginParameter]:
        """Tags that a plugin does not read; only the outermost tag of an unknown block."""
        items: list[PluginParameter] = []
        closed = ""  # the contents of a tag follow the tag
        for item in self.items:
            if "@" in item.path or (closed and item.path.startswith(closed)):
                continue
            is_read = plugin.reads(item.path)
            if not is_read:
                items.append(item)
            closed = f"{item.path}/" if not is_read or item.path in _FREE else ""
        return items

    def references(self) -> Iterator[Reference]:
        """The links and joints that its plugin looks up, and their locations.

        A plugin that exists for one other Gazebo alone looks them up there.
        """
        only = self.known[0] if len(self.known) == 1 else None
        plugin = self.plugin or only
        parameters = plugin.parameters if plugin else {}
        for item in self.items:
            parameter = parameters.get(item.path)
            if parameter is None or parameter.type not in REFERENCES:
                continue
            names = [item.text]
            if parameter.type == "joints":
                names = item.text.replace(",", " ").split()
            for name in names:
                if name and name not in parameter.words and "::" not in name:
                    yield Reference(parameter, item, name)


def uses(model: RobotModel, targets: Targets) -> tuple[PluginUse, ...]:
    """Every plugin in the ``<gazebo>`` blocks of a model."""
    wanted = {name for target in targets.names for name in GENERATIONS.get(target, ())}
    return tuple(
        PluginUse(element, block, wanted)
        for block in model.gazebo
        for element in block.walk()
        if element.tag == "plugin" and _is_for_gazebo(element)
    )


def _is_for_gazebo(plugin: Element) -> bool:
    """False for the hardware plugin of a ``<ros2_control>`` inside a ``<gazebo>``."""
    return plugin.parent is not None and plugin.parent.tag not in ("hardware", "transmission")


def generations(use: PluginUse) -> set[str]:
    """The generations that may have a plugin's library; empty if the library is unknown.

    A library without ROS runs with ROS 1 and ROS 2, and a vendor's library for one of them may
    have a port to the other.
    """
    present = [plugin for plugin in use.known if not plugin.removed]
    names = {plugin.generation for plugin in present}
    ported = not any(plugin.package in _GAZEBO_ROS for plugin in use.known)
    if "classic" in names or (ported and not names.isdisjoint(_CLASSIC)):
        names.update(_CLASSIC)
    return names


def conversion_result(conversion: SdfConversion, kind: str, name: str) -> str:
    """Result of Gazebo's conversion for a link or joint.

    Returns:
        ``kept``, ``merged``, ``dropped``, ``unknown``, or ``other`` if it depends on facts that
        are not in the catalogue.
    """
    model = conversion.model
    if name in conversion.added:
        return "kept"
    if kind == "link":
        if name not in model.links_by_name:
            return "unknown"
        if name in conversion.dropped:
            return "dropped"
        survivor = conversion.survivor.get(name)
        return "other" if survivor is None else "kept" if survivor == name else "merged"
    joint = model.joints_by_name.get(name)
    if joint is None:
        return "unknown"
    if name in conversion.joint_names:
        return "kept"
    if joint.child_name in conversion.dropped:
        return "dropped"
    if joint.kind == "fixed" and joint.child_name in conversion.survivor:
        return "merged"
    return "other"
