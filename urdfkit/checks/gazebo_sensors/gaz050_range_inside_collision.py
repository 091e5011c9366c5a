"""The minimum range of a lidar is inside the collision geometry of its own link.

The rays of Gazebo hit every collision shape, including that of their own link. If the minimum range
is inside it, every ray returns the distance of the housing and the lidar detects nothing else.
Raise the minimum range, or make the collision shape smaller.

Sources:
    gazebosim/gazebo-classic#1564: https://github.com/gazebosim/gazebo-classic/issues/1564
    gazebosim/gazebo-classic#2187: https://github.com/gazebosim/gazebo-classic/issues/2187
"""

from urdfkit.core.spatial import IDENTITY
from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.robot.model import Body
from urdfkit.robot.samples import collision_xml, robot_xml
from urdfkit.ros.gazebo.samples import gazebo_xml, sensor_xml, solid_xml
from urdfkit.ros.gazebo.sensors import sensors

BAD = robot_xml(
    solid_xml("base", collision_xml('<box size="0.2 0.2 0.1"/>')),
    gazebo_xml(
        sensor_xml("lidar", "ray", "<ray><range><min>0.05</min><max>10</max></range></ray>"),
        reference="base",
    ),
)
GOOD = BAD.replace("<min>0.05</min>", "<min>0.2</min>")


@rule(Severity.WARNING, help="raise the minimum range, or make the collision shape smaller")
def check(context: Context) -> Findings:
    for sensor in sensors(context.model):
        link = context.model.links_by_name.get(sensor.reference)
        least = sensor.number(f"{sensor.lidar}/range/min") if sensor.lidar else None
        if link is None or least is None or sensor.type.startswith("gpu") or sensor.find("pose"):
            continue
        reach = max(map(_around_origin, link.collisions), default=0.0)
        if least.value < reach:
            message = f"{sensor.who}: minimum range {least.value:g} m is inside the collision of "
            yield Finding(least, f"{message}link '{link.name}', which reaches {reach:g} m")


def _around_origin(body: Body) -> float:
    """Least horizontal distance from the origin to the surface of a primitive; 0 if outside."""
    extents = body.shape.half_extents if body.shape else None
    if extents is None or body.origin.rotation != IDENTITY:
        return 0.0
    x, y, z = (abs(place) for place in body.origin.position)
    if z >= extents[2]:
        return 0.0
    return max(min(extents[0] - x, extents[1] - y), 0.0)
