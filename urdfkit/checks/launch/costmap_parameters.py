"""Parameters of Nav2's costmaps: their plugins, the classes of these, and what layers listen to.

Sources: ``costmap_plugins.xml`` and ``obstacle_layer.cpp`` of nav2_costmap_2d (humble to rolling).
"""

import re

from urdfkit.core.suggest import did_you_mean, nearest
from urdfkit.lint.rules import Finding, Findings, Location, Severity
from urdfkit.ros.launch.node_parameters import NodeParameters
from urdfkit.text.located_yaml import Node, Value, mapping, scalars

COSTMAPS = ("local_costmap", "global_costmap")
#: Lists of plugins, each with the value that needs no parameters.
_PLUGINS = {
    "plugins": ["static_layer", "obstacle_layer", "inflation_layer"],
    "filters": [],
    "controller_plugins": ["FollowPath"],
    "planner_plugins": ["GridBased"],
}
_PACKAGE = "nav2_costmap_2d"
_LAYERS = (
    "BinaryFilter", "DenoiseLayer", "InflationLayer", "KeepoutFilter", "ObstacleLayer",
    "PluginContainerLayer", "RangeSensorLayer", "SpeedFilter", "StaticLayer", "VoxelLayer",
)  # fmt: skip
#: Plugins of the servers, as classes of C++.
_SERVERS = {
    "planner_server": (
        "nav2_navfn_planner::NavfnPlanner", "nav2_smac_planner::SmacPlanner2D",
        "nav2_smac_planner::SmacPlannerHybrid", "nav2_smac_planner::SmacPlannerLattice",
        "nav2_theta_star_planner::ThetaStarPlanner",
    ),
    "controller_server": (
        "dwb_core::DWBLocalPlanner", "nav2_controller::PoseProgressChecker",
        "nav2_controller::PositionGoalChecker", "nav2_controller::SimpleGoalChecker",
        "nav2_controller::SimpleProgressChecker", "nav2_controller::StoppedGoalChecker",
        "nav2_graceful_controller::GracefulController", "nav2_mppi_controller::MPPIController",
        "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController",
        "nav2_rotation_shim_controller::RotationShimController",
        "teb_local_planner::TebLocalPlannerROS",
    ),
}  # fmt: skip
_KIND = r"(Layer|Filter)s?$"
_DATA = ("LaserScan", "PointCloud2")


def plugins(node: NodeParameters) -> Findings:
    """What a node lists and gives no parameters; classes and sources that Nav2 does not know."""
    for key, defaults in _PLUGINS.items():
        if key in ("plugins", "filters") and node.name not in COSTMAPS:
            continue
        listed = scalars(node.values.get(key))
        if [one.text for one in listed] == defaults:
            continue
        sections = {name for name, value in node.values.items() if isinstance(value, dict)}
        for one in listed:
            if one.text not in sections and f"{one.text}.plugin" not in node.values:
                yield Finding(
                    Location(one.span),
                    f"'{node.name}': no parameters for '{one.text}' of {key}"
                    f"{did_you_mean(one.text, sections)}",
                    f"add {one.text} with its plugin, or fix the name",
                )
    for layer in node.values.values():
        if isinstance(layer, dict):
            yield from _sources(layer)
            if node.name in COSTMAPS:
                yield from _layer(layer)


def misspelt_servers(node: NodeParameters) -> Findings:
    """Planners, controllers and checkers of Nav2 that are misspelt; their parts differ by age."""
    for section in node.values.values() if node.name in _SERVERS else ():
        named = mapping(section).get("plugin")
        text = named.text.replace("/", "::") if isinstance(named, Value) else ""
        meant = nearest(text, _SERVERS[node.name], 0.9)
        if meant and meant != text and isinstance(named, Value):
            meant = meant.replace("::", "/") if "/" in named.text else meant
            hint = f"unknown plugin '{named.text}'; did you mean '{meant}'?"
            at = Location(named.span)
            yield Finding(at, hint, f"write {meant}", severity=Severity.WARNING)


def misplaced(node: NodeParameters) -> Findings:
    """The parameters of a costmap that are not below its name twice: it is its own namespace."""
    is_nested = node.name in node.namespace.split("/") or "*" in node.namespace
    if node.name in COSTMAPS and not is_nested and "robot_base_frame" in node.values:
        yield Finding(
            Location(node.at),
            f"the parameters of '{node.name}' are not read: the node is '{node.name}/{node.name}'",
            f"write {node.name} twice, the second below the first",
        )


def _sources(layer: dict[str, Node]) -> Findings:
    given = layer.get("observation_sources")
    sections = {name for name, value in layer.items() if isinstance(value, dict)}
    for name in given.text.split() if isinstance(given, Value) else ():
        if isinstance(given, Value) and name not in sections:
            yield Finding(
                Location(given.span),
                f"observation source '{name}' has no parameters{did_you_mean(name, sections)}",
                f"add {name} with its topic and data_type, or fix the name",
                severity=Severity.WARNING,
            )


def _layer(layer: dict[str, Node]) -> Findings:
    """A class of a layer that is misspelt, and messages that an obstacle layer does not take."""
    named = layer.get("plugin")
    if not isinstance(named, Value):
        return
    package, _, name = re.sub("::|/", " ", named.text).partition(" ")
    kinds = {re.sub(_KIND, "", one): one for one in _LAYERS}
    near = nearest(re.sub(_KIND, "", name), kinds, 0.75) or ""
    meant = kinds.get(near) if nearest(package, (_PACKAGE,), 0.7) else None
    if meant and named.text != f"{_PACKAGE}::{meant}":
        hint = f"'{named.text}'; did you mean '{_PACKAGE}::{meant}'?"
        yield Finding(Location(named.span), f"unknown layer {hint}", f"write {_PACKAGE}::{meant}")
    for source in layer.values() if meant in ("ObstacleLayer", "VoxelLayer") else ():
        kind = mapping(source).get("data_type")
        if isinstance(kind, Value) and kind.text not in _DATA:
            yield Finding(
                Location(kind.span),
                f"the costmap stops at data_type '{kind.text}'{did_you_mean(kind.text, _DATA)}",
                f"write {' or '.join(_DATA)}",
            )
