"""What a controller needs of the hardware: command interfaces of joints, and sensors."""

from urdfkit.ros.controllers import Controller
from urdfkit.text.located_yaml import Value

#: The parameters of controllers that name a sensor, and those that name an interface of one.
_SENSORS = {
    "admittance_controller/AdmittanceController": "ft_sensor.name",
    "force_torque_sensor_broadcaster/ForceTorqueSensorBroadcaster": "sensor_name",
    "gps_sensor_broadcaster/GPSSensorBroadcaster": "sensor_name",
    "imu_sensor_broadcaster/IMUSensorBroadcaster": "sensor_name",
    "magnetometer_broadcaster/MagnetometerBroadcaster": "sensor_name",
    "pose_broadcaster/PoseBroadcaster": "pose_name",
    "range_sensor_broadcaster/RangeSensorBroadcaster": "sensor_name",
}
_INTERFACES = [f"interface_names.{kind}.{axis}" for kind in ("force", "torque") for axis in "xyz"]

_BY_PACKAGE = {f"{kind}_controllers": kind for kind in ("position", "velocity", "effort")}


def commands(controller: Controller) -> list[str]:
    """The command interfaces that a controller requires of each joint; empty if unknown."""
    if controller.ros == 1 and (kind := _BY_PACKAGE.get(controller.type.partition("/")[0])):
        return [kind]
    known = controller.kind
    if known is None:
        return []
    if known.interface:
        return [known.interface]
    named = controller.values([known.interfaces]) if known.interfaces else []
    return [value.text for value in named if value.text]


def claims(controller: Controller) -> list[tuple[list[str], list[Value]]]:
    """The command interfaces that a controller requires, with their joints."""
    if not controller.type.endswith("SteeringController"):
        return [(commands(controller), commanded_joints(controller))]
    drives_front = any(
        value.text.lower() == "false" for value in controller.values(["front_steering"])
    )
    steered, driven = ("rear", "front") if drives_front else ("front", "rear")
    return [
        (["position"], controller.values(["steering_joints_names", f"{steered}_wheels_names"])),
        (["velocity"], controller.values(["traction_joints_names", f"{driven}_wheels_names"])),
    ]


def commanded_joints(controller: Controller) -> list[Value]:
    """The joints that a controller commands; ``command_joints`` overrides ``joints``."""
    kind = controller.kind
    commanded = controller.values(["command_joints"])
    return commanded or (controller.values(kind.joints) if kind else [])


def named_sensors(controller: Controller) -> dict[str, Value]:
    """The sensors that a controller reads, also those of which it names an interface."""
    if (parameter := _SENSORS.get(controller.type)) is None:
        return {}
    interfaces = reversed(controller.values(_INTERFACES))  # the first place of each name remains
    named = {value.text.rpartition("/")[0]: value for value in interfaces}
    return {**named, **{value.text: value for value in controller.values([parameter])}}
