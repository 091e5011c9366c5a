"""A planar lidar on a robot with wheels or four feet does not scan level.

The beams of a planar lidar are in the plane perpendicular to z of its frame. If that frame is
pitched, the scan hits the floor in front of the robot, which looks like a wall, and measures other
distances to walls than at the height of the lidar; mapping and AMCL need a level scan. A vertical
scan, often due to an optical frame or a roll of 90°, measures a line of the floor. A lidar that is
mounted upside down is an info: programs that look up its frame, as AMCL does, flip the scan; other
programs show a mirrored map.

Lidars below a movable joint, with several layers, or with a narrow scan are not reported.

Sources:
    sensor_msgs, LaserScan: https://docs.ros.org/en/rolling/p/sensor_msgs/msg/LaserScan.html
    SDF, lidar: http://sdformat.org/spec?ver=1.9&elem=sensor
    nav2, AMCL: https://github.com/ros-navigation/navigation2/blob/main/nav2_amcl/src/amcl_node.cpp
"""

from math import degrees, pi, sin

from urdfkit.core.spatial import Transform
from urdfkit.lint.context import Context
from urdfkit.lint.rules import Finding, Findings, Severity, rule
from urdfkit.robot.rigid_bodies import rigid_bodies
from urdfkit.robot.samples import collision_xml, joint_xml, robot_xml
from urdfkit.ros.gazebo.drives import drive_of
from urdfkit.ros.gazebo.samples import SCANNER, solid_xml
from urdfkit.ros.gazebo.sensors import Sensor, sensors
from urdfkit.ros.gazebo.views import frame_of, planar_scan, tilt

#: Radians: lidars are adjusted by less than the first; upright or upside down within the second.
MAX_ADJUSTMENT, TOLERANCE = 0.06, 0.06
#: Least number of feet of a robot that walks level, unlike a humanoid.
_FEET = 4

BAD = robot_xml(
    solid_xml("base"),
    solid_xml("wheel", collision_xml('<sphere radius="0.1"/>')),
    joint_xml("continuous", '<axis xyz="0 1 0"/>', name="wheel_joint", child="wheel"),
    solid_xml("scanner"),
    joint_xml("fixed", '<origin xyz="0 0 0.3" rpy="0 0.3 0"/>', name="mount", child="scanner"),
    SCANNER,
)
GOOD = BAD.replace("0 0.3 0", "0 0 0.3")


@rule(Severity.WARNING, help="level the <origin> of its joint, or the <pose> of the sensor")
def check(context: Context) -> Findings:
    if not context.tree.is_sound or not _moves_level(context):
        return
    fixed = rigid_bodies(context.tree)[0].names
    for sensor in sensors(context.model):
        frame = frame_of(sensor, context.tree) if sensor.reference in fixed else None
        if frame is not None and planar_scan(sensor) and tilt(frame) > MAX_ADJUSTMENT:
            yield _finding(sensor, frame)


def _moves_level(context: Context) -> bool:
    """True for a robot with wheels or four feet that is not fixed to the world."""
    if rigid_bodies(context.tree)[0].is_ground:
        return False
    wheels = (
        joint.kind == "continuous" and "wheel" in joint.child_name.lower()
        for joint in context.model.joints
    )
    feet = sum("foot" in link.name.lower() for link in context.model.links)
    return feet >= _FEET or any(wheels) or any(map(drive_of, context.plugins))


def _finding(sensor: Sensor, frame: Transform) -> Finding:
    angle = tilt(frame)
    if angle > pi - TOLERANCE:
        message = f"{sensor.who} is upside down: seen from above, its scan runs clockwise"
        return Finding(sensor.at, message, severity=Severity.INFO)
    if abs(angle - pi / 2) < TOLERANCE:
        return Finding(sensor.at, f"{sensor.who} scans upright: z of its frame is horizontal")
    slope = min(angle, pi - angle)
    return Finding(
        sensor.at,
        f"{sensor.who} scans a plane that is inclined by {degrees(slope):.3g} deg: 1 m above the "
        f"floor it meets it after {1 / sin(slope):.3g} m",
        weight=slope,
    )
