"""Gazebo does not load the world that a launch file starts, or not all of it.

- The file is not well-formed, or holds no `<world>`: Gazebo starts without a world (error).
- The `<world>` has no name, or its `<max_step_size>` is not above 0 (error).
- A plugin of the world is for another Gazebo: `libgazebo_ros_init.so` and the like are for Gazebo
  Classic, `gz-sim-...-system` for gz sim. It is not loaded, which Gazebo reports once (warning).
  If that is true of all, the launch file starts the world in the wrong Gazebo.
- The library or the class of a plugin is misspelt: `name` is the class in gz sim (error).
- A render engine that does not exist: no camera and no lidar gives data (error). `ogre`, the older
  one, has no segmentation and no bounding box camera: use `ogre2`, the default (warning).
- A model that the world includes by `model://` is not in the workspace, although others are; or
  gz sim is to find `model://sun` or `model://ground_plane`, which Gazebo Classic downloaded: the
  world is not loaded unless the resource path has it (warning).
- The node that spawns the robot names another world than the one that is started: it waits for the
  service of that world for ever (error).

Sources:
    gz-sim, SystemLoader.cc: https://github.com/gazebosim/gz-sim/blob/gz-sim8/src/SystemLoader.cc
    gz-sim, Server.cc: https://github.com/gazebosim/gz-sim/blob/gz-sim8/src/Server.cc
    gz-sim, Sensors.cc: https://github.com/gazebosim/gz-sim/blob/gz-sim8/src/systems/sensors/Sensors.cc
    gz-rendering, ogre: https://github.com/gazebosim/gz-rendering/tree/gz-rendering8/ogre/src
    Gazebo, migration of SDF: https://github.com/gazebosim/gz-sim/blob/gz-sim8/tutorials/migration_sdf.md
    ros_gz_sim, create.cpp: https://github.com/gazebosim/ros_gz/blob/ros2/ros_gz_sim/src/create.cpp
"""

import os
import re
from collections.abc import Iterator

from urdfkit.checks.worlds.opened import OpenedWorld, opened_worlds
from urdfkit.core.suggest import did_you_mean, nearest
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Severity, rule
from urdfkit.robot.values import number
from urdfkit.ros.catalog import data
from urdfkit.ros.catalog.plugins import TITLES, find, misspelt
from urdfkit.ros.gazebo.sensors import Sensor, sensors
from urdfkit.ros.gazebo.worlds import Models, World, model_name
from urdfkit.ros.launch.spawning import options, spawner_of
from urdfkit.ros.launch.worlds import GZ, worlds
from urdfkit.text.document import Element
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

#: Gazebo Classic and gz-sim.
_TITLES = ("Gazebo Classic", TITLES[GZ])
#: What only Gazebo Classic has, by the name of the library.
_CLASSIC = re.compile(r"(lib)?gazebo_ros_\w+(\.so)?$")
_FUEL = "https://fuel.gazebosim.org/1.0/OpenRobotics/models/"
#: Marks of files from which a world is made.
_TEMPLATES = (b"<%", b"{%", b"{{", b"@(", b"xmlns:xacro")


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    models = Models(context.resolver, context.source.path)
    found = list(opened_worlds(context))
    for opened in found:
        if opened.world is None and opened.path:
            yield from _unreadable(opened)
        elif opened.world is not None:
            yield from _values(opened, opened.world)
            yield from _of_other_gazebo(opened, opened.world) or _plugins(opened, opened.world)
            yield from _includes(opened, opened.world, models)
        if opened.started.generation == GZ:
            yield from _engines(context, opened)
    if len(found) == len({one.span for one in worlds(context.launch)}) == 1:
        yield from _other_worlds(context, found[0])


def _unreadable(opened: OpenedWorld) -> Findings:
    source = next((one.span.source for one in opened.problems), None)
    file = os.path.basename(opened.path)
    broken = next((one for one in opened.problems if one.code == "XML001"), None)
    if source is not None and any(mark in source.data for mark in _TEMPLATES):
        return
    at = Location(opened.started.span, opened.started.frame)
    if broken is not None:
        message = f"'{file}' is not a world: {broken.message}"
        yield Finding(Location(broken.span), message, "fix the file", related=opened.note)
    elif not opened.problems:
        message = f"'{file}' is not a world: it has no <world> in an <sdf>"
        yield Finding(at, message, "name a world; models are spawned, or included by one")


def _values(opened: OpenedWorld, world: World) -> Findings:
    """A world without a name, and a step of physics that is no time."""
    if not world.name:
        message, help = "the <world> has no name: SDF rejects it", 'write <world name="...">'
        yield Finding(world.at, message, help, related=opened.note)
    for physics in world.at.all("physics"):
        step = physics.child("max_step_size")
        text = step.text.strip() if step is not None else ""
        value = number(text)
        if step is not None and text and (value is None or value <= 0):
            message = f"<max_step_size> is '{text}', must be a number of seconds > 0"
            yield Finding(step, message, "write 0.001", related=opened.note)


