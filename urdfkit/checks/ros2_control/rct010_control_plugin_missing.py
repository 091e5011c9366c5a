"""The Gazebo plugin that runs the controllers is missing or duplicated.

Without the plugin nothing loads the hardware: the joints are not actuated and the controller
manager does not answer. Two plugins in one namespace start two controller managers of the same
name, and both drive the joints. A misspelt `<robotSimType>` of gazebo_ros_control is also reported:
"Failed to create robot simulation interface loader". Transmissions of ROS 1 without the plugin are
an info if some are of a class of the robot's own, which its hardware loads. They are not reported
if another value of an argument adds a plugin.

Sources:
    gz_ros2_control: https://github.com/ros-controls/gz_ros2_control/blob/rolling/doc/index.rst
    gazebo_ros2_control: https://github.com/ros-controls/gazebo_ros2_control/blob/master/doc/index.rst
"""

import re

from urdfkit.core.grouping import repeated
from urdfkit.core.suggest import CLOSE_TYPO, nearest
from urdfkit.lint.rules import Context, Finding, Findings, Related, Severity, rule
from urdfkit.lint.switched_off import all_sources
from urdfkit.robot.samples import robot_xml
from urdfkit.ros.catalog.ros_control import (
    control_plugin,
    control_plugin_libraries,
    simulated_hardware,
)
from urdfkit.ros.gazebo.samples import ARM, control_xml, driven_xml, gazebo_xml, plugin_xml
from urdfkit.ros.ros_control import (
    DEFAULT_SIM,
    ControlPlugin,
    components,
    control_plugins,
    is_of_pr2,
)
from urdfkit.text.comments import blank_comments
from urdfkit.text.document import Element

BAD = ARM + control_xml("gazebo_ros2_control/GazeboSystem", driven_xml("shoulder"))
_PARAMETERS = "<parameters>/home/student/arm_description/config/controllers.yaml</parameters>"
GOOD = robot_xml(BAD, gazebo_xml(plugin_xml("control", "libgazebo_ros2_control.so", _PARAMETERS)))
FILES = {
    "config/controllers.yaml": b"controller_manager:\n  ros__parameters:\n    update_rate: 9\n"
}


#: The plugin that reads the class of its hardware; those of ROS 2 have it from <ros2_control>.
_WITH_CLASS = "gazebo_ros_control"
#: Most directories that are searched for models in SDF.
_MAX_DIRECTORIES = 2000
_SDF = (".sdf", ".sdf.xacro")
#: The library of a plugin.
_LIBRARY = rb"""<plugin\b[^<>]*\bfilename\s*=\s*["']([^"'<>]*)"""


@rule(
    Severity.WARNING,
    help="add the control plugin of the simulator once, in a <gazebo> block without reference",
    depends_on_arguments=True,
    reports_missing=True,
)
def check(context: Context) -> Findings:
    plugins = control_plugins(context.model)
    yield from _duplicates(plugins)
    for plugin in plugins:
        yield from _misspelt_simulation(plugin)
    if context.is_part:
        return
    if not plugins:
        yield from _missing(context)
    elif all(plugin.kind == _WITH_CLASS for plugin in plugins):
        yield from _without_transmission(context, plugins[0])


def _duplicates(plugins: list[ControlPlugin]) -> Findings:
    keyed = (((plugin.kind, _namespace(plugin.at)), plugin) for plugin in plugins)
    for plugin, first in repeated(keyed):
        message = f"plugin {plugin.filename} is used twice in one namespace"
        related = (Related(first.at.span, "first used here"),)
        yield Finding(plugin.at, message, related=related)


def _namespace(plugin: Element) -> str:
    """Namespace and name of the controller manager that a plugin starts."""
    tags = ("namespace", "robotNamespace", "controller_manager_name")
    return " ".join(element.text.strip() for element in plugin.walk() if element.tag in tags)


def _missing(context: Context) -> Findings:
    for component in components(context.model):
        hardware = simulated_hardware().get(component.hardware)
        if hardware and component.plugin:
            library = control_plugin_libraries()[hardware.control]
            if not _is_in_sdf(context, library):
                yield Finding(
                    component.plugin,
                    f"{component.called} is for {hardware.simulator}, but no plugin in <gazebo> "
                    f"loads it ({library})",
                )
            return  # one plugin loads all blocks
    transmissions = [
        transmission for transmission in context.model.transmissions if not is_of_pr2(transmission)
    ]
    may_load = any(use.plugin is None for use in context.plugins)
    if (
        transmissions
        and "classic-ros1" in context.targets.names
        and context.plugins
        and not may_load
        and not _is_switched_off(context)
    ):
        yield Finding(
            transmissions[0],
            "the robot has transmissions for Gazebo Classic, but no plugin in <gazebo> "
            f"loads them ({control_plugin_libraries()['gazebo_ros_control']})",
            severity=Severity.INFO if any(map(_has_own_loader, transmissions)) else None,
        )


def _is_in_sdf(context: Context, library: str) -> bool:
    """True if a model in SDF, which is spawned instead of the URDF, loads the plugin."""
    resolver = context.resolver
    if resolver.packages.enclosing(context.source.path) is None:
        return False
    directory = resolver.packages.workspace(context.source.path)
    files = resolver.directories.files_below(directory, _MAX_DIRECTORIES)
    models = (resolver.readable(path) for path in files if path.endswith(_SDF))
    return any(library.encode() in model.data for model in models if model)


def _is_switched_off(context: Context) -> bool:
    """True if a file of the robot has a control plugin, which an argument disables."""
    texts = (blank_comments(source.data) for source in all_sources(context))
    files = (file for text in texts for file in re.findall(_LIBRARY, text))
    return any(control_plugin(file.decode("utf-8", "replace")) for file in files)


def _has_own_loader(transmission: Element) -> bool:
    """True for a class of the real robot's own: its transmissions may not be for Gazebo."""
    kind = transmission.child("type")
    return kind is not None and not re.match(r"\W*(transmission_interface\W|\w*$)", kind.text)


def _misspelt_simulation(plugin: ControlPlugin) -> Findings:
    """A misspelt class of the hardware simulation."""
    kind = plugin.at.child("robotSimType") if plugin.kind == _WITH_CLASS else None
    text = kind.text.strip() if kind else ""
    if kind is not None and text != DEFAULT_SIM and nearest(text, (DEFAULT_SIM,), CLOSE_TYPO):
        message = f"plugin {plugin.filename}: no class '{text}'; did you mean '{DEFAULT_SIM}'?"
        yield Finding(kind, message, f"write {DEFAULT_SIM}")


def _without_transmission(context: Context, plugin: ControlPlugin) -> Findings:
    """A plugin of ROS 1, which moves only joints with transmissions, in a robot without any."""
    if any(not is_of_pr2(transmission) for transmission in context.model.transmissions):
        return
    if plugin.at.child("robotSimType") is None:
        yield Finding(
            plugin.at,
            f"plugin {plugin.filename} drives no joint: there are no transmissions",
            "add a <transmission> for each driven joint, or remove the plugin",
        )
