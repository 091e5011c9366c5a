"""The parameter file of the Gazebo control plugin does not exist.

The plugin hands the file to the controller manager, which stops at it; no controller can be loaded,
and Gazebo may stop as well. The file has another name or directory, or is not installed.

An absolute path outside of the repository or workspace is a warning: it may exist on another
machine, such as `/workspace/install/...` in a container.

Sources:
    gz_ros2_control_plugin.cpp: https://github.com/ros-controls/gz_ros2_control/blob/rolling/gz_ros2_control/src/gz_ros2_control_plugin.cpp
    gazebo_ros2_control_plugin.cpp: https://github.com/ros-controls/gazebo_ros2_control/blob/master/gazebo_ros2_control/src/gazebo_ros2_control_plugin.cpp
"""

from __future__ import annotations

import os

from urdfkit.core.suggest import nearest_file
from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.ros.controllers import parameter_files
from urdfkit.text.diagnostic import Severity

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo>
  <plugin name="gazebo_ros2_control" filename="libgazebo_ros2_control.so">
    <parameters>/home/student/arm_description/config/controler.yaml</parameters>
  </plugin>
</gazebo>"""
GOOD = BAD.replace("controler", "controllers")
FILES = {
    "config/controllers.yaml": b"controller_manager:\n  ros__parameters:\n    update_rate: 9\n"
}


#: Directories of generated files.
_GENERATED = ("generated", "temp", "tmp")


@rule(
    Severity.ERROR,
    help="correct the path; $(find package)/config/controllers.yaml in the xacro works everywhere",
)
def check(subject: Subject) -> Findings:
    for file in parameter_files(subject):
        if file.found is None and file.element:  # LAU003 reports those of launch files
            if os.path.basename(os.path.dirname(file.path)) in _GENERATED:
                continue  # the launch file writes it first
            is_here = subject.resolver.packages.searches(file.path, subject.source.path)
            suggested = nearest_file(file.path)
            hint = f"; did you mean '{suggested}'?" if suggested else ""
            where = "" if is_here else " on this machine"
            yield Finding(
                file.element,
                f"parameter file not found{where}: {file.path}{hint}",
                severity=None if is_here else Severity.WARNING,
            )
