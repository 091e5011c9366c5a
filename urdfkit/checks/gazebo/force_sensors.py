"""Force-torque sensors and ``<provideFeedback>`` on joints that Gazebo merges."""

from urdfkit.lint.rules import Context, Finding, Findings, Fix, Severity
from urdfkit.ros.gazebo.measured_joints import measured_joints
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import insert_before

_KEEP = "<preserveFixedJoint>true</preserveFixedJoint>"


def merged_force_sensors(context: Context) -> Findings:
    """The fixed joints whose forces are measured, but which Gazebo merges."""
    kept = {joint.joint.name for joint in context.gazebo.joints}
    for name, at, who in measured_joints(context.model):
        joint = context.model.joints_by_name.get(name)
        if joint is not None and joint.kind == "fixed" and name not in kept:
            yield Finding(
                at,
                f"{who} is on fixed joint '{name}', which Gazebo merges: nothing is measured",
                f"add {_KEEP} to the <gazebo reference> of the joint",
                Fix("keep the joint in Gazebo", insert_before(at, (_KEEP,))),
                group_key="merged",
                severity=Severity.ERROR if _is_read(context, name, at) else None,
            )


def _is_read(context: Context, name: str, at: Element) -> bool:
    """True if the sensor has a topic or a plugin, or something else reads the forces."""
    if at.tag == "sensor" and (at.child("topic") or at.child("plugin")):
        return True
    # One that moves the joint, as for a mimic, does not read its forces.
    readers = [use.at for use in context.plugins if not (use.plugin and use.plugin.moves)]
    if any(value.text.strip() == name for plugin in readers for value in plugin.children):
        return True
    sensors_of_control = [
        sensor for block in context.model.ros2_controls for sensor in block.all("sensor")
    ]
    interfaces = [state for sensor in sensors_of_control for state in sensor.all("state_interface")]
    return any((state.get("name") or "").startswith(("force", "torque")) for state in interfaces)
