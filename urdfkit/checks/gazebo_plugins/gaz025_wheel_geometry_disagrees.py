"""A drive plugin takes the wheels for larger, smaller or farther apart than they are.

The plugin computes wheel speeds and odometry from its own numbers: with a wrong diameter the robot
drives too fast or too slow and measures too little or too much, with a wrong separation it turns by
the wrong angle. The model says where the wheels are and, if their collision is a cylinder or a
sphere, how large. A separation larger than the track is left alone where the wheels slip in turns.

Sources:
    gazebo_ros_diff_drive.cpp of ROS 2: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_plugins/src/gazebo_ros_diff_drive.cpp
    AutonomyLab/create_robot#77: https://github.com/AutonomyLab/create_robot/issues/77
    ros-simulation/gazebo_ros_pkgs#317: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/317
"""

from __future__ import annotations

from urdfkit.core.spatial import dot, minus
from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Need, rule
from urdfkit.ros.gazebo.drives import DriveKind, Wheel, drive_of, given, pairs, wheels
from urdfkit.ros.gazebo.plugins import PluginUse
from urdfkit.ros.gazebo.samples import WHEELED
from urdfkit.text.diagnostic import Severity
from urdfkit.text.document import Attribute, Element

#: Relative difference; real robots are calibrated within this.
TOLERANCE = 0.05

BAD = (
    WHEELED
    + """\
<gazebo>
  <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
    <leftJoint>left_joint</leftJoint>
    <rightJoint>right_joint</rightJoint>
    <wheelSeparation>0.3</wheelSeparation>
    <wheelDiameter>0.1</wheelDiameter>
  </plugin>
</gazebo>"""
)
GOOD = BAD.replace("<wheelDiameter>0.1<", "<wheelDiameter>0.2<")


@rule(Severity.WARNING, needs=(Need.MODEL, Need.GAZEBO))
def check(subject: Subject) -> Findings:
    for use in subject.plugins:
        kind = drive_of(use)
        if kind is not None:
            found = list(wheels(use, subject.tree))
            yield from _size(use, kind, found)
            yield from _separation(use, kind, found)


def _size(use: PluginUse, kind: DriveKind, found: list[Wheel]) -> Findings:
    radii = [radius for wheel in found if (radius := wheel.rolling.radius) is not None]
    size = given(use, kind.size) if kind.size else None
    if size is None or not radii or max(radii) > (1 + TOLERANCE) * min(radii):
        return
    factor, word = (2, "diameter") if kind.diameter else (1, "radius")
    if _differ(size[1], factor * radii[0]):
        shape = f"the wheels have {word} {factor * radii[0]:.4g} m"
        yield _finding(use, kind.size, size, shape, factor * radii[0])


def _separation(use: PluginUse, kind: DriveKind, found: list[Wheel]) -> Findings:
    distance = given(use, kind.separation) if kind.separation else None
    if distance is None:
        return
    for wheel, other in pairs(found):
        left, right = wheel.rolling, other.rolling
        if not left.is_parallel(right):
            continue
        if left.hub is None or right.hub is None:
            return
        apart = abs(dot(minus(left.origin, right.origin), left.axis))
        track = abs(dot(minus(left.hub, right.hub), left.axis))
        if kind.mistakes and distance[1] > track:
            return
        if _differ(distance[1], track) and _differ(distance[1], apart):
            names = f"'{left.joint.name}' and '{right.joint.name}'"
            shape = f"the wheels of {names} are {track:.4g} m apart"
            yield _finding(use, kind.separation, distance, shape, track)
        return  # the other pairs share the number


def _differ(said: float, real: float) -> bool:
    return abs(said - real) > TOLERANCE * real


def _finding(
    use: PluginUse, name: str, said: tuple[Element | Attribute, float], shape: str, real: float
) -> Finding:
    at, value = said
    default = " (the default)" if at is use.at else ""
    return Finding(
        at,
        f"{use.title}: <{name}> is {value:g} m{default}, and {shape}",
        f"write {real:.4g}",
        weight=abs(value - real),
    )
