"""A `<ros2_control>` block has no hardware plugin, or one that cannot be loaded.

- Without a plugin the controller manager does not start: the parser throws an exception, or no
  class of an empty name is found. Name the hardware class, or `mock_components/GenericSystem` for
  tests without hardware. A block whose plugin depends on xacro arguments is not reported, nor is
  one of an unknown type, which is not loaded (RCT017).
- A misspelt class, or one with white space around it, is not found, and the controller manager
  starts without hardware. So is a class that the control plugin of a simulator does not have, or of
  a package in the workspace whose CMakeLists.txt exports others, or no plugin description. Classes
  of other packages are assumed to exist.
- `fake_components/GenericSystem` was removed after Humble (info; a warning if a parameter file is
  for Jazzy or later).
- A control plugin of a simulator loads only its own hardware and ignores any other, so that no
  controller can be activated: Gazebo Classic needs `gazebo_ros2_control/GazeboSystem`, Gazebo Sim
  `gz_ros2_control/GazeboSimSystem`.

Sources:
    ros2_control, component_parser.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/component_parser.cpp
    ros2_control, resource_manager.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/resource_manager.cpp
    ros2_control, mock components: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/doc/mock_components_userdoc.rst
    gz_ros2_control: https://github.com/ros-controls/gz_ros2_control/blob/rolling/doc/index.rst
    gazebo_ros2_control: https://github.com/ros-controls/gazebo_ros2_control/blob/master/doc/index.rst
"""

from urdfkit.core.suggest import CLOSE_TYPO, nearest
from urdfkit.lint.rules import Context, Finding, Findings, Related, Severity, rule
from urdfkit.robot.samples import robot_xml
from urdfkit.ros.catalog.ros_control import (
    component_types,
    control_plugin_libraries,
    simulated_hardware,
)
from urdfkit.ros.gazebo.samples import SHOULDER, control_xml, driven_xml
from urdfkit.ros.launch.releases import is_for_jazzy
from urdfkit.ros.ros_control import Component, ControlPlugin, called, components, control_plugins
from urdfkit.ros.targets import CLASSIC, GZ, Targets
from urdfkit.text.editing.edits import fix_value
from urdfkit.text.grammar import is_expression
from urdfkit.workspace.plugin_descriptions import why_unknown

BAD = robot_xml(SHOULDER, control_xml("mock_component/GenericSystem", driven_xml("shoulder")))
FIXED = GOOD = BAD.replace("mock_component/", "mock_components/")

#: The package of the base classes of hardware.
_BASE = "hardware_interface"
#: The control plugin of gz-sim.
_OF_GZ = "gz_ros2_control"
#: Hardware classes of ros2_control, and of a package that many simulators use.
_COMMON = ("mock_components/GenericSystem", "topic_based_ros2_control/TopicBasedSystem")
_FORMER = "fake_components/"
_ADD_PLUGIN = "add <hardware><plugin>package/Class</plugin></hardware> to the block"


@rule(Severity.ERROR)
def check(context: Context) -> Findings:
    plugins = control_plugins(context.model)
    for component in components(context.model):
        # Without arguments, a robot with a false condition is only displayed.
        if component.plugin is None and component.has_conditional_plugin:
            continue
        yield from _missing(component)
        yield from _misspelt(component, context)
        yield from _padded(component)
        yield from _removed(component, context)
        yield from _not_exported(component, context)
        if plugins:
            yield from _other_simulator(component, plugins, context.targets)