def _of_other_gazebo(opened: OpenedWorld, world: World) -> list[Finding]:
    """A world all of whose plugins are for the other Gazebo: what is wrong is who starts it."""
    is_gz = opened.started.generation == GZ
    kinds = [_is_of_gz(plugin) for plugin in world.plugins]
    if len(kinds) < 2 or any(kind != {not is_gz} for kind in kinds):
        return []
    other, own = (_TITLES[is_one] for is_one in (not is_gz, is_gz))
    message = f"{opened.title} is for {other}, and is started in {own}, which loads none of its "
    message += f"{len(kinds)} plugins"
    place = Location(opened.started.span, opened.started.frame)
    help = f"start it in {other}, or name a world for {own}"
    return [Finding(place, message, help, severity=Severity.WARNING)]


def _is_of_gz(plugin: Element) -> set[bool]:
    """Whether a plugin is for gz sim; both where either has it, and empty if it is unknown."""
    file = (plugin.get("filename") or "").strip()
    found = {one.generation == GZ for one in find(file)}
    return found or ({False} if _CLASSIC.match(file) else set())


def _plugins(opened: OpenedWorld, world: World) -> Findings:
    is_gz = opened.started.generation == GZ
    for plugin in world.plugins:
        at = plugin.attributes.get("filename")
        file = (at.value if at else "").strip()
        is_of_gz = _is_of_gz(plugin)
        title = f"plugin '{plugin.get('name') or ''}' ({file})"
        if at is not None and not is_of_gz and (suggested := misspelt(file)):
            message = f"{title}: unknown plugin library"
            help = f"did you mean '{suggested}'?"
            yield Finding(at, message, help, related=opened.note)
        elif at is not None and is_of_gz and is_gz not in is_of_gz:
            other, own = _TITLES[not is_gz], _TITLES[is_gz]
            yield Finding(
                at,
                f"{title} is for {other}, and {opened.title} is started in {own}: it is not loaded",
                "remove it",
                related=opened.note,
                group_key=opened.path,
                severity=Severity.WARNING,
            )
        elif is_gz:
            yield from _classes(opened, plugin, title)


def _classes(opened: OpenedWorld, plugin: Element, title: str) -> Findings:
    """A class that the library does not have."""
    name = plugin.attributes.get("name")
    known = find((plugin.get("filename") or "").strip())
    classes = [one.class_name for one in known if one.generation == GZ]
    written = re.sub(r"::v\d+\b", "", name.value if name else "")
    if name is None or not classes or not all(classes):
        return
    if written.replace("ignition::gazebo", "gz::sim") not in classes:
        message = f"{title}: the library has no class '{name.value}', only {' or '.join(classes)}"
        yield Finding(name, message, f'write name="{classes[0]}"', related=opened.note)


def _includes(opened: OpenedWorld, world: World, models: Models) -> Findings:
    """The models that are not found; other machines may have more than this one."""
    missing = [(at, uri) for at, uri in world.includes if model_name(uri) and not models.has(uri)]
    for at, uri in missing:
        name = model_name(uri)
        fuel = data("worlds")["models"].get(name)
        if suggested := nearest(name, models.directories, 0.8):
            message = f"model '{uri}' is not found; did you mean '{suggested}'?"
            help = f"write model://{suggested}"
        elif fuel and opened.started.generation == GZ:
            message = f"gz sim does not come with '{uri}', which Gazebo Classic downloads"
            help = f"write {_FUEL}{fuel}, or the model itself"
        else:
            continue
        yield Finding(at, message, help, related=opened.note, severity=Severity.WARNING)


def _engines(context: Context, opened: OpenedWorld) -> Findings:
    """The render engines that do not exist, or lack a type of sensor of the robot."""
    known: dict[str, str] = data("worlds")["engines"]
    for place, engine in _chosen(opened):
        if engine not in known:
            message = f"unknown render engine '{engine}'{did_you_mean(engine, known)}"
            yield Finding(place, message, "write ogre2", related=opened.note)
        elif sensor := next(_lacking(context, known[engine].split()), None):
            message = f"the render engine {engine} has no {sensor.type}, which {sensor.who} is"
            yield Finding(
                place, message, "write ogre2", related=opened.note, severity=Severity.WARNING
            )


def _chosen(opened: OpenedWorld) -> Iterator[tuple[Location, str]]:
    """The engine of the command line, which wins; else that of the Sensors system."""
    started = opened.started
    if started.engine:
        yield Location(started.span, started.frame), started.engine
        return
    for plugin in opened.world.plugins if opened.world is not None else ():
        engine = plugin.child("render_engine")
        if engine is not None and engine.text.strip():
            yield Location(engine.span), engine.text.strip()


def _lacking(context: Context, kinds: list[str]) -> Iterator[Sensor]:
    for _, robot in context.described_robots if kinds else ():
        yield from (one for one in sensors(robot.model) if one.type in kinds)


def _other_worlds(context: Context, opened: OpenedWorld) -> Findings:
    """The nodes that spawn into a world of another name."""
    if opened.started.generation != GZ or not opened.name or not opened.started.is_sure:
        return
    for started in (*context.launch.started, *context.launch.included):
        spawner = spawner_of(started)
        word = options(started, spawner)[0].get("world") if spawner else None
        given = word.text if word else started.parameters.values.get("world")
        if spawner and not spawner.is_strict and given and given != opened.name:
            span: Span = word.span if word else started.span
            yield Finding(
                Location(span, started.frame),
                f"the robot is spawned into world '{given}', and world '{opened.name}' is started",
                f"write {opened.name}, or leave the name out",
            )
