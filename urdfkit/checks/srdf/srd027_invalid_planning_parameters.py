"""Parameters of MoveIt's planning or sensors are missing, or have the form of another version.

- An octomap updater in `sensors_3d.yaml` lacks a parameter, such as `image_topic` (warning):
  move_group does not load it. Or the sensor has no settings, `sensors` is no list, or it is the
  list of settings that MoveIt 1 reads: launch stops.
- The Cartesian limits of Pilz's planner lack one (warning): "not fully set", and LIN and CIRC fail.
- The file of a planning pipeline is half of Humble, with `planning_plugin` and a text of adapters,
  and half of Jazzy, with `planning_plugins` and lists (warning). Or none of the adapters of OMPL
  computes the times of the trajectory, all of whose points then have the time 0 (warning).
- A file is not YAML: the launch file stops at it. Or `planning_plugins` of a pipeline is empty.
- `planner_configs` of a group is a single planner, not a list: move_group stops.
- A chain of fewer than six joints has the solver KDL without `position_only_ik` (info): goals that
  are poses fail.

Sources:
    MoveIt, OMPL: https://moveit.picknik.ai/main/doc/examples/ompl_interface/ompl_interface_tutorial.html
    MoveIt, kinematics: https://moveit.picknik.ai/main/doc/examples/kinematics_configuration/kinematics_configuration_tutorial.html
    moveit/moveit2#2140: https://github.com/moveit/moveit2/issues/2140
    MoveIt, planning_context_manager.cpp: https://github.com/moveit/moveit2/blob/main/moveit_planners/ompl/ompl_interface/src/planning_context_manager.cpp
    MoveIt, pointcloud_octomap_updater.cpp: https://github.com/moveit/moveit2/blob/main/moveit_ros/perception/pointcloud_octomap_updater/src/pointcloud_octomap_updater.cpp
    MoveIt, cartesian_limits_parameters.yaml: https://github.com/moveit/moveit2/blob/main/moveit_planners/pilz_industrial_motion_planner/src/cartesian_limits_parameters.yaml
"""

from __future__ import annotations

import os
import re

from urdfkit.core.paths import is_within
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.ros.catalog import data
from urdfkit.ros.gazebo.samples import SHOULDER
from urdfkit.ros.moveit.samples import configurations, named_xml
from urdfkit.ros.moveit.srdf import Srdf
from urdfkit.text.located_yaml import Node, Value, items, mapping, scalar, scalars
from urdfkit.workspace.launch_files import launch_files
from urdfkit.workspace.manifest import manifest_of

BAD = named_xml("bad", SHOULDER)
GOOD = BAD.replace('"bad"', '"good"')
FILES = configurations(
    "ompl_planning.yaml",
    "arm: {planner_configs: RRTConnectkConfigDefault}\n",
    "arm: {planner_configs: [RRTConnectkConfigDefault]}\n",
)

_KDL, _POSITION = "kdl_kinematics_plugin/KDLKinematicsPlugin", "position_only_ik"
#: The joints that a pose needs.
_OF_A_POSE = 6
_FIXED = ("fixed", "")
_SENSORS = "sensors_3d.yaml"
_CARTESIAN = "pilz_cartesian_limits.yaml"
_ADAPTERS = ("request_adapters", "response_adapters")
_OMPL = "ompl_interface/OMPLPlanner"  # other planners compute times themselves
#: Adapters that compute times, and those that certainly do not.
_TIMING, _OF_MOVEIT = re.compile(r"/Add(Time|Iterative)\w*Param"), "default_plann"


@rule(Severity.ERROR, needs=(Need.MODEL, Need.SRDF), reports_missing=True)
def check(context: Context) -> Findings:
    for at, reason in context.moveit_config.syntax_errors():
        yield Finding(at, f"invalid YAML: {reason}", "fix the file")
    yield from _sensors(context, context.required_srdf)
    yield from _cartesian_limits(context)
    yield from _pipelines(context)
    yield from _planners_of_groups(context)
    yield from _with_few_joints(context, context.required_srdf)


def _with_few_joints(context: Context, srdf: Srdf) -> Findings:
    """Chains of fewer than six joints for which KDL looks for whole poses."""
    for entry in context.moveit_config.group_entries():
        solver = scalar(entry.values, "kinematics_solver")
        is_kdl = solver is not None and solver.text == _KDL
        chains = [
            tag for group in srdf.groups_by_name.get(entry.name, ()) for tag in group.all("chain")
        ]
        if solver is None or not is_kdl or _POSITION in entry.values or len(chains) != 1:
            continue
        ends = (chains[0].get(key) or "" for key in ("base_link", "tip_link"))
        joints = srdf.joints_between(*ends) or []
        moved = [joint for joint in joints if joint.kind not in _FIXED and not joint.mimic]
        if 0 < len(moved) < _OF_A_POSE:
            yield Finding(
                solver.span,
                f"group '{entry.name}' has {len(moved)} joints: for almost all poses KDL finds no "
                "solution",
                f"add {_POSITION}: true to reach positions in any orientation",
                severity=Severity.INFO,
            )


