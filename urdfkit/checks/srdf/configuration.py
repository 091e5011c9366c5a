"""Unknown names in MoveIt's YAML files."""

import os
import re

from urdfkit.core.suggest import CLOSE_TYPO, TYPO, Suggester, did_you_mean, nearest
from urdfkit.core.words import few
from urdfkit.lint.rules import Context, Finding, Findings, Severity
from urdfkit.ros.catalog import data
from urdfkit.ros.moveit.config import MANAGER
from urdfkit.ros.moveit.joint_limits import planned_limits
from urdfkit.ros.moveit.srdf import Srdf
from urdfkit.ros.moveit.srdf_variant import names_of_other_robots
from urdfkit.ros.ros_control import ROS1
from urdfkit.text.located_yaml import scalar

#: The plugins of IKFast are named after the robot.
_OF_ROBOTS = "IKFast"
#: The controller manager whose settings are checked.
_OF_MOVEIT = "moveit_simple_controller_manager/MoveItSimpleControllerManager"
#: The name of Pilz's planner in MoveIt 1.
_PILZ_OF_ROS1 = "pilz_industrial_motion_planner::CommandPlanner"

#: The package of the adapters up to Iron.
_ADAPTERS_OF_HUMBLE = "default_planner_request_adapters"

#: A projection on joints.
_PROJECTION = re.compile(r"joints\(([^()$]*)\)")
#: Most groups that a help names.
_MAX_NAMED = 8


def unknown_names(context: Context, srdf: Srdf) -> Findings:
    """The unknown joints, groups, controllers and solvers in the configuration files."""
    yield from _joint_limits(context, srdf)
    yield from _groups(context, srdf)
    yield from _solvers(context, srdf)
    yield from _planners(context)
    yield from _planning_plugins(context)
    yield from _adapters(context)
    yield from _projections(context, srdf)
    yield from _controllers(context, srdf)


def _joint_limits(context: Context, srdf: Srdf) -> Findings:
    known = context.model.joints_by_name
    planned = list(planned_limits(context))
    unknown = [limit for limit in planned if limit.joint not in known]
    others = names_of_other_robots(context, srdf, {limit.joint for limit in unknown})
    unknown = [limit for limit in unknown if limit.joint not in others]
    if len(unknown) == len(planned) > 1:
        unknown = unknown[:1]  # the file is for another robot
    for limit in unknown:
        message = f"limits of unknown joint '{limit.joint}'{did_you_mean(limit.joint, known)}"
        help = "fix the name, or remove the entry"
        yield Finding(limit.at.span, message, help, severity=Severity.WARNING)


def _groups(context: Context, srdf: Srdf) -> Findings:
    known = srdf.known("group")
    groups = few([f"'{name}'" for name in sorted(known)], _MAX_NAMED)
    entries = list(context.moveit_config.group_entries())
    others = names_of_other_robots(context, srdf, {str(entry.name) for entry in entries} - known)
    for entry in entries:
        # If all of several groups are unknown, the file is for another robot.
        is_ours = entry.is_alone or any(other.name in known for other in entries)
        if known and entry.name not in known | others and is_ours:
            yield Finding(
                entry.name.span,
                f"settings of unknown group '{entry.name}'{did_you_mean(entry.name, known)}",
                f"name a group of {os.path.basename(srdf.path)} ({groups}), or remove the settings",
                severity=Severity.WARNING,
            )


def _projections(context: Context, srdf: Srdf) -> Findings:
    """Joints of a projection that the robot does not have: OMPL has no projection then."""
    known = srdf.known("joint")
    for entry in context.moveit_config.group_entries():
        value = scalar(entry.values, "projection_evaluator")
        match = _PROJECTION.fullmatch(value.text) if value else None
        if entry.name not in srdf.known("group") or match is None or value is None:
            continue
        for name in (part.strip() for part in match.group(1).split(",")):
            if known and name not in known:
                message = f"projection_evaluator of group '{entry.name}': unknown joint '{name}'"
                message += did_you_mean(name, known)
                yield Finding(value.span, message, "fix the name", severity=Severity.WARNING)
                break


def _solvers(context: Context, srdf: Srdf) -> Findings:
    """Misspelt solvers; other unknown solvers are assumed to be in the workspace."""
    solvers: list[str] = data("moveit")["solvers"]
    for entry in context.moveit_config.group_entries():
        solver = scalar(entry.values, "kinematics_solver")
        if entry.name not in srdf.known("group") or solver is None:
            continue
        if solver.text in solvers or _OF_ROBOTS in solver.text:
            continue
        with_package = (known for known in solvers if known.endswith(f"/{solver.text}"))
        suggested = next(with_package, None) or nearest(solver.text, solvers, CLOSE_TYPO)
        if suggested:
            hint = f"unknown solver '{solver.text}'; did you mean '{suggested}'?"
            message = f"group '{entry.name}': {hint}"
            yield Finding(solver.span, message, f"write {suggested}")


