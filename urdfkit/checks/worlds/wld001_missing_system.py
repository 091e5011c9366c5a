"""Gazebo is started without a system that the robot requires.

In gz sim, cameras and lidars publish no data without the system `Sensors`, and IMUs without `Imu`;
there is no message. A world without a `<plugin>` loads the systems of the server configuration,
only `Physics`, `UserCommands` and `SceneBroadcaster`. Up to Gazebo Harmonic, a world with a
`<plugin>` loads only its own plugins: without `UserCommands` the node that spawns the robot waits
for ever, without `Physics` nothing moves, and without `SceneBroadcaster` the window is empty. Since
Gazebo Ionic, the systems of the configuration are added to those of the world.

Gazebo Classic lacks only the library `libgazebo_ros_factory.so`, which the launch files of
gazebo_ros load, but `gazebo` or `gzserver` alone does not: `spawn_entity.py` stops with "Was Gazebo
started with GazeboRosFactory?" (error).

NavSat sensors publish no data in a world without `<spherical_coordinates>`.

Not reported if the robot or a model in the world loads the system, or if a launch file sets
`GZ_SIM_SERVER_CONFIG_PATH`.

Sources:
    server configuration: https://github.com/gazebosim/gz-sim/blob/gz-sim10/tutorials/server_config.md
    gz-sim, SimulationRunner.cc: https://github.com/gazebosim/gz-sim/blob/gz-sim8/src/SimulationRunner.cc
    gz-sim, server.config: https://github.com/gazebosim/gz-sim/blob/gz-sim8/include/gz/sim/server.config
    sensors: https://gazebosim.org/docs/harmonic/sensors
"""

from collections.abc import Iterator

from urdfkit.checks.worlds.opened_worlds import OpenedWorld, opened_worlds
from urdfkit.lint.rules import Context, Finding, Findings, Need, Related, Severity, rule
from urdfkit.ros.catalog.plugins import Plugin, all_plugins
from urdfkit.ros.catalog.sensors import type_in_gz
from urdfkit.ros.gazebo.samples import gazebo_xml, sensor_xml, solid_xml
from urdfkit.ros.gazebo.sensors import Sensor, sensors
from urdfkit.ros.gazebo.worlds import Models, all_systems, default_systems, own_systems, systems_in
from urdfkit.ros.launch.samples import CART_LAUNCH, world_files
from urdfkit.ros.launch.spawning import model_spawner
from urdfkit.ros.launch.worlds import FACTORY, GZ

NAME = "launch/robot.launch.py"
BAD = CART_LAUNCH
GOOD = BAD.replace("bad.sdf", "good.sdf")
_SYSTEMS = """\
<plugin filename="gz-sim-physics-system" name="gz::sim::systems::Physics"/>
<plugin filename="gz-sim-user-commands-system" name="gz::sim::systems::UserCommands"/>
<plugin filename="gz-sim-scene-broadcaster-system" name="gz::sim::systems::SceneBroadcaster"/>
"""
_SENSORS = '<plugin filename="gz-sim-sensors-system" name="gz::sim::systems::Sensors"/>\n'
_CAMERA = sensor_xml("front", "camera", "<update_rate>30</update_rate>")
FILES = world_files(
    _SYSTEMS, _SYSTEMS + _SENSORS, solid_xml("base"), gazebo_xml(_CAMERA, reference="base")
)

#: The effect of a missing default system.
_EFFECTS = {
    "Physics": "nothing moves",
    "UserCommands": "the node that spawns the robot waits for ever",
    "SceneBroadcaster": "the window of Gazebo stays empty",
}
_CONFIGURED = b"SERVER_CONFIG_PATH"


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    files = {include.span.source.path: include.span.source for include in context.launch.includes}
    if any(_CONFIGURED in file.data for file in (context.source, *files.values())):
        return
    required = _required(context)
    models = Models(context.resolver, context.source.path)
    robot_files = [use.filename for _, robot in context.described_robots for use in robot.plugins]
    for opened in opened_worlds(context):
        if opened.path and opened.world is None:
            continue
        if opened.started.generation != GZ:
            yield from _without_factory(context, opened)
            continue
        loaded = opened.systems | systems_in(robot_files)
        if opened.world is not None:
            loaded |= all_systems(opened.world, models)
            yield from _without_coordinates(required, opened)
            yield from _without_defaults(context, opened, loaded)
        for plugin, sensor in required:
            if plugin.system not in loaded:
                yield Finding(
                    opened.place,
                    f"{opened.title} does not load the system {plugin.system}, without which "
                    f"{sensor.who} ({sensor.type}) publishes no data",
                    _help(plugin, opened),
                    related=(Related(sensor.at.span, sensor.who), *opened.note),
                )


