"""The transforms from odometry to the robot that the programs of a launch file publish.

Sources: ``DiffDrive.cc`` and ``OdometryPublisher.cc`` of gz-sim; the controllers of
ros2_controllers, and their parameters.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from urdfkit.core.record import Record
from urdfkit.lint.rules import Context, Location
from urdfkit.ros.catalog import data
from urdfkit.ros.controllers import Controller
from urdfkit.ros.gazebo.topics import of_plugin
from urdfkit.ros.launch.bridges import TO_GAZEBO, bridged_topics
from urdfkit.ros.launch.cartographer import configurations
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.given_parameters import given_parameter
from urdfkit.ros.launch.spawned_controllers import spawned_controllers
from urdfkit.ros.node_parameters import node_parameters
from urdfkit.text.document import Element
from urdfkit.text.located_yaml import Value

#: Controllers that publish on tf, and whether they do so by default; others have a topic for it.
_DRIVES = {
    "diff_drive_controller/DiffDriveController": True,
    "omni_wheel_drive_controller/OmniWheelDriveController": True,
    "tricycle_controller/TricycleController": False,
}
#: The nodes of robot_localization, and their default names.
_FILTERS = {"ekf_node": "ekf_filter_node", "ukf_node": "ukf_filter_node"}
#: Parameters of a filter, with their defaults.
_PARAMETERS = {
    "publish_tf": "true",
    "map_frame": "map",
    "odom_frame": "odom",
    "world_frame": "odom",
    "base_link_frame": "",  # base_link by default, but a section that is not found may set it
}
#: An option of Cartographer.
_PROVIDED = "provide_odom_frame"
#: The switch of other programs.
_TF, _GUESS = "publish_tf", "guess_frame_id"
#: Tags of Gazebo's plugins for the parent and the child frame of odometry.
_PARENTS, _CHILDREN = ("frame_id", "odom_frame"), ("child_frame_id", "robot_base_frame")


class OdometryTransform(Record):
    """A transform from odometry to the robot, and its publisher."""

    #: parent and child: the frames of odometry and of the robot; empty if unknown.
    parent: str
    child: str
    publisher: str  # for messages
    at: Location  # of the publisher; in a parameter file for a controller
    named_at: Element | None = None  # the tag that names the child in a plugin of Gazebo


def of_filters(
    programs: Iterable[StartedProgram],
    context: Context,
    parent: str = "odom_frame",
    child: str = "base_link_frame",
) -> Iterator[OdometryTransform]:
    """The transforms of robot_localization between the frames that two parameters name."""
    for program in programs:
        frames = _frames_of_filter(program, context)
        if frames and frames["world_frame"] == frames[parent] != frames[child]:
            yield OdometryTransform(frames[parent], frames[child], f"'{program.title}'", program.at)


def of_global_filters(
    programs: Iterable[StartedProgram], context: Context
) -> Iterator[OdometryTransform]:
    """The transforms of robot_localization from the map to odometry."""
    return of_filters(programs, context, "map_frame", "odom_frame")


def _frames_of_filter(program: StartedProgram, context: Context) -> dict[str, str]:
    """The frames of a filter, by parameter; empty if some are unknown, or if it publishes none."""
    if program.package != "robot_localization" or program.executable not in _FILTERS:
        return {}
    name = program.name or _FILTERS[program.executable]
    frames = dict(_PARAMETERS)
    given = program.parameters
    is_known = given.is_whole and bool(given.files or given.values)
    for path in program.parameters.files:
        source = context.resolver.readable(path)
        if source is None:
            return {}
        for node in node_parameters(source):
            if node.are_of(name):
                values = ((key, node.values.get(key)) for key in _PARAMETERS)
                frames |= {key: value.text for key, value in values if isinstance(value, Value)}
    for key, text in program.parameters.values.items():
        is_known = is_known and (key not in _PARAMETERS or text is not None)
        frames[key] = text or ""
    if not is_known or frames["publish_tf"].lower() != "true":
        return {}
    return {key: text.strip("/") for key, text in frames.items()}


def of_estimators(
    programs: Iterable[StartedProgram], context: Context
) -> Iterator[OdometryTransform]:
    """The transforms of odometry from scans or images."""
    for program in programs if not context.launch.has_scopes else ():
        keys = data("nodes")["odometry"].get(program.key)
        given = (given_parameter(program, key, context.resolver) for key in (*(keys or ()), _TF))
        parent, child, is_published = given if keys else (None, None, None)
        if parent is None or child is None or program.namespace != "":
            continue
        if given_parameter(program, _GUESS, context.resolver) != "":
            continue  # rtabmap publishes the transform to that frame instead
        if is_published is not None and is_published.lower() in ("", "true"):
            frames = ((parent or "odom").strip("/"), (child or "base_link").strip("/"))
            yield OdometryTransform(*frames, f"'{program.title}'", program.at)


def of_cartographer(
    programs: Iterable[StartedProgram], context: Context
) -> Iterator[OdometryTransform]:
    """The transforms of Cartographer: to published_frame, from odometry or from the map."""
    for configuration in configurations(programs, context.resolver):
        values = {name: option.text for name, option in configuration.options.items()}
        if _PROVIDED in values and "published_frame" in values:
            parent = values.get("odom_frame" if values[_PROVIDED] == "true" else "map_frame", "")
            publisher = f"'{configuration.program.executable}'"
            at = configuration.program.at
            yield OdometryTransform(parent, values["published_frame"], publisher, at)


def of_drives(
    programs: Iterable[StartedProgram], defined: Mapping[str, Controller]
) -> Iterator[OdometryTransform]:
    """The transforms of active wheel controllers of ros2_control.

    Args:
        defined: the controllers in parameter files, by name.
    """
    for spawned in spawned_controllers(programs):
        controller = defined.get(spawned.name) if spawned.is_activated else None
        if controller is None or controller.ros != 2 or controller.type not in _DRIVES:
            continue
        values = controller.section.values
        switches, parents = values("enable_odom_tf"), values("odom_frame_id")
        is_on = switches or _DRIVES[controller.type]
        if not is_on or any(value.text.lower() == "false" for value in switches):
            continue
        places = switches or parents
        at = places[0].span if places else controller.section.at or controller.type_at
        yield OdometryTransform(
            _first_frame(parents, "odom"),
            _first_frame(values("base_frame_id"), "base_link"),
            controller.title,
            Location(at),
        )


def _first_frame(values: list[Value], default: str) -> str:
    return values[0].text.strip("/") if values else default


def of_bridges(
    programs: Iterable[StartedProgram], context: Context, robot: Context
) -> Iterator[OdometryTransform]:
    """The transforms of Gazebo's plugins of a robot that a bridge forwards to tf."""
    for program in programs:
        for topic in bridged_topics(program, context.resolver):
            is_tf = topic.direction != TO_GAZEBO and topic.ros_topic.strip("/") == "tf"
            for plugin in robot.plugins if is_tf and not program.is_remapped else ():
                child = _first_child(plugin.at, _CHILDREN)
                is_published = any(
                    gz_topic.message == "Pose_V" and gz_topic.is_called(topic.topic)
                    for gz_topic in of_plugin(plugin.at)
                )
                if child is not None and is_published:
                    parent = _first_child(plugin.at, _PARENTS)
                    frames = (_frame(parent) if parent is not None else "", _frame(child))
                    yield OdometryTransform(*frames, plugin.title, program.at, child)


def of_classic_plugins(
    programs: Iterable[StartedProgram], robot: Context
) -> Iterator[OdometryTransform]:
    """The transforms of the drives of Gazebo Classic of a robot that is spawned there."""
    if not any(program.executable == "spawn_entity.py" for program in programs):
        return
    for use in robot.plugins:
        is_of_ros_2 = use.plugin is not None and use.plugin.generation == "classic-ros2"
        if is_of_ros_2 and use.value("publish_odom_tf").lower() in ("true", "1"):
            parent, child = use.value("odometry_frame"), use.value("robot_base_frame")
            at = Location(use.at.span)
            yield OdometryTransform(parent.strip("/"), child.strip("/"), use.title, at)


def _first_child(plugin: Element, tags: tuple[str, ...]) -> Element | None:
    return next((child for tag in tags if (child := plugin.child(tag)) is not None), None)


def _frame(element: Element) -> str:
    return element.text.strip().strip("/")