def _sensors(context: Context, srdf: Srdf) -> Findings:
    """Sensors of the octomap that move_group does not load."""
    root = context.moveit_config.load(_SENSORS)
    listed = root.get("sensors")
    if isinstance(listed, Value) and listed.text:
        message, help = f"sensors is '{listed.text}', not a list", f"write [{listed.text}]"
        yield Finding(listed.span, message, help)
    for item in listed if isinstance(listed, list) and _loads_sensors(context, srdf) else ():
        written = scalar(item, "sensor_plugin")
        if written:
            message = (
                "sensors contains settings, but MoveIt 2 reads names of sections: launch stops"
            )
            help = "write sensors: [camera], and the settings below camera:"
            yield Finding(written.span, message, help)
    for name in scalars(listed):
        section = mapping(root, name.text)
        if name.text and not section:
            yield Finding(name.span, f"sensor '{name.text}' has no settings", "fix the name")
        plugin = section.get("sensor_plugin")
        updater = data("moveit")["updaters"].get(getattr(plugin, "text", ""))
        if updater is None or not isinstance(plugin, Value):
            continue
        required = updater["required"].split()
        missing = [key for key in required if key not in section]
        others = [key for key in section if key not in (*required, *updater["others"].split())]
        if missing:
            class_name = plugin.text.rpartition("/")[2]
            message = f"{class_name} has no {', '.join(missing)}"
            help = "add " + ", ".join(missing)
            if others:
                message += f"; it does not read {', '.join(others)}"
                help = f"add {', '.join(missing)}, or name the plugin that reads {others[0]}"
            yield Finding(plugin.span, message, help, severity=Severity.WARNING)


def _loads_sensors(context: Context, srdf: Srdf) -> bool:
    """True if launch files of ROS 2 load the sensors: by name, or with all files of the package."""
    resolver = context.resolver
    manifest = manifest_of(resolver, srdf.path)
    package = resolver.packages.enclosing(srdf.path)
    if manifest is None or manifest.ros != 2 or package is None:
        return False
    name, directory = package
    workspace = resolver.packages.workspace(srdf.path)
    return any(
        name.encode() in launch.data or is_within(os.path.abspath(launch.path), directory)
        for mentioned in (_SENSORS.partition(".")[0], "MoveItConfigsBuilder")
        for launch in launch_files(workspace, mentioned, resolver)
    )


def _cartesian_limits(context: Context) -> Findings:
    """A limit without which Pilz's planner plans no lines: "not fully set"."""
    root = context.moveit_config.load(_CARTESIAN)
    limits = mapping(root, "cartesian_limits")
    missing = [name for name in data("moveit")["cartesian_limits"].split() if name not in limits]
    for key, _ in items(root):
        if key == "cartesian_limits" and limits and missing:
            message = f"cartesian_limits has no {', '.join(missing)}: LIN and CIRC fail"
            help = "add " + ", ".join(missing)
            yield Finding(key.span, message, help, severity=Severity.WARNING)


def _pipelines(context: Context) -> Findings:
    """Files of pipelines that are half of Humble and half of Jazzy, or lack an adapter."""
    for root in context.moveit_config.pipelines():
        is_new = "planning_plugins" in root
        for key, value in items(root):
            if key == "planning_plugins" and (value == [] or _is_empty(value)):
                message = "planning_plugins is empty: the pipeline has no planner"
                yield Finding(key.span, message, f"write [{_OMPL}], or that of the pipeline")
            elif key in _ADAPTERS and is_new and isinstance(value, Value) and value.text:
                names = value.text.split()
                message = f"{key} is a text, but with planning_plugins (Jazzy) it is a list"
                help = f"write each on a line: - {names[0]}"
                yield Finding(key.span, message, help, severity=Severity.WARNING)
            elif key == _ADAPTERS[is_new or _has_lists(root)] and _are_untimed(root, value):
                message = "no adapter of OMPL computes times: all points have the time 0"
                package = "planner_request" if key == _ADAPTERS[0] else "planning_response"
                help = f"add default_{package}_adapters/AddTimeOptimalParameterization"
                yield Finding(key.span, message, help, severity=Severity.WARNING)
            elif key == "planning_plugin" and not is_new and _has_lists(root):
                message = "planning_plugin is of Humble, and the lists of adapters are of Jazzy"
                help = f"write planning_plugins: [{getattr(value, 'text', '')}]"
                yield Finding(key.span, message, help, severity=Severity.WARNING)


def _is_empty(node: Node | None) -> bool:
    return isinstance(node, Value) and not node.text


def _are_untimed(root: dict[str, Node], adapters: Node | None) -> bool:
    """True if OMPL has adapters of MoveIt alone, none of which computes times."""
    plugins = [root.get("planning_plugin"), *scalars(root.get("planning_plugins"))]
    written = [adapters] if isinstance(adapters, Value) else scalars(adapters)
    names = [name for value in written for name in value.text.split()]
    is_ompl = [getattr(plugin, "text", None) for plugin in plugins if plugin] == [_OMPL]
    are_known = bool(names) and all(name.startswith(_OF_MOVEIT) for name in names)
    return is_ompl and are_known and not any(map(_TIMING.search, names))


def _has_lists(root: dict[str, Node]) -> bool:
    return any(isinstance(root.get(key), list) for key in _ADAPTERS)


def _planners_of_groups(context: Context) -> Findings:
    """A single planner where a group has a list: move_group stops at the type."""
    for entry in context.moveit_config.group_entries():
        value = scalar(entry.values, "planner_configs")
        if value and value.text:
            message = f"planner_configs of group '{entry.name}' is not a list"
            yield Finding(value.span, message, f"write [{value.text}]")
