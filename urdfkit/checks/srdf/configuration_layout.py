"""Settings in MoveIt's YAML files that are missing, misplaced, or of the wrong kind.

Sources: ``trajectory_execution_manager.cpp``, ``moveit_simple_controller_manager.cpp``,
``pointcloud_octomap_updater.cpp``, ``depth_image_octomap_updater.cpp``,
``planning_context_manager.cpp`` and ``cartesian_limits_parameters.yaml`` of moveit/moveit2.
"""

import os

from urdfkit.checks.srdf.trajectory_controllers import defined_controllers
from urdfkit.core.suggest import CLOSE_TYPO, did_you_mean, nearest
from urdfkit.core.words import few
from urdfkit.lint.rules import Context, Finding, Findings, Severity
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.rviz import displays
from urdfkit.ros.moveit.config import CONTROLLERS, MANAGER, PIPELINES
from urdfkit.ros.moveit.srdf import Srdf
from urdfkit.text.located_yaml import Key, Node, Value, mapping, scalar, scalars
from urdfkit.workspace.launch_files import launch_files
from urdfkit.workspace.manifest import manifest_of

_PLUGIN = "moveit_controller_manager"
#: Most directories of a package that are searched for configurations of RViz.
_MAX_DIRECTORIES = 200
_EXECUTION = "trajectory_execution"
_SENSORS = "sensors_3d.yaml"
_CARTESIAN = "pilz_cartesian_limits.yaml"
_ADAPTERS = ("request_adapters", "response_adapters")
_OUTPUT = ("command_out_topic", "command_out_type")


def invalid_layout(context: Context, srdf: Srdf) -> Findings:
    yield from _execution(context)
    yield from _controllers(context)
    yield from _unlisted(context)
    yield from _without_manager(context, srdf)
    yield from _rviz_groups(context, srdf)
    yield from _sensors(context, srdf)
    yield from _cartesian_limits(context)
    yield from _pipelines(context)
    yield from _planners_of_groups(context)
    yield from _servo(context, srdf)


def _warning(key: object, message: str, help: str) -> Findings:
    if isinstance(key, (Key, Value)):
        yield Finding(key.span, message, help, severity=Severity.WARNING)


def _execution(context: Context) -> Findings:
    """Parameters of trajectory execution outside of their section, or misspelt in it."""
    known = data("moveit")[_EXECUTION].split()
    root = context.moveit_config.load(CONTROLLERS)
    for key in root:
        if key in known:
            message = f"'{key}' is not read: it is a parameter of {_EXECUTION}"
            yield from _warning(key, message, f"indent it below {_EXECUTION}:")
    for key in mapping(root, _EXECUTION):
        match = nearest(key, known, CLOSE_TYPO) if key not in known else None
        if match:
            yield from _warning(key, f"{_EXECUTION} has no '{key}'", f"write {match}")


def _controllers(context: Context) -> Findings:
    """Misspelt settings of controllers."""
    known = data("moveit")["controller"].split()
    for name, entry in context.moveit_config.controller_entries():
        for key in entry:
            match = nearest(key, known) if key not in known else None
            if match and match not in entry:
                yield from _warning(key, f"controller '{name}' has no '{key}'", f"write {match}")


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
            yield from _warning(key, message, f"add {key} to controller_names")


def _without_manager(context: Context, srdf: Srdf) -> Findings:
    """Settings of the simple controller manager, which nothing tells move_group to load."""
    root = context.moveit_config.load(CONTROLLERS)
    key = next((key for key in root if key == MANAGER), None)
    directory = context.resolver.packages.workspace(srdf.path)
    if key is None or _PLUGIN in root or not mapping(root, MANAGER).get("controller_names"):
        return
    if not context.resolver.packages.enclosing(srdf.path):
        return
    if not any(launch_files(directory, _PLUGIN, context.resolver)):
        message = f"no {_PLUGIN} is named: move_group does not load {MANAGER}"
        yield from _warning(
            key, message, f"write {_PLUGIN}: {MANAGER}/MoveItSimpleControllerManager"
        )


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
            yield from _warning(plugin, message, help)


