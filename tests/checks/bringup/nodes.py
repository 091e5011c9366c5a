"""Nodes of launch files, for the tests of the rules about a bring-up."""

from pathlib import Path

from tests.launched import reported

STATE = "Node(package='robot_state_publisher', executable='robot_state_publisher'{})\n"
NODE = "Node(package='{}', executable='{}', {})\n"
SPAWNER = NODE.format("controller_manager", "spawner", "arguments={}")
CONTROLLERS = """
controller_manager:
  ros__parameters:
    arm: {type: joint_trajectory_controller/JointTrajectoryController}
    states: {type: joint_state_broadcaster/JointStateBroadcaster}
"""
MANAGER = NODE.format("controller_manager", "ros2_control_node", "parameters=['{}/c.yaml'], {}")


def messages(directory: Path, code: str, text: str) -> list[str]:
    """The messages of a rule about a launch file that also starts a controller manager."""
    text = MANAGER.format(directory, "") + text
    found = reported(directory, code, "a.launch.py", text, {"c.yaml": CONTROLLERS})
    return [one.message for one in found]
