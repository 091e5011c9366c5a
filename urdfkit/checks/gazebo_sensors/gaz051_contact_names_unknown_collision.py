"""A contact sensor refers to no collision, or to one that its link does not have in Gazebo.

Gazebo renames collisions when it converts URDF: an unnamed collision becomes `LINK_collision`, and
collisions of merged links become `PARENT_fixed_joint_lump__LINK_collision`. A sensor that refers to
another name, or to none, never detects a contact.

Sources:
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
    ros-simulation/gazebo_ros_pkgs#155: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/155
    ros-simulation/gazebo_ros_pkgs#260: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/260
"""

from urdfkit.core.suggest import Suggester
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.robot.samples import collision_xml, robot_xml
from urdfkit.ros.gazebo.samples import gazebo_xml, sensor_xml, solid_xml
from urdfkit.ros.gazebo.sensors import Sensor, sensors
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import fix_value

BAD = robot_xml(
    solid_xml("base", collision_xml('<sphere radius="0.1"/>')),
    gazebo_xml(
        sensor_xml("bumper", "contact", "<contact><collision>base_colision</collision></contact>"),
        reference="base",
    ),
)
FIXED = GOOD = BAD.replace("base_colision", "base_collision")


@rule(
    Severity.ERROR,
    needs=(Need.MODEL, Need.GAZEBO),
    help="name the collision as Gazebo does; 'urdfkit gazebo' lists the names",
)
def check(context: Context) -> Findings:
    for sensor in sensors(context.model):
        if sensor.type == "contact" and sensor.find("contact/collision") is None:
            message = f"{sensor.who}: no <collision> in <contact>, so it detects no contact"
            yield Finding(sensor.at, message, "add <contact> with a <collision> of its link")
        for contact in sensor.at.all("contact"):
            if named := contact.child("collision"):
                yield from _unknown_collision(context, sensor, named)


def _unknown_collision(context: Context, sensor: Sensor, named: Element) -> Findings:
    link = context.gazebo.survivor.get(sensor.reference)
    simulated = next((one for one in context.gazebo.links if one.name == link), None)
    known = dict(simulated.collisions) if simulated else {}
    name = named.text.strip()
    if simulated is None or name in known or name == "__default__":
        return
    renamed = [new for new, at in known.items() if name in _called(at)]
    suggested = renamed[0] if len(renamed) == 1 else Suggester(known).suggested(name)
    what = "its name in Gazebo is '{}'" if len(renamed) == 1 else "did you mean '{}'?"
    hint = f"; {what.format(suggested)}" if suggested else ""
    message = f"{sensor.who}: unknown collision '{name}' of link '{link}'{hint}"
    yield Finding(named, message, fix=fix_value(named, suggested))


def _called(collision: Element) -> tuple[str, ...]:
    """Names that a collision may be expected to have in Gazebo."""
    own = collision.get("name") or ""
    link = collision.parent.get("name") if collision.parent else ""
    return (own, f"{own}_collision", f"{link}_collision")
