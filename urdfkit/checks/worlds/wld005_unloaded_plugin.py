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

import re
from collections.abc import Iterator

from urdfkit.checks.worlds.opened_worlds import OpenedWorld, opened_worlds
from urdfkit.core.suggest import did_you_mean
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Severity, rule
from urdfkit.ros.catalog import data
from urdfkit.ros.catalog.plugins import TITLES, find, misspelt, system_of_class
from urdfkit.ros.gazebo.sensors import Sensor, sensors
from urdfkit.ros.gazebo.worlds import World
from urdfkit.ros.launch.samples import WORLD_LAUNCH, world_files
from urdfkit.ros.launch.worlds import GZ
from urdfkit.text.document import Element
from urdfkit.text.source import Span

NAME = "launch/robot.launch.py"
BAD = WORLD_LAUNCH
GOOD = BAD.replace("bad.sdf", "good.sdf")
FILES = world_files(
    '<plugin filename="gz-sim-physics-system" name="gz::sim::systems::Phisics"/>',
    '<plugin filename="gz-sim-physics-system" name="gz::sim::systems::Physics"/>',
)

#: Gazebo Classic and gz-sim.
_TITLES = ("Gazebo Classic", TITLES[GZ])
#: Libraries that only Gazebo Classic has.
_CLASSIC = re.compile(r"(lib)?gazebo_ros_\w+(\.so)?$")


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    for opened in opened_worlds(context):
        if opened.world is not None:
            yield from opened.noted(_unloaded_plugins(opened, opened.world))
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


def _unloaded_plugins(opened: OpenedWorld, world: World) -> Findings:
    """All plugins if they are for the other Gazebo, otherwise each one that is not loaded."""
    yield from _other_gazebo(opened, world) or _plugins(opened, world)


def _other_gazebo(opened: OpenedWorld, world: World) -> list[Finding]:
    """A world whose plugins are all for the other Gazebo, so that the wrong Gazebo is started."""
    is_gz = opened.started.generation == GZ
    kinds = [_generations(plugin) for plugin in world.plugins]
    if len(kinds) < 2 or any(kind != {not is_gz} for kind in kinds):
        return []
    other, own = _TITLES[not is_gz], _TITLES[is_gz]
    message = f"{opened.title} is for {other}, but is started in {own}, which loads none of its "
    message += f"{len(kinds)} plugins"
    help = f"start it in {other}, or name a world for {own}"
    return [Finding(opened.started.at, message, help, severity=Severity.WARNING)]


def _generations(plugin: Element) -> set[bool]:
    """Whether a plugin is for gz sim: both values if both have it, empty if it is unknown."""
    file = (plugin.get("filename") or "").strip()
    generations = {known.generation == GZ for known in find(file)}
    return generations or ({False} if _CLASSIC.match(file) else set())


def _plugins(opened: OpenedWorld, world: World) -> Findings:
    is_gz = opened.started.generation == GZ
    for plugin in world.plugins:
        at = plugin.attributes.get("filename")
        file = (at.value if at else "").strip()
        is_of_gz = _generations(plugin)
        title = f"plugin '{plugin.get('name') or ''}' ({file})"
        suggested = misspelt(file) or system_of_class(file, plugin.get("name") or "")
        if at is not None and not is_of_gz and suggested:
            message = f"{title}: unknown plugin library"
            help = f"did you mean '{suggested}'?"
            yield Finding(at, message, help)
        elif at is not None and is_of_gz and is_gz not in is_of_gz:
            other, own = _TITLES[not is_gz], _TITLES[is_gz]
            yield Finding(
                at,
                f"{title} is for {other}, but {opened.title} is started in {own}: it is not loaded",
                "remove it",
                group_key=opened.path,
                severity=Severity.WARNING,
            )
        elif is_gz:
            yield from _classes(opened, plugin, title)


def _classes(opened: OpenedWorld, plugin: Element, title: str) -> Findings:
    """A class that the library does not have."""
    name = plugin.attributes.get("name")
    known = find((plugin.get("filename") or "").strip())
    classes = [plugin.class_name for plugin in known if plugin.generation == GZ]
    written = re.sub(r"::v\d+\b", "", name.value if name else "")
    if name is None or not classes or not all(classes):
        return
    if written.replace("ignition::gazebo", "gz::sim") not in classes:
        if written.startswith("ignition::"):  # Fortress and older ones
            classes = [one.replace("gz::sim", "ignition::gazebo") for one in classes]
        message = f"{title}: the library has no class '{name.value}', only {' or '.join(classes)}"
        yield Finding(name, message, f'write name="{classes[0]}"')
