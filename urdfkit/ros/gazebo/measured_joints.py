"""The joints whose forces and torques Gazebo measures."""

from collections.abc import Iterator

from urdfkit.robot.model import RobotModel
from urdfkit.ros.gazebo.sensors import sensors
from urdfkit.ros.gazebo.values import is_true
from urdfkit.text.document import Element


def measured_joints(model: RobotModel) -> Iterator[tuple[str, Element, str]]:
    """The names of the joints, the elements of the sensors, and what to call these."""
    measured: set[str] = set()
    for sensor in sensors(model):
        if sensor.type == "force_torque":
            measured.add(sensor.reference)
            yield sensor.reference, sensor.at, sensor.who
    for block in model.gazebo:
        name = block.get("reference") or ""
        for feedback in block.all("provideFeedback"):
            if name not in measured and is_true(feedback):
                yield name, feedback, "<provideFeedback>"
