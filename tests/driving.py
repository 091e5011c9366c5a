"""A robot on two wheels and its file of controllers, for the tests of the rules RCT."""

from pathlib import Path

from tests.controls import reported_with_file
from tests.gazebos import WHEELS, plugin
from tests.launched import MANIFEST, launch
from tests.workspaces import add_files
from urdfkit import Diagnostic, check
from urdfkit.lint.rule_examples import whole_robot

DRIVE = """\
controller_manager:
  ros__parameters:
    drive:
      type: diff_drive_controller/DiffDriveController
drive:
  ros__parameters:
    left_wheel_names: [left_joint]
    right_wheel_names: [right_joint]
    wheel_separation: 0.3
    wheel_radius: 0.1
    base_frame_id: base
"""


def reported(
    directory: Path, code: str, text: str, robot: str = WHEELS, namespace: str = ""
) -> list[Diagnostic]:
    """What a rule says about a robot with these controllers, whose manager has a namespace."""
    ros = f"<ros><namespace>{namespace}</namespace></ros>" if namespace else ""
    return reported_with_file(code, directory, text, "", robot, ros)


def reported_in_ros_1(directory: Path, code: str, text: str) -> list[Diagnostic]:
    """What a rule says about the robot if a launch file of ROS 1 loads these controllers."""
    robot = whole_robot(WHEELS + plugin("libgazebo_ros_control.so"))
    description = '<param name="robot_description" textfile="$(find arm)/r.urdf"/>'
    start = launch(f'{description}\n<rosparam file="$(find arm)/c.yaml"/>')
    files = {"r.urdf": robot, "c.yaml": text, "package.xml": MANIFEST, "launch/a.launch": start}
    add_files(directory, files)
    return list(check(directory, select=[code]).diagnostics)


def place(found: Diagnostic) -> tuple[str, int, str]:
    """File, line and text of a finding."""
    return Path(found.span.source.path).name, found.span.line, found.span.text
