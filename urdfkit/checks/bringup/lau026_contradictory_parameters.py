"""Parameters contradict one another, those of another node, or the robot.

Each value is valid, but what it is meant for does not happen.

- The step of MPPI is below the period of the controller, which stops it, or a critic of MPPI
  considers the footprint of a robot that has only a radius (errors).
- The footprint or the radius of the robot leaves out its wheels, by a fifth of their distance. An
  inflation radius is within the robot, rays that clear obstacles are shorter than the range of
  obstacles, or no source clears them. A minimum is above its maximum. The heights of obstacles
  exclude all lidars of the robot.
- An initial pose is given without `set_initial_pose`, or `allow_reversing` of the regulated pure
  pursuit with `use_rotate_to_heading`.
- A row of `imu0_config` is of values that an IMU does not have. A filter reads the acceleration of
  an IMU with that of gravity (info). With a `transform_publish_period` of 0 slam_toolbox publishes
  no transform (info).
- An obstacle layer stands behind the last inflation layer, which does not inflate its obstacles.
- A costmap without a map does not move with the robot (`rolling_window`), is smaller than its
  footprint, or has the map in the frame of odometry. A static layer without
  `map_subscribe_transient_local` misses the map, which map_server publishes once.
- A server of Nav2 reads the footprint or the costs from a topic that a costmap does not publish. A
  layer reads a relative topic, which up to Jazzy is in the namespace of the costmap (an info for
  Jazzy).
- Nodes of Nav2 differ in `enable_stamped_cmd_vel`. A controller moves the robot sideways, which the
  velocity_smoother forbids, or for which AMCL has the model of a differential drive. Or it moves it
  twice as fast as the velocity_smoother allows.

Sources:
    Nav2, costmap: https://docs.nav2.org/configuration/packages/configuring-costmaps.html
    Nav2, MPPI: https://docs.nav2.org/configuration/packages/configuring-mppic.html
    robot_localization, preparing data: https://docs.ros.org/en/noetic/api/robot_localization/html/preparing_sensor_data.html
"""

from urdfkit.checks.bringup import costmap_geometry
from urdfkit.checks.bringup.footprints import wheels_outside, without_footprint, wrong_radii
from urdfkit.checks.bringup.navigation_commands import mixed_stamps
from urdfkit.checks.bringup.obstacle_heights import discarded_scans
from urdfkit.checks.bringup.parameter_relations import (
    beyond_smoother,
    contradictions,
    held_sideways,
    of_differential_drive,
    reversed_bounds,
)
from urdfkit.checks.bringup.read_parameters import (
    parameter_files,
    parameters_of_started,
    read_sections,
    whole_sections,
)
from urdfkit.lint.rules import Context, Findings, Need, Severity, rule

NAME = "launch/localization.launch.py"
BAD = """\
from launch_ros.actions import Node

nodes = [Node(package="nav2_amcl", executable="amcl", parameters=["../amcl.yaml"])]
"""
GOOD = BAD.replace("amcl.yaml", "sound.yaml")
_AMCL = b"amcl:\n  ros__parameters: {min_particles: %d, max_particles: 2000}\n"
FILES = {
    "amcl.yaml": _AMCL % 5000,
    "sound.yaml": _AMCL % 500,
    "package.xml": b"<package><name>arm</name></package>",
}


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    sections = read_sections(context)
    for section in parameters_of_started(context, parameter_files(context)):
        yield from reversed_bounds(section)
    for section in sections:
        yield from contradictions(section)
        if section.name.endswith("_costmap"):
            yield from wrong_radii(section)
        yield from costmap_geometry.misread_costmaps(section)
    for section in whole_sections(sections):
        yield from costmap_geometry.not_inflated(section)
        yield from costmap_geometry.unmoved(section)
    yield from costmap_geometry.untransformed_map(sections)
    yield from costmap_geometry.missed_maps(context, sections)
    yield from costmap_geometry.relative_topics(context, sections)
    yield from without_footprint(sections)
    yield from held_sideways(sections)
    yield from of_differential_drive(sections)
    yield from beyond_smoother(sections)
    yield from mixed_stamps(sections)
    yield from discarded_scans(context, sections)
    yield from wheels_outside(context, sections)
