"""A parameter file of MoveIt contains an unknown joint, group, planner, solver or plugin.

- An unknown joint in `joint_limits.yaml` (warning): MoveIt ignores the entry, and plans with the
  limits of the URDF and without acceleration limits.
- An unknown joint of a controller in `moveit_controllers.yaml` (or the files of ROS 1), or in
  `initial_positions.yaml`: "Unable to identify any set of controllers that can actuate the
  specified joints".
- An unknown group in `kinematics.yaml` or `ompl_planning.yaml` (warning): MoveIt plans with the
  default planner, and without inverse kinematics. An unknown planning group in RViz (info).
- A misspelt solver in `kinematics.yaml`: "The kinematics plugin (arm) failed to load", and the
  group cannot be moved to a pose.
- In `ompl_planning.yaml`, a planner of a group that it does not define (warning): "Could not find
  the planner configuration"; a misspelt planning plugin: "Exception while loading planner"; an
  unknown adapter, or one for responses among those for requests; an unknown joint in a projection
  (warning).

The name is misspelt, or the file is that of another robot.

Sources:
    MoveIt, robot_model_loader.cpp: https://github.com/moveit/moveit2/blob/main/moveit_ros/planning/robot_model_loader/src/robot_model_loader.cpp
    MoveIt, kinematics: https://moveit.picknik.ai/main/doc/examples/kinematics_configuration/kinematics_configuration_tutorial.html
    MoveIt, OMPL: https://moveit.picknik.ai/main/doc/examples/ompl_interface/ompl_interface_tutorial.html
    moveit/moveit#955: https://github.com/moveit/moveit/issues/955
    moveit/moveit_planners#6: https://github.com/moveit/moveit_planners/issues/6
"""

import os
import re
from collections.abc import Iterator

from urdfkit.checks.srdf.namesakes import has_incomplete_namesake
from urdfkit.core.suggest import CLOSE_TYPO, TYPO, Suggester, did_you_mean, nearest
from urdfkit.core.words import few
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.lint.switched_off import uncalled_macro
from urdfkit.ros.catalog import data
from urdfkit.ros.gazebo.samples import SHOULDER
from urdfkit.ros.launch.rviz import displays
from urdfkit.ros.moveit.joint_limits import planned_limits
from urdfkit.ros.moveit.samples import configurations, named_xml
from urdfkit.ros.moveit.srdf import Srdf
from urdfkit.ros.moveit.srdf_variant import names_of_other_robots
from urdfkit.ros.ros_control import ROS1
from urdfkit.text.located_yaml import scalar

BAD = named_xml("bad", SHOULDER)
GOOD = BAD.replace('"bad"', '"good"')
FILES = configurations(
    "kinematics.yaml",
    "manipulator: {kinematics_solver: kdl_kinematics_plugin/KDLKinematicsPlugin}\n",
    "arm: {kinematics_solver: kdl_kinematics_plugin/KDLKinematicsPlugin}\n",
)

#: The plugins of IKFast are named after the robot.
_OF_ROBOTS = "IKFast"
#: The name of Pilz's planner in MoveIt 1.
_PILZ_OF_ROS1 = "pilz_industrial_motion_planner::CommandPlanner"

#: The package of the adapters up to Iron.
_ADAPTERS_OF_HUMBLE = "default_planner_request_adapters"

#: A projection on joints.
_PROJECTION = re.compile(r"joints\(([^()$]*)\)")
#: Most groups that a help names.
_MAX_NAMED = 8
#: Most directories of a package that are searched for configurations of RViz.
_MAX_DIRECTORIES = 200

#: The variables of a joint by its type, as MoveIt names them.
_VARIABLES = {
    "planar": ("x", "y", "theta"),
    "floating": ("trans_x", "trans_y", "trans_z", "rot_x", "rot_y", "rot_z", "rot_w"),
}


