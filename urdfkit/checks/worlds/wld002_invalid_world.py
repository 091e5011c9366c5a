"""Gazebo cannot load the world that a launch file starts, or a part of it.

- The file is not well-formed, or contains no `<world>`: Gazebo starts without a world (error). gz
  sim loads a model into the world `default`.
- The `<world>` has no name, or its `<max_step_size>` is not greater than 0 (error). A value has
  another type than in SDF, such as a `<pose>` of three numbers (error), or a number has a unit
  (warning). A model, a link or a light has no name, or an unknown type (error).
- The gravity points up, an element is misspelt, which Gazebo ignores (warnings), or a link that
  moves has no positive mass, which SDF rejects (error). A ground plane is not static, so that it
  falls with the robot (warning). Two models have the same name (warning).
- A plugin of the world is for another Gazebo: `libgazebo_ros_init.so` and similar ones are for
  Gazebo Classic, `gz-sim-...-system` for gz sim. The plugin is not loaded, which Gazebo reports
  once (warning). If this applies to all plugins, the launch file starts the wrong Gazebo.
- The library or the class of a plugin is misspelt: in gz sim, `name` is the class (error).
- The render engine does not exist: cameras and lidars publish no data (error). The older `ogre`
  supports neither segmentation nor bounding box cameras: use `ogre2`, the default (warning).
- A mesh of a model or package of the workspace does not exist (warning).
- A model that the world includes with `model://` is not in the workspace (info), or is misspelt; or
  gz sim loads `model://sun` or `model://ground_plane`, which only Gazebo Classic downloads: the
  world is not loaded unless the resource path contains the model (warning).
- The node that spawns the robot names another world than the started one: it waits for the service
  of that world for ever (error). Or the bridge forwards a topic of another world (error).

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

from urdfkit.checks.worlds.opened_worlds import OpenedWorld, opened_worlds
from urdfkit.checks.worlds.world_models import (
    falling_grounds,
    links_without_mass,
    missing_models,
    repeated_names,
)
from urdfkit.checks.worlds.world_plugins import unloaded_plugins
from urdfkit.checks.worlds.world_values import invalid_values, missing_meshes
from urdfkit.core.suggest import TYPO, did_you_mean, nearest
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Severity, rule
from urdfkit.robot.values import number, numbers
from urdfkit.ros.catalog import data
from urdfkit.ros.gazebo.sensors import Sensor, sensors
from urdfkit.ros.gazebo.worlds import Models, World
from urdfkit.ros.launch.bridges import bridged_topics
from urdfkit.ros.launch.spawning import model_spawner, options
from urdfkit.ros.launch.worlds import GZ, worlds
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

#: Topics of a world, with its name.
_OF_WORLD = re.compile(r"/?world/([^/]+)(?=/)")
#: Marks of templates from which a world is generated.
_TEMPLATES = (b"<%", b"{%", b"{{", b"@(", b"xmlns:xacro")


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    models = Models(context.resolver, context.source.path)
    started = list(opened_worlds(context))
    for opened in started:
        for finding in _of_world(opened, models, context):
            is_in_launch_file = finding.span.source is opened.started.span.source
            note = () if is_in_launch_file else opened.note
            yield finding._replace(related=(*finding.related, *note))
    if len(started) == len({world.span for world in worlds(context.launch)}) == 1:
        yield from _other_worlds(context, started[0])


def _of_world(opened: OpenedWorld, models: Models, context: Context) -> Findings:
    """The findings about a world; those in its file get a note about its start."""
    world = opened.world
    if world is not None:
        yield from _values(world)
        yield from _elements(world)
        yield from invalid_values(opened, world)
        yield from missing_meshes(opened, world, models, context)
        yield from links_without_mass(world)
        yield from falling_grounds(world)
        yield from repeated_names(opened, world)
        yield from unloaded_plugins(opened, world)
        yield from missing_models(opened, world, models)
    elif opened.path:
        yield from _unreadable(opened)
    if opened.started.generation == GZ:
        yield from _engines(context, opened)


def _unreadable(opened: OpenedWorld) -> Findings:
    source = next((problem.span.source for problem in opened.problems), None)
    file = os.path.basename(opened.path)
    error = next((problem for problem in opened.problems if problem.code == "XML001"), None)
    if source is not None and any(mark in source.data for mark in _TEMPLATES):
        return
    at = opened.started.at
    if error is not None:
        message = f"'{file}' is not a world: {error.message}"
        yield Finding(error.span, message, "fix the file")
    elif not opened.problems:
        message = f"'{file}' is not a world: it has no <world> in an <sdf>"
        yield Finding(at, message, "name a world; spawn models, or include them in a world")


def _values(world: World) -> Findings:
    """A world without a name, and an invalid time step of the physics."""
    if not world.name:
        message, help = "<world> has no name: SDF rejects it", 'write <world name="...">'
        yield Finding(world.at, message, help)
    for physics in world.at.all("physics"):
        step = physics.child("max_step_size")
        text = step.text.strip() if step is not None else ""
        value = number(text)
        if step is not None and text and (value is None or value <= 0):
            message = f"<max_step_size> is '{text}', must be a number of seconds > 0"
            yield Finding(step, message, "write 0.001")
    gravity = world.at.child("gravity")
    vector = numbers(gravity.text) if gravity is not None else None
    if gravity is not None and vector and len(vector) == 3 and vector[2] > 0:
        message = f"<gravity> points up: z is {vector[2]:g} m/s²"
        help = f"write {vector[0]:g} {vector[1]:g} {-vector[2]:g}"
        severity = Severity.WARNING
        yield Finding(gravity, message, help, severity=severity)


def _elements(world: World) -> Findings:
    """Misspelt elements, which Gazebo ignores."""
    children: dict[str, str] = data("worlds")["children"]
    for element in world.elements:
        known = children.get(element.tag, "").split()
        for child in element.children if known else ():
            meant = nearest(child.tag, known, TYPO) if child.tag not in known else None
            if meant and not element.child(meant):
                message = f"unknown element <{child.tag}> in <{element.tag}>, which Gazebo ignores"
                message += f"; did you mean <{meant}>?"
                severity = Severity.WARNING
                yield Finding(child, message, f"write <{meant}>", severity=severity)


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


def _other_worlds(context: Context, opened: OpenedWorld) -> Findings:
    """Nodes that spawn the robot into a world of another name, or forward its topics."""
    if opened.started.generation != GZ or not opened.name or not opened.started.is_sure:
        return
    for program in context.launch.programs:
        spawner = model_spawner(program)
        word = options(program, spawner)[0].get("world") if spawner else None
        name = word.text if word else program.parameters.values.get("world")
        if spawner and not spawner.is_strict and name and name != opened.name:
            span: Span = word.span if word else program.span
            yield Finding(
                Location(span, program.frame),
                f"the robot is spawned into world '{name}', but world '{opened.name}' is started",
                f"write {opened.name}, or omit the name",
            )
        for topic in bridged_topics(program, context.resolver):
            match = _OF_WORLD.match(topic.topic)
            if match and match.group(1) != opened.name:
                yield Finding(
                    Location(topic.at("gz_topic_name", "topic_name"), program.frame),
                    f"the bridge has '{topic.topic}' of world '{match.group(1)}', but world "
                    f"'{opened.name}' is started",
                    f"write /world/{opened.name}{topic.topic[match.end(1) :]}",
                )
