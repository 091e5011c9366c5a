"""A node of Nav2 cannot load a plugin: it has no parameters, or its class is unknown.

- A plugin in `plugins` or `filters` of a costmap has no parameters: "Can not get 'plugin' param
  value for voxel_layer". The same holds for `controller_plugins` and the other lists of Nav2, and
  for polygons, sources and docks. Humble does not read `navigators`. A source in
  `observation_sources` has no parameters (warning): the layer subscribes to a topic of that name.
- A planner or controller of Nav2 is misspelt (warning), lacks its critics or its primary
  controller, or has an unknown critic. The classes of plugins have names of different versions of
  Nav2 (warning).
- A costmap layer has an unknown class or an unsupported `data_type`.
- A filter of laser_filters is misspelt. A dock has a type that is not in `dock_plugins` (warning).

Sources:
    Nav2, costmap: https://docs.nav2.org/configuration/packages/configuring-costmaps.html
    Nav2, plugins: https://docs.nav2.org/plugins/index.html
    Nav2, critic_manager.cpp: https://github.com/ros-navigation/navigation2/blob/main/nav2_mppi_controller/src/critic_manager.cpp
    laser_filters: https://github.com/ros-perception/laser_filters
"""

import re

from urdfkit.checks.bringup.costmap_layers import sources_without_parameters, unknown_layer
from urdfkit.checks.bringup.costmaps import COSTMAPS, has_default_plugins
from urdfkit.checks.bringup.read_parameters import parameter_files, read_sections, whole_sections
from urdfkit.core.suggest import CLOSE_TYPO, TYPO, did_you_mean, nearest
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.known_parameters import plugin_class
from urdfkit.ros.launch.releases import is_of_older
from urdfkit.ros.launch.samples import nav2_launch
from urdfkit.ros.node_parameters import NodeParameters
from urdfkit.text.located_yaml import Key, Node, Value, items, mapping, scalar, scalars

NAME = "launch/navigation.launch.py"
BAD = nav2_launch("nav2_planner", "planner_server", '"../navigation.yaml"')
GOOD = BAD.replace("navigation.yaml", "sound.yaml")
_PLANNER = b"planner_server:\n  ros__parameters: {planner_plugins: [grid], grid: {plugin: %s}}\n"
FILES = {
    "navigation.yaml": _PLANNER % b"nav2_navfn_planner::NavfnPlaner",
    "sound.yaml": _PLANNER % b"nav2_navfn_planner::NavfnPlanner",
    "package.xml": b"<package><name>arm</name></package>",
}

_CRITICS = "critics"
#: The list that Humble does not read: its two navigators are no plugins.
_NAVIGATORS = "navigators"
#: Least similarity of a misspelt critic: ObstacleCritic is ObstaclesCritic.
_MIN_SIMILARITY = 0.8
#: A server of Humble and later, and the package of its plugins until then, and since.
_BEHAVIORS, _FORMER, _FORMER_IS = "behavior_server", "nav2_recoveries", "nav2_behaviors"
#: The classes with a slash up to Iron, and colons from Jazzy on.
_RENAMED = re.compile(
    r"nav2_(?:behaviors|bt_navigator|navfn_planner|smac_planner|theta_star_planner)(/|::)"
)


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    files = parameter_files(context)
    sections = read_sections(context)
    for section in sections:
        yield from _unknown_classes(section)
        yield from _laser_filters(section)
        yield from _docks(section)
    for section in whole_sections(sections):
        yield from _without_parameters(section)
        yield from _layers(section)
        yield from _names_without_section(section)
        for name, values in items(section.values):
            if kind := plugin_class(values):
                yield from _incomplete(section, name, kind, mapping(values))
    for own in files.values():
        yield from _mixed_names(own)


def _unknown_classes(node: NodeParameters) -> Findings:
    """Classes of plugins that their package does not have; ``/`` and ``::`` are accepted."""
    known: list[str] = data("nodes")["plugins"].split()
    packages = {name.partition("::")[0] for name in known}
    for section in node.values.values() if node.name not in COSTMAPS else ():
        plugin, name = scalar(section, "plugin"), plugin_class(section)
        if plugin and node.name == _BEHAVIORS and name.startswith(f"{_FORMER}::"):
            message = f"unknown plugin '{plugin.text}': Humble and later have no {_FORMER}"
            help = f"write {plugin.text.replace(_FORMER, _FORMER_IS)}"
            yield Finding(plugin.span, message, help, severity=Severity.WARNING)
            continue
        is_complete = name.partition("::")[0] in packages
        suggested = nearest(name, known, TYPO if is_complete else CLOSE_TYPO)
        if plugin is None or name in known or not (is_complete or suggested):
            continue
        hint = f"unknown plugin '{plugin.text}'"
        help = f"write a class that {name.partition('::')[0]} has"
        if suggested:
            suggested = suggested.replace("::", "/") if "/" in plugin.text else suggested
            hint, help = f"{hint}; did you mean '{suggested}'?", f"write {suggested}"
        yield Finding(plugin.span, hint, help, severity=Severity.WARNING)


def _laser_filters(node: NodeParameters) -> Findings:
    """Misspelt filters of laser_filters, at which the chain stops."""
    known = data("nodes")["laser_filters"].split()
    for section in node.values.values():
        kind = scalar(section, "type")
        package, _, name = (kind.text if kind else "").partition("/")
        if kind is None or package != "laser_filters" or name in known:
            continue
        if suggested := nearest(name, known):
            message = f"'{node.name}' stops: unknown filter '{kind.text}'; did you mean "
            message += f"'{package}/{suggested}'?"
            yield Finding(kind.span, message, f"write {package}/{suggested}")


