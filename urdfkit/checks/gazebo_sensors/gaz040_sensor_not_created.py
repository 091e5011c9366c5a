"""Gazebo does not create a sensor: its type, its place or its noise is wrong.

- The type is misspelt, or the name of a product instead of a type of sensor. An unknown type of a
  sensor with an unknown plugin is assumed to be defined by the plugin's package.
- The type is of another generation of Gazebo than the target: `ray` and `gpu_ray` became
  `gpu_lidar`, `depth` became `depth_camera`, `gps` became `navsat`. An info if no Gazebo is among
  the targets, or if the robot has plugins of both generations: one of them has the type.
- Force and torque are measured in a joint: `<gazebo reference="JOINT">`. On a link, gz-sim creates
  a sensor that never publishes, and Gazebo Classic creates none. Cameras and lidars belong to
  links.
- The noise of an IMU, a GPS, a magnetometer, an altimeter, a pressure or force sensor has its type
  in an attribute, `<noise type="gaussian">`, and SDF requires it; only that of images and scans has
  a child `<type>`. The usual cause is a block of a lidar that was copied into an IMU.

Sources:
    SDF, sensor: http://sdformat.org/spec?ver=1.9&elem=sensor
    sdformat, Sensor.cc: https://github.com/gazebosim/sdformat/blob/main/src/Sensor.cc
    gz-sim, SdfEntityCreator.cc: https://github.com/gazebosim/gz-sim/blob/main/src/SdfEntityCreator.cc
    Gazebo Classic, SensorFactory.cc: https://github.com/gazebosim/gazebo-classic/blob/gazebo11/gazebo/sensors/SensorFactory.cc
    gazebosim/gz-sensors#26: https://github.com/gazebosim/gz-sensors/issues/26
    gazebosim/docs#331: https://github.com/gazebosim/docs/issues/331
    measured: libsdformat 12.3 rejects a model with a noise without a type
"""

from collections.abc import Iterable, Mapping

from urdfkit.core.suggest import TYPO, did_you_mean, nearest
from urdfkit.lint.rules import Context, Finding, Findings, Fix, Severity, rule
from urdfkit.robot.samples import robot_xml
from urdfkit.ros.catalog.sensors import SensorType, types
from urdfkit.ros.gazebo import REJECTED, REJECTED_BY_GZ
from urdfkit.ros.gazebo.samples import gazebo_xml, sensor_xml, solid_xml
from urdfkit.ros.gazebo.sensors import Sensor, sensors, written
from urdfkit.ros.targets import CLASSIC, GAZEBO, GZ, Targets
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import first_attribute, fix_value

BAD = robot_xml(
    solid_xml("base"),
    gazebo_xml(sensor_xml("lidar", "gpu_lidr", "<update_rate>10</update_rate>"), reference="base"),
)
FIXED = GOOD = BAD.replace("gpu_lidr", "gpu_lidar")


_ON_JOINTS = {"force_torque"}
#: Elements that gz-sim reads in a sensor, and Gazebo Classic does not.
_OF_GZ = ("gz_frame_id", "ignition_frame_id")


@rule(
    Severity.ERROR,
    help="use a type that Gazebo knows, such as ray, gpu_lidar, camera, imu or contact",
    by_target=dict.fromkeys(GAZEBO, Severity.ERROR),
    migrates=True,
)
def check(context: Context) -> Findings:
    known = types()
    for sensor in sensors(context.model):
        if kind := known.get(sensor.type):
            yield from _not_in_target(sensor, kind, context.targets)
            yield from _of_wrong_element(context, sensor)
        elif not _brings_its_type(sensor, known):
            yield _unknown(sensor, known, context.targets)
        for inner in written(sensor):
            is_read = inner.has_type_attribute and inner.setting is not None
            if is_read and "type" not in inner.at.attributes:
                yield _noise_without_type(sensor, inner.at)


def _unknown(sensor: Sensor, known: Mapping[str, SensorType], targets: Targets) -> Finding:
    at = sensor.at.attributes.get("type", sensor.at)
    what = f"unknown type '{sensor.type}'" if sensor.type else "no type"
    made = [name for name, sensor_type in known.items() if _is_made(sensor_type, targets)]
    hint = did_you_mean(sensor.type, made)
    return Finding(at, f"{sensor.who}: {what}: {REJECTED_BY_GZ}{hint}", fix=_fix(sensor, made))


def _not_in_target(sensor: Sensor, kind: SensorType, targets: Targets) -> Findings:
    wants_gz, wants_classic = targets.any_of(GZ), targets.any_of(CLASSIC)
    has_classic = wants_classic or "ros1" in targets.names  # the Gazebo of ROS 1
    if not kind.gz and (wants_gz or not has_classic):
        reader, other = "gz-sim", kind.gz_name
    elif not kind.classic and wants_classic:
        reader, other = "Gazebo Classic", kind.classic_name
    else:
        return
    at = sensor.at.attributes["type"]
    has_gz_frame = any(sensor.at.child(tag) for tag in _OF_GZ)
    is_for_both = wants_classic and (wants_gz or has_gz_frame) and bool(targets.evidence)
    is_error = (wants_gz or wants_classic) and not is_for_both
    yield Finding(
        at,
        f"{sensor.who}: {reader} has no sensor type '{sensor.type}'",
        f"write type '{other}'" if other else f"use a type that {reader} has",
        fix_value(at, other) if is_error else None,
        severity=Severity.ERROR if is_error else Severity.INFO,
        targets=targets.among(GZ if reader == "gz-sim" else CLASSIC),
    )


def _of_wrong_element(context: Context, sensor: Sensor) -> Findings:
    is_link = sensor.reference in context.model.links_by_name
    is_joint = sensor.reference in context.model.joints_by_name
    if is_joint in (is_link, sensor.type in _ON_JOINTS):
        return
    who = f"{sensor.who} of type '{sensor.type}'"
    if is_link:
        above = context.tree.parents.get(sensor.reference, [])
        help = f'write reference="{above[0].name}"' if above else "name a joint"
        message = f"{who} is on link '{sensor.reference}', but must be on a joint"
        yield Finding(sensor.at, message, help)
    else:
        message = f"{who} is on joint '{sensor.reference}', but must be on a link"
        yield Finding(sensor.at, message, "name a link")


def _noise_without_type(sensor: Sensor, noise: Element) -> Finding:
    child = noise.child("type")
    type = child.text.strip() if child else "gaussian"
    title = f'write <noise type="{type}">'
    message = f"{sensor.who}: <noise> has no type: {REJECTED}"
    return Finding(noise, message, title, Fix(title, first_attribute(noise, "type", type)))


def _is_made(type: SensorType, targets: Targets) -> bool:
    """True if a target Gazebo creates such sensors, or no target is known."""
    gz = any(name.startswith("gz") for name in targets.names)
    classic = any(name.startswith("classic") for name in targets.names)
    return (type.gz and gz) or (type.classic and classic) or not (gz or classic)


def _brings_its_type(sensor: Sensor, known: Iterable[str]) -> bool:
    """True for a type of a foreign package, whose plugin is in the sensor."""
    from urdfkit.ros.catalog.plugins import find  # loads the catalogue

    files = [(plugin.get("filename") or "").strip() for plugin in sensor.plugins]
    foreign = bool(files) and not any(map(find, files))
    return foreign and bool(sensor.type) and not nearest(sensor.type, known, TYPO)


def _fix(sensor: Sensor, known: Iterable[str]) -> Fix | None:
    kind, suggested = sensor.at.attributes.get("type"), nearest(sensor.type, known, TYPO)
    return fix_value(kind, suggested) if kind else None