def _missing(component: Component) -> Findings:
    hardware = component.at.child("hardware")
    kind = component.at.get("type")
    is_loaded = kind is None or kind in component_types() or is_expression(kind)  # see RCT017
    if hardware is None and is_loaded:
        yield Finding(component.at, f"{component.called} has no <hardware>", _ADD_PLUGIN)
    elif hardware and component.plugin is None:
        yield Finding(hardware, f"{component.called}: <hardware> has no <plugin>", _ADD_PLUGIN)
    elif component.plugin and not component.hardware:
        yield Finding(component.plugin, f"{component.called}: <plugin> is empty", _ADD_PLUGIN)
    for transmission in component.at.all("transmission"):
        plugin = transmission.child("plugin")
        if plugin is None or not plugin.text.strip():
            help = "add <plugin>transmission_interface/SimpleTransmission</plugin>"
            yield Finding(transmission, f"{called(transmission)} has no <plugin>", help)


def _padded(component: Component) -> Findings:
    """White space around the class, which ros2_control does not remove."""
    name = component.hardware
    if name and component.plugin is not None and component.plugin.text != name:
        message = f"{component.called}: white space around hardware '{name}', which is not removed"
        yield Finding(component.plugin, message, f"write <plugin>{name}</plugin>")


def _misspelt(component: Component, context: Context) -> Findings:
    """A misspelt class, a known class without its package, or one that its package lacks."""
    name, known = component.hardware, (*_COMMON, *simulated_hardware())
    if component.plugin is None or not name or name in known or name.startswith("fake_"):
        return
    full = next((hardware for hardware in known if hardware.endswith(f"/{name}")), None)
    package = name.partition("/")[0]
    own = next((hardware for hardware in known if hardware.startswith(f"{package}/")), None)
    if own and package in context.resolver.packages.known(component.plugin.span.source.path):
        own = None  # it may have further classes
    if suggested := full or nearest(name, known, CLOSE_TYPO) or own:
        fix = fix_value(component.plugin, suggested)
        message = f"{component.called}: unknown hardware '{name}'; did you mean '{suggested}'?"
        yield Finding(component.plugin, message, f"write {suggested}", fix)


def _removed(component: Component, context: Context) -> Findings:
    """The mock hardware under its name up to Humble."""
    if component.plugin is None or not component.hardware.startswith(_FORMER):
        return
    is_later = is_for_jazzy(component.plugin.span.source.path, context.resolver)
    yield Finding(
        component.plugin,
        f"{component.called}: Iron and later have no {component.hardware}",
        f"write {_COMMON[0]}, which Humble has, too",
        fix_value(component.plugin, _COMMON[0]),
        severity=Severity.WARNING if is_later else Severity.INFO,
    )


def _not_exported(component: Component, context: Context) -> Findings:
    """A class of a package in the workspace that its plugin description does not have."""
    if (at := component.plugin) is None:
        return
    problem = why_unknown(component.hardware, _BASE, at.span.source.path, context.resolver)
    if problem:
        yield Finding(at, f"{component.called}: {problem[0]}", problem[1])


def _other_simulator(
    component: Component, plugins: list[ControlPlugin], targets: Targets
) -> Findings:
    kinds = {plugin.kind for plugin in plugins}
    known = simulated_hardware()
    hardware = known.get(component.hardware)
    if not hardware or hardware.control in kinds or not component.plugin:
        return
    family = GZ if hardware.control == _OF_GZ else CLASSIC
    others = CLASSIC if family is GZ else GZ
    if targets.any_of(family) and not targets.any_of(others):  # the plugin is the exception
        library = control_plugin_libraries()[hardware.control]
        yield Finding(
            plugins[0].at.attributes["filename"],
            f"{plugins[0].filename} does not load hardware {hardware.name} of {component.called}, "
            f"which is for {hardware.simulator} as the robot is",
            f"load {library}",
            related=(Related(component.plugin.span, "hardware"),),
            group_key="plugin",
        )
    else:
        suitable = " or ".join(plugin.name for plugin in known.values() if plugin.control in kinds)
        yield Finding(
            component.plugin,
            f"{component.called}: {plugins[0].filename} does not load hardware {hardware.name}",
            f"use {suitable}" if suitable else "use the control plugin of the same simulator",
            related=(Related(plugins[0].at.span, "control plugin"),),
        )
