"""Gazebo cannot load the world that a launch file starts, or a part of it.

- The file is not well-formed, or contains no `<world>`: Gazebo starts without a world (error).
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
from urdfkit.checks.worlds.world_plugins import unloaded_plugins
from urdfkit.checks.worlds.world_values import invalid_values, missing_meshes
from urdfkit.core.suggest import TYPO, did_you_mean, nearest
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Related, Severity, rule
from urdfkit.robot.values import number, numbers
from urdfkit.ros.catalog import data
from urdfkit.ros.gazebo.sensors import Sensor, sensors
from urdfkit.ros.gazebo.worlds import Models, World, model_name
from urdfkit.ros.launch.bridges import bridged_topics
from urdfkit.ros.launch.spawning import model_spawner, options
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

#: Topics of a world, with its name.
_OF_WORLD = re.compile(r"/?world/([^/]+)(?=/)")
_FUEL = "https://fuel.gazebosim.org/1.0/OpenRobotics/models/"
#: Marks of templates from which a world is generated.
_TEMPLATES = (b"<%", b"{%", b"{{", b"@(", b"xmlns:xacro")


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    models = Models(context.resolver, context.source.path)
    started = list(opened_worlds(context))
    for opened in started:
        if opened.world is None and opened.path:
            yield from _unreadable(opened)
        elif opened.world is not None:
            yield from _values(opened, opened.world)
            yield from _elements(opened, opened.world)
            yield from invalid_values(opened, opened.world)
            yield from missing_meshes(opened, opened.world, models, context)
            yield from _masses(opened, opened.world)
            yield from _falling_grounds(opened, opened.world)
            yield from _names(opened, opened.world)
            yield from unloaded_plugins(opened, opened.world)
            yield from _includes(opened, opened.world, models)
        if opened.started.generation == GZ:
            yield from _engines(context, opened)
    if len(started) == len({world.span for world in worlds(context.launch)}) == 1:
        yield from _other_worlds(context, started[0])


def _unreadable(opened: OpenedWorld) -> Findings:
    source = next((problem.span.source for problem in opened.problems), None)
    file = os.path.basename(opened.path)
    error = next((problem for problem in opened.problems if problem.code == "XML001"), None)
    if source is not None and any(mark in source.data for mark in _TEMPLATES):
        return
    at = opened.started.at
    if error is not None:
        message = f"'{file}' is not a world: {error.message}"
        yield Finding(error.span, message, "fix the file", related=opened.note)
    elif not opened.problems:
        message = f"'{file}' is not a world: it has no <world> in an <sdf>"
        yield Finding(at, message, "name a world; spawn models, or include them in a world")


def _values(opened: OpenedWorld, world: World) -> Findings:
    """A world without a name, and an invalid time step of the physics."""
    if not world.name:
        message, help = "<world> has no name: SDF rejects it", 'write <world name="...">'
        yield Finding(world.at, message, help, related=opened.note)
    for physics in world.at.all("physics"):
        step = physics.child("max_step_size")
        text = step.text.strip() if step is not None else ""
        value = number(text)
        if step is not None and text and (value is None or value <= 0):
            message = f"<max_step_size> is '{text}', must be a number of seconds > 0"
            yield Finding(step, message, "write 0.001", related=opened.note)
    gravity = world.at.child("gravity")
    vector = numbers(gravity.text) if gravity is not None else None
    if gravity is not None and vector and len(vector) == 3 and vector[2] > 0:
        message = f"<gravity> points up: z is {vector[2]:g} m/s²"
        help = f"write {vector[0]:g} {vector[1]:g} {-vector[2]:g}"
        severity = Severity.WARNING
        yield Finding(gravity, message, help, related=opened.note, severity=severity)


def _elements(opened: OpenedWorld, world: World) -> Findings:
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
                yield Finding(
                    child, message, f"write <{meant}>", related=opened.note, severity=severity
                )


def _names(opened: OpenedWorld, world: World) -> Findings:
    """Models and lights of one name, of which SDF reads only one."""
    first: dict[str, Element] = {}
    for element in world.at.children:
        if element.tag not in ("light", "model"):
            continue
        name = element.get("name") or ""
        other = first.setdefault(name, element)
        if name and other is not element:
            yield Finding(
                element,
                f"{opened.title} has two elements with the name '{name}', which SDF rejects",
                "give each model and light a name of its own",
                related=(Related(other.span, "the first one"), *opened.note),
                severity=Severity.WARNING,
            )


def _masses(opened: OpenedWorld, world: World) -> Findings:
    """Links of models that move, without a positive mass."""
    for model in world.at.all("model"):
        for link in () if _is_static(model) else model.all("link"):
            inertial = link.child("inertial")
            mass = inertial.child("mass") if inertial is not None else None
            value = number(mass.text.strip()) if mass is not None else None
            if mass is not None and value is not None and value <= 0:
                message = f"<mass> is {value:g} kg, must be > 0: SDF rejects the link"
                yield Finding(mass, message, "write the mass in kg", related=opened.note)


def _falling_grounds(opened: OpenedWorld, world: World) -> Findings:
    """A ground that is not static, and no joint holds: it falls, and the robot with it."""
    for model in () if world.is_weightless else world.at.all("model"):
        links = list(model.all("link"))
        is_held = model.child("joint") is not None or any(
            link.child("gravity") is not None for link in links
        )
        if _is_static(model) or is_held:
            continue
        collisions = (part for link in links for part in link.all("collision"))
        shapes = [shape for part in collisions for shape in part.all("geometry")]
        if any(shape.child("plane") is not None for shape in shapes):
            message = f"plane of model '{model.get('name') or ''}', which is not static, falls"
            yield Finding(
                model.child_or_self("static"),
                message,
                "write <static>true</static>",
                related=opened.note,
                severity=Severity.WARNING,
            )


def _is_static(model: Element) -> bool:
    static = model.child("static")
    return static is not None and static.text.strip().lower() in ("1", "true")


def _includes(opened: OpenedWorld, world: World, models: Models) -> Findings:
    """Missing models, only with a typo or a replacement: other machines may have more models."""
    missing = [(at, uri) for at, uri in world.includes if model_name(uri) and not models.has(uri)]
    for at, uri in missing:
        name = model_name(uri)
        fuel = data("worlds")["models"].get(name)
        if suggested := nearest(name, models.directories, TYPO):
            message = f"model '{uri}' is not found; did you mean '{suggested}'?"
            help = f"write model://{suggested}"
        elif fuel and opened.started.generation == GZ:
            message = f"gz sim does not have '{uri}', which Gazebo Classic downloads"
            help = f"write {_FUEL}{fuel}, or the model itself"
        elif opened.started.generation == GZ:
            message = f"model '{uri}' is not in the workspace: without it the world is not loaded"
            help = "add its parent directory to GZ_SIM_RESOURCE_PATH, or write the model itself"
        else:
            continue
        severity = Severity.WARNING if suggested or fuel else Severity.INFO
        yield Finding(at, message, help, related=opened.note, severity=severity)


def _engines(context: Context, opened: OpenedWorld) -> Findings:
    """Unknown render engines, and engines that do not support a sensor of the robot."""
    known: dict[str, str] = data("worlds")["engines"]
    for place, engine in _selected_engines(opened):
        if engine not in known:
            message = f"unknown render engine '{engine}'{did_you_mean(engine, known)}"
            yield Finding(place, message, "write ogre2", related=opened.note)
        elif sensor := next(_sensors_of(context, known[engine].split()), None):
            yield Finding(
                place,
                f"render engine {engine} does not support {sensor.type}, the type of {sensor.who}",
                "write ogre2",
                related=opened.note,
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
