"""MoveIt has no controller for a trajectory: its controllers are not loaded, listed or complete.

- A name in `controller_names` has no settings, which are misspelt or one level too high, or a
  controller has no joints, or a type that MoveIt does not have: MoveIt ignores it, and fails with
  "Unable to identify any set of controllers that can actuate the specified joints".
- The name of the controller manager is misspelt, or its section has another name: "Exception while
  loading controller manager". Or nothing names it, so that move_group does not load it (warning).
- A controller has settings, but is not in `controller_names`; or a setting of it is misspelt
  (warnings).
- The controller of an arm lacks one of its joints (warning).
- A parameter of `trajectory_execution` is misspelt or outside of its section: MoveIt uses its
  default (warning).

Sources:
    MoveIt, controllers: https://moveit.picknik.ai/main/doc/examples/controller_configuration/controller_configuration_tutorial.html
    MoveIt, moveit_simple_controller_manager.cpp: https://github.com/moveit/moveit2/blob/main/moveit_plugins/moveit_simple_controller_manager/src/moveit_simple_controller_manager.cpp
    MoveIt, trajectory_execution_manager.cpp: https://github.com/moveit/moveit2/blob/main/moveit_ros/planning/trajectory_execution_manager/src/trajectory_execution_manager.cpp
"""

from urdfkit.checks.srdf.trajectories import TYPES, omitted_joints, unknown_type
from urdfkit.core.suggest import CLOSE_TYPO, did_you_mean, nearest
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.ros.catalog import data
from urdfkit.ros.gazebo.samples import SHOULDER
from urdfkit.ros.moveit.config import CONTROLLERS, MANAGER
from urdfkit.ros.moveit.samples import configurations, named_xml
from urdfkit.ros.moveit.srdf import Srdf
from urdfkit.text.located_yaml import Value, items, mapping, scalars
from urdfkit.workspace.launch_files import launch_files
from urdfkit.workspace.manifest import manifest_of

BAD = named_xml("bad", SHOULDER)
GOOD = BAD.replace('"bad"', '"good"')
_CONTROLLERS = """\
moveit_controller_manager: moveit_simple_controller_manager/MoveItSimpleControllerManager
moveit_simple_controller_manager:
  controller_names: [arm_controller]
  arm: {type: FollowJointTrajectory, action_ns: follow_joint_trajectory, joints: [shoulder]}
"""
FILES = configurations(
    "moveit_controllers.yaml", _CONTROLLERS, _CONTROLLERS.replace("  arm:", "  arm_controller:")
)

_PLUGIN = "moveit_controller_manager"
#: The controller manager whose settings are checked.
_OF_MOVEIT = f"{MANAGER}/MoveItSimpleControllerManager"
_EXECUTION = "trajectory_execution"
#: Least number of joints of a chain of which one is forgotten.
_LEAST_JOINTS = 3


@rule(Severity.ERROR, needs=(Need.MODEL, Need.SRDF), reports_missing=True)
def check(context: Context) -> Findings:
    srdf = context.required_srdf
    yield from _execution(context)
    yield from _manager(context)
    yield from _without_manager(context, srdf)
    yield from _without_settings(context)
    yield from _misspelt_settings(context)
    yield from _unlisted(context)
    yield from _uncommanded(context, srdf)


def _execution(context: Context) -> Findings:
    """Parameters of trajectory execution outside of their section, or misspelt in it."""
    known = data("moveit")[_EXECUTION].split()
    root = context.moveit_config.load(CONTROLLERS)
    for key, _ in items(root):
        if key in known:
            message = f"'{key}' is not read: it is a parameter of {_EXECUTION}"
            help = f"indent it below {_EXECUTION}:"
            yield Finding(key.span, message, help, severity=Severity.WARNING)
    for key, _ in items(root, _EXECUTION):
        match = nearest(key, known, CLOSE_TYPO) if key not in known else None
        if match:
            message = f"{_EXECUTION} has no '{key}'"
            yield Finding(key.span, message, f"write {match}", severity=Severity.WARNING)


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
        joints = entry.get("joints", [])
        if "type" in entry and (joints == [] or (isinstance(joints, Value) and not joints.text)):
            message = f"controller '{key}' has no joints, so MoveIt ignores it"
            yield Finding(key.span, message, "list the joints that it moves")
        if kind := unknown_type(entry):
            message = f"controller '{key}' has the unknown type '{kind.text}', so MoveIt ignores it"
            match = nearest(kind.text, TYPES)
            help = f"write {match or f'{TYPES[0]}, or {TYPES[1]} for a gripper'}"
            yield Finding(kind.span, message, help)