def _loads_sensors(context: Context, srdf: Srdf) -> bool:
    """True if launch files of ROS 2 load the sensors: by name, or with all files of the package."""
    resolver = context.resolver
    manifest = manifest_of(resolver, srdf.path)
    package = resolver.packages.enclosing(srdf.path)
    if manifest is None or manifest.ros != 2 or package is None:
        return False
    workspace = resolver.packages.workspace(srdf.path)
    return any(launch_files(workspace, _SENSORS.partition(".")[0], resolver)) or any(
        package[0].encode() in launch.data
        for launch in launch_files(workspace, "MoveItConfigsBuilder", resolver)
    )


def _cartesian_limits(context: Context) -> Findings:
    """A limit without which Pilz's planner plans no lines: "not fully set"."""
    root = context.moveit_config.load(_CARTESIAN)
    limits = mapping(root, "cartesian_limits")
    missing = [name for name in data("moveit")["cartesian_limits"].split() if name not in limits]
    section = next((key for key in root if key == "cartesian_limits"), None)
    if section is not None and limits and missing:
        message = f"cartesian_limits has no {', '.join(missing)}: LIN and CIRC fail"
        yield from _warning(section, message, "add " + ", ".join(missing))


def _pipelines(context: Context) -> Findings:
    """Files of pipelines that are half of Humble and half of Jazzy."""
    for file in PIPELINES:
        root = context.moveit_config.load(file)
        is_new = "planning_plugins" in root
        for key in root:
            value = root[key]
            if key in _ADAPTERS and is_new and isinstance(value, Value) and value.text:
                names = value.text.split()
                message = f"{key} is a text, but with planning_plugins (Jazzy) it is a list"
                yield from _warning(key, message, f"write each on a line: - {names[0]}")
            elif key == "planning_plugin" and not is_new and _has_lists(root):
                message = "planning_plugin is of Humble, and the lists of adapters are of Jazzy"
                text = getattr(value, "text", "")
                yield from _warning(key, message, f"write planning_plugins: [{text}]")


def _has_lists(root: dict[str, Node]) -> bool:
    return any(isinstance(root.get(key), list) for key in _ADAPTERS)


def _planners_of_groups(context: Context) -> Findings:
    """A single planner where a group has a list: move_group stops at the type."""
    for entry in context.moveit_config.group_entries():
        value = scalar(entry.values, "planner_configs")
        if value and value.text:
            message = f"planner_configs of group '{entry.name}' is not a list"
            yield Finding(value.span, message, f"write [{value.text}]")


def _servo(context: Context, srdf: Srdf) -> Findings:
    """A topic that its controller does not read, and a type that it does not read."""
    types: dict[str, str] = data("moveit")["servo_outputs"]
    for source, values in context.moveit_config.servo_values():
        topic, kind = (values.get(name) for name in _OUTPUT)
        file = os.path.basename(source.path)
        if topic is not None and (read := _read_topic(context, srdf, topic.text)):
            message = f"{file}: '{topic.text}' is not read: the controller reads '{read}'"
            yield from _warning(topic, message, f"write {read}")
            continue
        expected = types.get(topic.text.rpartition("/")[2]) if topic else None
        if kind is None or topic is None or not expected or kind.text == expected:
            continue
        message = f"{file}: command_out_type is '{kind.text}', but {topic.text} is {expected}"
        yield from _warning(kind, message, f"write {expected}")


def _read_topic(context: Context, srdf: Srdf, topic: str) -> str:
    """The topic that a controller reads instead of another one below its name."""
    above, _, last = topic.rpartition("/")
    name = above.rpartition("/")[2]
    kinds = {
        controller.type
        for controller in defined_controllers(context, srdf)
        if controller.name == name
    }
    expected = data("moveit")["servo_topics"].get(kinds.pop()) if len(kinds) == 1 else None
    return f"{above}/{expected}" if expected and expected != last else ""
