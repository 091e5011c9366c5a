"""A plugin is in a place where Gazebo does not load it, or loads it wrongly.

A model plugin belongs in a `<gazebo>` block without a reference, a sensor plugin in a `<sensor>` in
the block of a link. Gazebo copies a plugin that is directly in the block of a link or joint into
that link and never loads it; a plugin of the wrong kind fails with an error about its type. A
sensor plugin requires a sensor of one type, and fails, or stops the server, in a sensor of another
type: a laser plugin requires a `ray` sensor, a GPU laser `gpu_ray`, a depth camera `depth`.

World systems of gz-sim, such as sensors and physics, run in a model as well: an info. If the world
has its own copy, every sensor is created twice and rendering crashes. Put them in the world file.

Sources:
    Gazebo Classic, plugins: https://classic.gazebosim.org/tutorials?tut=ros_gzplugins
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
    gazebo_ros_laser.cpp: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/noetic-devel/gazebo_plugins/src/gazebo_ros_laser.cpp
    Gazebo, system plugins: https://github.com/gazebosim/gz-sim/blob/main/tutorials/adding_system_plugins.md
    gazebosim/gz-sensors#497: https://github.com/gazebosim/gz-sensors/issues/497
"""

from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.robot.samples import robot_xml
from urdfkit.ros.catalog import data
from urdfkit.ros.gazebo.plugins import PluginUse
from urdfkit.ros.gazebo.samples import gazebo_xml, solid_xml

BAD = robot_xml(
    solid_xml("base"),
    gazebo_xml('<plugin name="drive" filename="libgazebo_ros_planar_move.so"/>', reference="base"),
)
GOOD = BAD.replace(' reference="base"', "")

_WHERE = {
    "model": "in a <gazebo> block without a reference",
    "sensor": "in a <sensor> in the block of a link",
    "visual": "in a <visual> in the block of a link",
    "world": "in the world file, not in a robot",
    "system": "on the command line of the server, not in a robot",
    "actor": "in an actor, not in a robot",
}

#: The sensors that are cameras, too.
_CAMERAS = ("depth", "wide_angle_camera")


@rule(Severity.ERROR, needs=(Need.MODEL, Need.GAZEBO))
def check(context: Context) -> Findings:
    known = {*context.model.links_by_name, *context.model.joints_by_name}
    for use in context.plugins:
        reference = use.block.get("reference")
        if use.place == "link" and reference not in known:
            continue  # GAZ001: the whole block is ignored
        kinds = use.plugin.kinds if use.plugin else ()
        where = " or ".join(_WHERE[kind] for kind in kinds)
        if use.place == "link":
            message = f"{use.title} is directly in <gazebo> of '{reference}' and never loaded"
            named = "" if use.filename else ", with its filename"
            yield Finding(use.at, message, f"put it {where or _WHERE['model']}{named}")
        elif _is_wrong(use, kinds):
            message = f"{use.title} is {_WHERE[use.place]}, but is a {' or '.join(kinds)} plugin"
            yield Finding(use.at, message, f"put it {where}", group_key=f"{use.place} {where}")
        elif use.plugin and kinds == ("world",) and use.plugin.generation == "gz":
            message = f"{use.title} is a world system, which belongs in the world file"
            yield Finding(use.at, message, "put it in the world file", severity=Severity.INFO)
        yield from _in_wrong_sensor(use)


def _is_wrong(use: PluginUse, kinds: tuple[str, ...]) -> bool:
    """True for a kind that Gazebo does not accept there.

    gz-sim runs a world's system in a model or sensor, too; others in a sensor find no model.
    """
    if not kinds or use.place in kinds or use.place not in ("model", "sensor", "visual"):
        return False
    assert use.plugin is not None
    is_accepted = use.place == "model" or (use.place == "sensor" and "world" in kinds)
    return not (use.plugin.generation == "gz" and is_accepted)


def _in_wrong_sensor(use: PluginUse) -> Findings:
    if use.place != "sensor" or use.plugin is None or not use.plugin.sensors:
        return
    if use.plugin.kinds == ("world",):
        return  # it serves all sensors of the world, in any of them
    assert use.at.parent is not None
    attribute = use.at.parent.attributes.get("type")
    if attribute is None:
        return
    same: dict[str, str] = data("sensors")["same"]
    accepted = {same.get(kind, kind) for kind in use.plugin.sensors}
    kind = same.get(attribute.value, attribute.value)
    if kind in accepted or (kind in _CAMERAS and "camera" in accepted):
        return
    required = " or ".join(f"'{type}'" for type in use.plugin.sensors)
    message = f"{use.title} needs a sensor of type {required}, but this one is '{attribute.value}'"
    yield Finding(attribute, message, f"write type {required}, or use another plugin")