def _without_manager(context: Context, srdf: Srdf) -> Findings:
    """Settings of the simple controller manager, which nothing tells move_group to load."""
    root = context.moveit_config.load(CONTROLLERS)
    key = next((key for key, _ in items(root) if key == MANAGER), None)
    directory = context.resolver.packages.workspace(srdf.path)
    if key is None or _PLUGIN in root or not mapping(root, MANAGER).get("controller_names"):
        return
    if not context.resolver.packages.enclosing(srdf.path):
        return
    if not any(launch_files(directory, _PLUGIN, context.resolver)):
        message = f"no {_PLUGIN} is named: move_group does not load {MANAGER}"
        yield Finding(
            key.span, message, f"write {_PLUGIN}: {_OF_MOVEIT}", severity=Severity.WARNING
        )


def _without_settings(context: Context) -> Findings:
    """Names in the list of controllers that have no settings, or have them at another level."""
    for name, others, is_outside in context.moveit_config.names_without_settings():
        hint = did_you_mean(name.text, others)
        if is_outside:
            hint = f" in {MANAGER}: they are at the top level of the file"
        message = f"controller '{name.text}' has no settings{hint}"
        help = "indent the settings" if is_outside else "fix the name"
        yield Finding(name.span, message, help)


def _misspelt_settings(context: Context) -> Findings:
    """Misspelt settings of controllers."""
    known = data("moveit")["controller"].split()
    for name, entry in context.moveit_config.controller_entries():
        for key, _ in items(entry):
            match = nearest(key, known) if key not in known else None
            if match and match not in entry:
                message = f"controller '{name}' has no '{key}'"
                yield Finding(key.span, message, f"write {match}", severity=Severity.WARNING)


def _unlisted(context: Context) -> Findings:
    """A controller with settings that is not in the list: MoveIt ignores it."""
    section = mapping(context.moveit_config.load(CONTROLLERS), MANAGER)
    listed = section.get("controller_names")
    names = {value.text for value in scalars(listed)}
    if not names or not names <= section.keys():  # substituted or misspelt ones
        return
    for key, entry in context.moveit_config.controller_entries():
        if key not in names and "type" in entry and "joints" in entry:
            message = f"controller '{key}' is not in controller_names, so MoveIt ignores it"
            help = f"add {key} to controller_names"
            yield Finding(key.span, message, help, severity=Severity.WARNING)


def _uncommanded(context: Context, srdf: Srdf) -> Findings:
    """A joint at the end of a chain, or in it, that the controller of the chain lacks."""
    manifest = manifest_of(context.resolver, srdf.path)
    if manifest is None or manifest.ros != 2:
        return
    model, omitted = context.model, omitted_joints(context.model, srdf)
    entries = context.moveit_config.controller_entries()
    commanded = {
        joint.text: key for key, entry in entries for joint in scalars(entry.get("joints"))
    }
    reported: set[str] = set()
    for name in srdf.groups_by_name:
        links = srdf.links_of(name)
        chain = [joint for joint in model.joints if joint.child_name in links]
        parents = [joint.parent_name for joint in chain]
        moved = {joint.name for joint in chain} - omitted
        missing = moved - commanded.keys()
        owners = {commanded[joint] for joint in moved - missing}
        is_chain = len(set(parents)) == len(parents)
        if len(missing) != 1 or len(owners) != 1 or len(moved) < _LEAST_JOINTS or not is_chain:
            continue
        (joint,), (key,) = missing, owners
        if joint not in reported:
            reported.add(joint)
            yield Finding(
                key.span,
                f"controller '{key}' lacks joint '{joint}' of group '{name}', so that MoveIt finds "
                "no controllers for a trajectory of the group",
                f"add '{joint}' to its joints",
                severity=Severity.WARNING,
            )