def _without_coordinates(required: list[tuple[Plugin, Sensor]], opened: OpenedWorld) -> Findings:
    """A world without a location on Earth, and a robot with a NavSat sensor."""
    if opened.world is None or opened.world.at.child("spherical_coordinates"):
        return
    for sensor in (sensor for _, sensor in required if type_in_gz(sensor.type) == "navsat"):
        yield Finding(
            opened.place,
            f"{opened.title} has no <spherical_coordinates>, without which {sensor.who} "
            "(navsat) publishes no data",
            "add <spherical_coordinates> with latitude_deg, longitude_deg and elevation",
            related=(Related(sensor.at.span, sensor.who), *opened.note),
        )


def _without_factory(context: Context, opened: OpenedWorld) -> Findings:
    """Gazebo Classic without the library that ``spawn_entity.py`` requires."""
    plugins = opened.world.plugins if opened.world is not None else []
    files = {*opened.started.libraries, *(plugin.get("filename") for plugin in plugins)}
    spawners = context.launch.programs
    spawns = any(node.executable == "spawn_entity.py" and model_spawner(node) for node in spawners)
    if spawns and FACTORY not in files:
        yield Finding(
            opened.started.at,
            f"Gazebo is started without {FACTORY}, which spawn_entity.py requires",
            f"add -s libgazebo_ros_init.so -s {FACTORY}, or include gazebo.launch.py of gazebo_ros",
            severity=Severity.ERROR,
        )


def _required(context: Context) -> list[tuple[Plugin, Sensor]]:
    """Systems that sensors of the robots require, each with the first sensor."""
    required: dict[str, tuple[Plugin, Sensor]] = {}
    systems = [
        plugin for plugin in all_plugins() if plugin.generation == GZ and "world" in plugin.kinds
    ]
    for _, robot in context.described_robots:
        for sensor in sensors(robot.model):
            for plugin in systems:
                if type_in_gz(sensor.type) in plugin.sensors:
                    required.setdefault(plugin.id, (plugin, sensor))
    return list(required.values())


def _without_defaults(context: Context, opened: OpenedWorld, loaded: frozenset[str]) -> Findings:
    """Default systems that a world with plugins lacks."""
    world = opened.world
    if world is None or not own_systems(world) or world.loads_default_systems():
        return
    until = "" if world.loads_default_systems() is False else " (up to Gazebo Harmonic)"
    missing = set(_required_defaults(context, opened)) - loaded
    for plugin in all_plugins():
        system = plugin.system
        if system in missing and plugin.generation == GZ and system in default_systems():
            message = f"{opened.title} loads plugins, but not the system {system}: "
            message += f"{_EFFECTS[system]}{until}"
            yield Finding(opened.place, message, _help(plugin, opened), related=opened.note)


def _required_defaults(context: Context, opened: OpenedWorld) -> Iterator[str]:
    if any(True for _ in context.described_robots):
        yield "Physics"
    if any(map(model_spawner, context.launch.programs)):
        yield "UserCommands"
    if opened.started.has_window:
        yield "SceneBroadcaster"


def _help(plugin: Plugin, opened: OpenedWorld) -> str:
    line = f'<plugin filename="{plugin.files[0]}" name="{plugin.class_name}"/>'
    if opened.path:
        return f"add {line} to the world"
    return f"add {line} to the robot, in a separate <gazebo>, or start a world that has it"