@rule(Severity.ERROR, needs=(Need.MODEL, Need.SRDF), reports_missing=True)
def check(context: Context) -> Findings:
    srdf = context.required_srdf
    yield from _rviz_groups(context, srdf)
    if has_incomplete_namesake(context, srdf):
        return
    yield from _joint_limits(context, srdf)
    yield from _joints(context, srdf)
    yield from _groups(context, srdf)
    yield from _solvers(context, srdf)
    yield from _planners(context)
    yield from _planning_plugins(context)
    yield from _adapters(context)
    yield from _projections(context, srdf)


def _joint_limits(context: Context, srdf: Srdf) -> Findings:
    known = {*context.model.joints_by_name, *_variables(context, srdf)}
    planned = list(planned_limits(context))
    unknown = [limit for limit in planned if limit.joint not in known]
    others = names_of_other_robots(context, srdf, {limit.joint for limit in unknown})
    unknown = [limit for limit in unknown if limit.joint not in others]
    if len(unknown) == len(planned) > 1:
        unknown = unknown[:1]  # the file is for another robot
    suggester = Suggester(known)
    for limit in unknown:
        message = f"limits of unknown joint '{limit.joint}'{suggester.hint(limit.joint)}"
        help = "fix the name, or remove the entry"
        yield Finding(limit.at.span, message, help, severity=Severity.WARNING)


def _variables(context: Context, srdf: Srdf) -> Iterator[str]:
    """The variables of joints with several degrees of freedom, which have limits of their own."""
    joints = [(joint.get("name"), joint.get("type")) for joint in srdf.virtual_joints]
    joints += [(joint.name, joint.kind) for joint in context.model.joints]
    for name, kind in joints:
        yield from (f"{name}/{variable}" for variable in _VARIABLES.get(kind or "", ()))


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
    planners: list[str] = data("moveit")["ompl"].split()
    of_ompl = [f"{planner}kConfigDefault" for planner in planners]
    for name, defined in context.moveit_config.planner_entries():
        known = {*defined, *of_ompl}
        match = None if name.text in known else _planner(name.text, sorted(known), defined)
        if match:
            message = f"planner '{name.text}' is not in planner_configs; did you mean '{match}'?"
            yield Finding(name.span, message, f"write {match}", severity=Severity.WARNING)
        elif defined and name.text in (*of_ompl, *planners) and name.text not in defined:
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


def _joints(context: Context, srdf: Srdf) -> Findings:
    """Unknown joints of controllers and of the initial positions."""
    known = srdf.known("joint")
    joints = list(context.moveit_config.joint_entries())
    of_others = names_of_other_robots(context, srdf, {joint.text for _, joint in joints} - known)
    unknown = [(who, joint) for who, joint in joints if joint.text not in known | of_others]
    if 2 * len(unknown) > len(joints) > 2:
        unknown = []  # the file is for another robot or variant
    suggester = Suggester(known)
    for who, joint in unknown:
        message = f"{who}: unknown joint '{joint.text}'{suggester.hint(joint.text)}"
        macro = uncalled_macro(context, joint.text)
        help = f"call macro '{macro}', which defines the joint" if macro else "fix the name"
        yield Finding(joint.span, message, help)


def _rviz_groups(context: Context, srdf: Srdf) -> Findings:
    """A planning group of another robot in the MotionPlanning of RViz."""
    package = context.resolver.packages.enclosing(srdf.path)
    directory = package[1] if package else os.path.dirname(srdf.path)
    known = srdf.known("group")
    for path in context.resolver.directories.files_below(directory, _MAX_DIRECTORIES):
        source = context.resolver.readable(path) if path.endswith(".rviz") else None
        for display in displays(source) if source and known else ():
            group = scalar(display, "Planning Request", "Planning Group")
            if group and group.text and group.text not in known:
                message = f"RViz: unknown planning group '{group.text}'"
                message += did_you_mean(group.text, known)
                help = f"write one of {few(sorted(known), 4)}"
                # RViz takes the first group instead.
                yield Finding(group.span, message, help, severity=Severity.INFO)
