"""A launch file starts a controller that no parameter file defines.

The spawner waits, or stops: "The 'type' param was not defined for 'arm_controler'". The name
differs from the name in the YAML file, or the file does not define the controller. In ROS 2, the
type must be in the section of the controller manager, not in the controller's own. A controller
that commands another one, as in `pid/wheel_joint`, needs that one, which must be active before
(warning), and a broadcaster needs the sensor that it reads. A controller whose parameters are in a
file that nothing loads has none (warning): its spawner needs `--param-file`. The YAML files
of the package and of the packages that the launch file references are searched; if it loads none,
and another file includes it, those of the workspace. What the files that include it load counts, as
well. If one of these packages is not found, only typos of known names are reported. A name in the
default of an argument that all files which include the launch file replace is a warning. A launch
file that names parameters itself, for example with the `ns` of a `<rosparam>`, is not checked.

Sources:
    ros_control, spawner: https://github.com/ros-controls/ros_control/blob/noetic-devel/controller_manager/scripts/spawner
    ros2_control, spawner.py: https://github.com/ros-controls/ros2_control/blob/master/controller_manager/controller_manager/spawner.py
"""

import os
import re
from collections.abc import Iterator
from itertools import islice

from urdfkit.checks.bringup.defined_controllers import (
    controllers_of,
    controllers_of_workspace,
    defined_controllers,
)
from urdfkit.checks.bringup.unread_commands import is_part_of_ros
from urdfkit.checks.bringup.workspace_launches import robots_of_workspace, workspace_launches
from urdfkit.core.suggest import Suggester, did_you_mean, is_typo
from urdfkit.core.words import few
from urdfkit.lint.rules import Context, Finding, Findings, Need, Related, Severity, rule
from urdfkit.ros.catalog.controllers import parameters_of
from urdfkit.ros.catalog.ros_control import simulated_hardware
from urdfkit.ros.claims import named_sensors
from urdfkit.ros.controllers import Controller, parameter_files, read
from urdfkit.ros.launch.contents import Launch
from urdfkit.ros.launch.spawned_controllers import SpawnedController, spawned_controllers
from urdfkit.ros.node_parameters import nodes_in_files
from urdfkit.ros.ros_control import components
from urdfkit.workspace.ros_packages import comes_with_ros

NAME = "launch/robot.launch"
BAD = """\
<launch>
  <rosparam file="$(dirname)/../config/control.yaml"/>
  <node name="spawn" pkg="controller_manager" type="spawner" args="arm_controler"/>
</launch>
"""
GOOD = BAD.replace("controler", "controller")
FILES = {
    "package.xml": b"<package><name>arm</name></package>",
    "config/control.yaml": b"arm_controller:\n  type: effort_controllers/JointEffortController\n",
}

_MAX_NAMED = 4
#: Options of the spawner for the file that defines the controllers.
_PARAMETER_FILES = ("-p", "--param-file")
#: The option that activates all controllers of a spawner at once.
_TOGETHER = "--activate-as-group"
#: Files of a package that are read, and directories in which they are searched.
_MAX_FILES, _MAX_DIRECTORIES = 200, 2000


@rule(
    Severity.ERROR,
    needs=(Need.LAUNCH,),
    help="fix the name, or define the controller in the YAML file",
)
def check(context: Context) -> Findings:
    spawned = list(spawned_controllers(context.launch.started))
    if not spawned or context.launch.names_parameters:
        return
    defined = defined_controllers(context)
    including = [] if defined else _including(context)
    yield from _typed_by_themselves(spawned, defined or controllers_of(context, including))
    yield from _chained(context, spawned, defined)
    yield from _without_sensor(context, spawned, defined)
    yield from _without_parameters(context, spawned)
    loaded = set(defined)
    directories, launches = _directories(context), [context.launch]
    if including:
        loaded = set(controllers_of_workspace(context))
        directories = set(context.resolver.packages.known(context.source.path).values())
        launches = including
    files = _files_below(context, directories)
    known = loaded.union(*(_defined(context, path) for path in files))
    known |= {name.rpartition("/")[2] for name in known}  # in ROS 1 a key may have a namespace
    # A name with a substitution is known only when the launch file runs.
    has_names = bool(loaded) and not any("$" in name for name in known)
    is_whole = has_names and _is_whole(context.launch) and any(map(_is_whole, launches))
    suggester = Suggester({name for name in known if "$" not in name})
    names = [controller.name.rpartition("/")[2] for controller in spawned]
    if not known.issuperset(names) and not including:
        # A launch file that includes this one may pass the file that defines it.
        known |= set(controllers_of(context, _including(context)))
    for controller, name in zip(spawned, names, strict=True):
        suggested = suggester.suggested(name)
        # The common ending makes ``hand_controller`` resemble ``head_controller``.
        is_misspelt = bool(suggested) and is_typo(name, suggested)
        if name not in known and (is_whole or is_misspelt):
            default = _replaced_default(controller, context)
            yield Finding(
                controller.at,
                f"controller '{name}' is not defined in any parameter file" + suggester.hint(name),
                default or _help(name, bool(suggested), loaded, context),
                severity=Severity.WARNING if default else None,
            )