def _planners(context: Context) -> Findings:
    """Misspelt planners of groups."""
    of_ompl = [f"{planner}kConfigDefault" for planner in data("moveit")["ompl"].split()]
    for name, defined in context.moveit_config.planner_entries():
        known = {*defined, *of_ompl}
        match = None if name.text in known else _planner(name.text, sorted(known), defined)
        if match:
            message = f"planner '{name.text}' is not in planner_configs; did you mean '{match}'?"
            yield Finding(name.span, message, f"write {match}", severity=Severity.WARNING)
        elif defined and name.text in of_ompl and name.text not in defined:
            message = f"planner '{name.text}' is not in planner_configs, which has others"
            help = f"add it with its type, or name one of: {few(defined, _MAX_NAMED)}"
            yield Finding(name.span, message, help, severity=Severity.WARNING)


def _planning_plugins(context: Context) -> Findings:
    for plugin in context.moveit_config.planning_plugins():
        match = nearest(plugin.text, data("moveit")["planners"], TYPO)
        is_of_ros1 = plugin.text == _PILZ_OF_ROS1 and context.targets.any_of(ROS1)
        if match and plugin.text != match and not is_of_ros1:
            message = f"unknown planning plugin '{plugin.text}'; did you mean '{match}'?"
            yield Finding(plugin.span, message, f"write {match}")


def _adapters(context: Context) -> Findings:
    keys = {name: key for key, names in data("moveit")["adapters"].items() for name in names}
    packages = {name.partition("/")[0] for name in keys}
    for key, adapter, place, is_new in context.moveit_config.adapters():
        package, _, class_name = adapter.partition("/")
        is_known = package in packages or (is_new and package == _ADAPTERS_OF_HUMBLE)
        if is_known and keys.get(adapter) != key:
            same = next((name for name in keys if name.endswith(f"/{class_name}")), None)
            match = same or nearest(adapter, keys, TYPO)
            message = f"{key}: unknown adapter '{adapter}'"
            help = f"write {match} in {keys[match]}" if match else f"remove it from {key}"
            yield Finding(place.span, message, help)


def _planner(name: str, known: list[str], defined: list[str]) -> str | None:
    """The planner that a name stands for: misspelt, or without the suffix of its configuration."""
    begins = (planner for planner in defined if planner.startswith(f"{name}k"))
    return nearest(name, known, TYPO) or next(begins, None)


def _controllers(context: Context, srdf: Srdf) -> Findings:
    known = srdf.known("joint")
    joints = list(context.moveit_config.joint_entries())
    of_others = names_of_other_robots(context, srdf, {joint.text for _, joint in joints} - known)
    unknown = [(who, joint) for who, joint in joints if joint.text not in known | of_others]
    if 2 * len(unknown) > len(joints) > 2:
        unknown = []  # the file is for another robot or variant
    suggester = Suggester(known)
    for who, joint in unknown:
        message = f"{who}: unknown joint '{joint.text}'{suggester.hint(joint.text)}"
        yield Finding(joint.span, message, "fix the name")
    yield from _manager(context)
    for name, others, is_outside in context.moveit_config.names_without_settings():
        hint = did_you_mean(name.text, others)
        if is_outside:
            hint = f" in {MANAGER}: they are at the top level of the file"
        message = f"controller '{name.text}' has no settings{hint}"
        help = "indent the settings" if is_outside else "fix the name"
        yield Finding(name.span, message, help)


def _manager(context: Context) -> Findings:
    """A misspelt controller manager, sections that it ignores, controllers without joints."""
    plugin = context.moveit_config.controller_manager()
    if plugin is None:
        return
    match = nearest(plugin.text, data("moveit")["managers"], CLOSE_TYPO)
    if match and plugin.text != match:
        hint = f"unknown controller manager '{plugin.text}'; did you mean '{match}'?"
        yield Finding(plugin.span, hint, f"write {match}")
    if match != _OF_MOVEIT:
        return
    for key in context.moveit_config.misplaced_controllers():
        message = f"MoveIt reads its controllers below {MANAGER}, not below '{key}'"
        yield Finding(key.span, message, f"write {MANAGER}")
    for key, entry in context.moveit_config.controller_entries():
        if "type" in entry and "joints" not in entry:
            message = f"controller '{key}' has no joints, so MoveIt ignores it"
            yield Finding(key.span, message, "list the joints that it moves")
