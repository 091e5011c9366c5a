"""Gazebo does not load a plugin or the render engine of the world that a launch file starts.

- A plugin of the world is for another Gazebo: `libgazebo_ros_init.so` and similar ones are for
  Gazebo Classic, `gz-sim-...-system` for gz sim. The plugin is not loaded, which Gazebo reports
  once (warning). If this applies to all plugins, the launch file starts the wrong Gazebo.
- The library or the class of a plugin is misspelt: in gz sim, `name` is the class (error).
- The render engine does not exist: cameras and lidars publish no data (error). The older `ogre`
  supports neither segmentation nor bounding box cameras: use `ogre2`, the default (warning).

Sources:
    gz-sim, SystemLoader.cc: https://github.com/gazebosim/gz-sim/blob/gz-sim8/src/SystemLoader.cc
    gz-sim, Sensors.cc: https://github.com/gazebosim/gz-sim/blob/gz-sim8/src/systems/sensors/Sensors.cc
    gz-rendering, ogre: https://github.com/gazebosim/gz-rendering/tree/gz-rendering8/ogre/src
"""

from collections.abc import Iterator

from urdfkit.checks.worlds.opened_worlds import OpenedWorld, opened_worlds
from urdfkit.checks.worlds.world_plugins import unloaded_plugins
from urdfkit.core.suggest import did_you_mean
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Severity, rule
from urdfkit.ros.catalog import data
from urdfkit.ros.gazebo.sensors import Sensor, sensors
from urdfkit.ros.launch.worlds import GZ
from urdfkit.text.source import Span

NAME = "launch/robot.launch.py"
BAD = """\
from ament_index_python.packages import get_package_share_directory
from launch.actions import ExecuteProcess

share = get_package_share_directory("cart")
gazebo = ExecuteProcess(cmd=["gz", "sim", "-r", share + "/worlds/bad.sdf"])
"""
GOOD = BAD.replace("bad.sdf", "good.sdf")
_WORLD = b"""\
<sdf version="1.9">
  <world name="hall">
    <plugin filename="gz-sim-physics-system" name="gz::sim::systems::%s"/>
  </world>
</sdf>
"""
FILES = {
    "package.xml": b"<package><name>cart</name></package>",
    "worlds/bad.sdf": _WORLD % b"Phisics",
    "worlds/good.sdf": _WORLD % b"Physics",
}


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    for opened in opened_worlds(context):
        if opened.world is not None:
            yield from opened.noted(unloaded_plugins(opened, opened.world))
        if opened.started.generation == GZ:
            yield from opened.noted(_engines(context, opened))


def _engines(context: Context, opened: OpenedWorld) -> Findings:
    """Unknown render engines, and engines that do not support a sensor of the robot."""
    known: dict[str, str] = data("worlds")["engines"]
    for place, engine in _selected_engines(opened):
        if engine not in known:
            message = f"unknown render engine '{engine}'{did_you_mean(engine, known)}"
            yield Finding(place, message, "write ogre2")
        elif sensor := next(_sensors_of(context, known[engine].split()), None):
            yield Finding(
                place,
                f"render engine {engine} does not support {sensor.type}, the type of {sensor.who}",
                "write ogre2",
                severity=Severity.WARNING,
            )


def _selected_engines(opened: OpenedWorld) -> Iterator[tuple[Location | Span, str]]:
    """The engine of the command line, otherwise of the Sensors system."""
    started = opened.started
    if started.engine:
        yield started.at, started.engine
        return
    for plugin in opened.world.plugins if opened.world is not None else ():
        engine = plugin.child("render_engine")
        if engine is not None and engine.text.strip():
            yield engine.span, engine.text.strip()


def _sensors_of(context: Context, kinds: list[str]) -> Iterator[Sensor]:
    for _, robot in context.described_robots if kinds else ():
        yield from (sensor for sensor in sensors(robot.model) if sensor.type in kinds)