def _replaced_default(controller: SpawnedController, context: Context) -> str:
    """Help for the default of an argument that all including files replace; empty for others."""
    path = os.path.abspath(context.source.path)
    names = re.findall(r"\$\((?:arg|var) (\w+)\)", controller.word.span.text)
    launches = workspace_launches(context) if names else ()
    files = [file for launch in launches for file in launch.includes if file.path == path]
    is_replaced = all(file.arguments and file.arguments.keys() >= set(names) for file in files)
    if not files or not is_replaced:
        return ""
    return f"correct the default of '{names[0]}', which the files that include this one replace"


def _chained(
    context: Context, spawned: list[SpawnedController], defined: dict[str, Controller]
) -> Findings:
    """Controllers whose joints are interfaces of others that are not there, or start later."""
    names = [controller.name for controller in spawned]
    is_known = _is_whole(context.launch) and all(map(is_part_of_ros, context.launch.unread))
    parts = {
        part.name
        for _, robot in context.described_robots
        for component in components(robot.model)
        for part in component.parts
    }
    for user in filter(None, map(defined.get, names if is_known else ())):
        joints = user.values(user.kind.joints) if user.kind else []
        chained = [joint for joint in joints if "/" in joint.text and "$" not in joint.text]
        # Some robots have a slash in the names of their joints.
        chained = [joint for joint in chained if joint.text not in parts]
        for joint in {one.text.partition("/")[0]: one for one in chained}.values():
            other = joint.text.partition("/")[0]
            who = f"controller '{user.name}' commands '{joint.text}'"
            if other in parts or user.ros != 2:
                continue
            if other not in defined:
                message = f"{who}: there is no controller '{other}'{did_you_mean(other, defined)}"
                yield Finding(joint.span, message, "fix the name, or define the controller")
            elif other not in names:
                message = f"{who}: '{other}' is not started"
                at = spawned[names.index(user.name)].at
                help = f"start {other} before {user.name}"
                yield Finding(at, message, help, severity=Severity.WARNING)
            elif _is_later(other, user.name, spawned):
                message = f"{who}, but '{other}' is activated later"
                at = spawned[names.index(user.name)].at
                help = f"name {other} first, or pass {_TOGETHER}"
                yield Finding(at, message, help, severity=Severity.WARNING)


def _without_sensor(
    context: Context, spawned: list[SpawnedController], defined: dict[str, Controller]
) -> Findings:
    """Broadcasters of sensors of a simulated robot that has none; RCT032 compares the names."""
    robots = list(context.described_robots)
    blocks = [block for _, robot in robots for block in components(robot.model)]
    is_simulated = bool(blocks) and all(one.hardware in simulated_hardware() for one in blocks)
    has_sensors = any(part.kind == "sensor" for block in blocks for part in block.parts)
    is_known = is_simulated and not has_sensors and all(one.is_whole for one, _ in robots)
    names = {one.name for one in spawned if one.is_activated} if is_known else set()
    for user in filter(None, map(defined.get, sorted(names))):
        for name, value in named_sensors(user).items():
            message = f"controller '{user.name}' reads sensor '{name}', which no <ros2_control> has"
            help = f'add <sensor name="{name}"> with its state interfaces to <ros2_control>'
            yield Finding(value.span, message, help)