def _docks(node: NodeParameters) -> Findings:
    """Docks of a type that is not among the plugins of the docking server."""
    types = [plugin.text for plugin in scalars(node.values.get("dock_plugins"))]
    for dock in scalars(node.values.get("docks")) if types else ():
        kind = scalar(node.values.get(dock.text), "type")
        if kind and kind.text not in types:
            message = f"dock '{dock.text}' has the type '{kind.text}', which dock_plugins lacks"
            help = f"write one of: {', '.join(types)}"
            message += did_you_mean(kind.text, types)
            yield Finding(kind.span, message, help, severity=Severity.WARNING)


def _without_parameters(node: NodeParameters) -> Findings:
    """Plugins in a list that have no section."""
    sections = {name for name, value in node.values.items() if isinstance(value, dict)}
    for key, defaults in data("nodes")["lists"].items():
        if key in ("plugins", "filters") and node.name not in COSTMAPS:
            continue
        is_unread = key == _NAVIGATORS and is_of_older(node.at.source)
        if is_unread or has_default_plugins(node, key, defaults):
            continue
        for plugin in scalars(node.values.get(key)):
            if f"{plugin.text}.plugin" in node.values:
                continue
            if plugin.text not in sections:
                yield _without_section(node, plugin, key, sections, "its plugin")
            elif "plugin" not in mapping(node.values[plugin.text]):
                message = f"'{node.name}' stops: '{plugin.text}' of {key} has no plugin"
                yield Finding(plugin.span, message, f"add plugin: CLASS to {plugin.text}")


def _layers(node: NodeParameters) -> Findings:
    """Unknown layers of costmaps, and observation sources without parameters."""
    for layer in node.values.values():
        if isinstance(layer, dict):
            yield from sources_without_parameters(layer)
            if node.name in COSTMAPS:
                yield from unknown_layer(layer)


def _names_without_section(node: NodeParameters) -> Findings:
    """Names in a list of a node that has no section for them."""
    named: dict[str, str] = data("node_parameters")["sections"].get(node.name, {})
    sections = {str(key) for key, value in node.values.items() if isinstance(value, dict)}
    for key, default in named.items():
        value = node.values.get(key)
        for name in [value] if isinstance(value, Value) else scalars(value):
            is_given = name.text in sections or any(
                parameter.startswith(f"{name.text}.") for parameter in node.values
            )
            if name.text and name.text != default and not is_given and "$" not in name.text:
                yield _without_section(node, name, key, sections, "its parameters")


def _without_section(
    node: NodeParameters, name: Value, key: str, sections: set[str], content: str
) -> Finding:
    return Finding(
        name.span,
        f"'{node.name}': no parameters for '{name.text}' of {key}"
        f"{did_you_mean(name.text, sections)}",
        f"add {name.text} with {content}, or fix the name",
    )


def _incomplete(node: NodeParameters, name: Key, kind: str, section: dict[str, Node]) -> Findings:
    for parameter in data("node_parameters")["required_of_plugins"].get(kind, "").split():
        if not any(key == parameter or key.startswith(f"{parameter}.") for key in section):
            message = f"'{node.name}' stops: {kind} requires {parameter}, which '{name}' lacks"
            yield Finding(name.span, message, f"add {parameter}")
    known = data("node_parameters")["critics"].get(kind, "").split()
    for critic in scalars(section.get(_CRITICS)) if known else ():
        own = mapping(section.get(critic.text)).get("class")
        bare = critic.text.rpartition("/" if "/" in critic.text else "::")[2]
        suggested = bare if bare in known else nearest(bare, known, _MIN_SIMILARITY)
        if own is None and critic.text not in _with_suffix(known) and suggested:
            message = f"'{node.name}' stops: unknown critic '{critic.text}'; did you mean "
            yield Finding(critic.span, f"{message}'{suggested}'?", f"write {suggested}")
    listed = {value.text for value in scalars(section.get(_CRITICS))}
    for key, value in items(section) if known else ():
        suggested = nearest(key, listed - section.keys(), TYPO)
        if isinstance(value, dict) and key not in known and suggested:
            message = f"'{node.name}': the parameters of '{key}' are not read: the critic is "
            yield Finding(
                key.span, f"{message}'{suggested}'", f"write {suggested}", severity=Severity.WARNING
            )


def _with_suffix(critics: list[str]) -> set[str]:
    """The critics with and without their suffix: DWB adds it."""
    return {*critics, *(f"{critic}Critic" for critic in critics)}


def _mixed_names(sections: list[NodeParameters]) -> Findings:
    """Classes that Nav2 renamed in Jazzy, from ``package/Class`` to ``package::Class``, mixed."""
    found: dict[str, list[Value]] = {"/": [], "::": []}
    for node in sections:
        for section in node.values.values():
            plugin = scalar(section, "plugin")
            if plugin and (match := _RENAMED.match(plugin.text)):
                found[match.group(1)].append(plugin)
    old, new = found["/"], found["::"]
    if old and new:
        fewer, sign = (old, "::") if len(old) <= len(new) else (new, "/")
        other = (new if fewer is old else old)[0].text
        yield Finding(
            fewer[0].span,
            f"plugin '{fewer[0].text}' has a name of "
            f"{'Iron and before' if fewer is old else 'Jazzy and later'}, unlike '{other}'",
            f"write {re.sub('/|::', sign, fewer[0].text)}",
            severity=Severity.WARNING,
        )