def _without_parameters(context: Context, spawned: list[SpawnedController]) -> Findings:
    """Controllers whose parameters are in a file that nothing loads."""
    if any(word.text is None for one in spawned for word in one.program.words):
        return
    defined = controllers_of_workspace(context)
    lacking = {
        one.name: one
        for one in spawned
        if (known := defined.get(one.name)) and known.ros == 2 and _lacks_parameters(known)
    }
    launches = workspace_launches(context) if lacking else ()
    if not lacking or not all(map(is_part_of_ros, (p for one in launches for p in one.unread))):
        return
    loaded = {file.path for launch in launches for file in launch.parameters}
    for robot in robots_of_workspace(context):
        loaded.update(file.found or file.path for file in parameter_files(robot))
    for path in _files_below(context, _directories(context)):
        source = context.resolver.readable(path) if path not in loaded else None
        sections = nodes_in_files([path], context.resolver) if source else ()
        for name, section in ((node.name, node) for node in sections):
            if name in lacking and not _needed(defined[name]).isdisjoint(section.values):
                one = lacking.pop(name)
                message = (
                    f"controller '{name}' gets no parameters: nothing loads the file with them"
                )
                help = f"pass --param-file with {os.path.basename(path)} to the spawner"
                note = Related(section.at, f"the parameters of '{name}'")
                yield Finding(one.at, message, help, severity=Severity.WARNING, related=(note,))


def _lacks_parameters(controller: Controller) -> bool:
    """True for a controller without parameters whose type needs some."""
    return controller.section.at is None and bool(_needed(controller))


def _needed(controller: Controller) -> set[str]:
    """The first parts of the names of the parameters that a controller needs."""
    known = parameters_of(controller.type, controller.ros)
    joints = controller.kind.joints if controller.kind else ()
    names = (*(known.required if known else ()), *joints)
    return {part.partition(".")[0] for name in names for part in name.split("|")}


def _is_later(name: str, other: str, spawned: list[SpawnedController]) -> bool:
    """True if one spawner activates a controller after another one, not all at once."""
    places = {controller.name: place for place, controller in enumerate(spawned)}
    program = spawned[places[name]].program
    is_same = program is spawned[places[other]].program
    is_together = any(word.text in (_TOGETHER, None) for word in program.words)
    return is_same and not is_together and places[name] > places[other]


def _help(name: str, is_suggested: bool, loaded: set[str], context: Context) -> str:
    """The controllers that nothing starts, one of which may be meant."""
    if " " in name:
        return f"write one item for each controller: {name.split()}"
    if spaced := next((one for one in sorted(loaded) if name in one.split() != [one]), ""):
        return f"rename '{spaced}': a spawner reads each of its words as a controller"
    words = [spawned.word for spawned in spawned_controllers(context.launch.programs)]
    idle = sorted(loaded - {word.name for word in words})
    is_clear = not is_suggested and idle and all(word.text for word in words)
    return f"start what is defined: {few(idle, _MAX_NAMED)}, or define {name}" if is_clear else ""


def _typed_by_themselves(
    spawned: list[SpawnedController], defined: dict[str, Controller]
) -> Findings:
    """Controllers whose type the controller manager does not know."""
    for loaded in spawned:
        controller = defined.get(loaded.name)
        options = {option.text for option in loaded.program.words}
        is_known = None not in options and options.isdisjoint(_PARAMETER_FILES)
        if controller and controller.is_typed_by_itself and is_known:
            yield Finding(
                loaded.at,
                f"the controller manager has no type for '{controller.name}': its type is in its "
                "own section, which only the spawner's --param-file reads",
                f"write {controller.name}: {{type: {controller.type}}} below controller_manager, "
                "or pass --param-file",
                related=(Related(controller.type_at, "the type is here"),),
            )


def _is_whole(launch: Launch) -> bool:
    """True if all packages and files that may define controllers are available."""
    is_known = (
        package.searched is None
        or package.is_only_started
        or (comes_with_ros(package.name) and not package.has_parameters)
        for package in launch.packages
    )
    return all(file.exists for file in launch.parameters) and all(is_known)


def _including(context: Context) -> list[Launch]:
    """The launch files that include this one, and so start the robot and load its files."""
    path = os.path.abspath(context.source.path)
    return [
        launch
        for launch in workspace_launches(context)
        if any(file.path == path and file.is_sure for file in launch.includes)
    ]


def _directories(context: Context) -> set[str]:
    """The package of the launch file and the packages that it references."""
    home = context.resolver.packages.enclosing(context.source.path)
    directories = {home[1]} if home else set()
    for package in context.launch.packages:
        if package.searched is None and not comes_with_ros(package.name):
            directories.add(context.resolver.package(package.name, context.source.path))
    return directories


def _files_below(context: Context, directories: set[str]) -> Iterator[str]:
    """The YAML files of packages."""
    for directory in sorted(directories):
        files = context.resolver.directories.files_below(directory, _MAX_DIRECTORIES)
        yield from islice((file for file in files if file.endswith((".yaml", ".yml"))), _MAX_FILES)


def _defined(context: Context, path: str) -> set[str]:
    source = context.resolver.readable(path)
    return {controller.name for controller in read(source)} if source else set()
