"""Small robots for the examples of rules about sensors, drives and controllers."""

from __future__ import annotations

_BASE = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
"""

#: A lidar that looks forwards.
LIDAR = (
    _BASE
    + """\
<gazebo reference="base">
  <sensor name="lidar" type="ray">
    <ray>
      <scan>
        <horizontal>
          <samples>360</samples>
          <min_angle>-1</min_angle>
          <max_angle>1</max_angle>
        </horizontal>
      </scan>
      <range><min>0.1</min><max>10</max></range>
    </ray>
  </sensor>
</gazebo>"""
)

_WHEEL = """\
<link name="{side}_wheel">
  <collision>
    <origin rpy="1.5707963 0 0"/>
    <geometry><cylinder radius="0.1" length="0.04"/></geometry>
  </collision>
  <inertial>
    <mass value="0.2"/>
    <inertia ixx="0.00053" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.00053"/>
  </inertial>
</link>
<joint name="{side}_joint" type="continuous">
  <parent link="base"/>
  <child link="{side}_wheel"/>
  <origin xyz="0 {y} 0"/>
  <axis xyz="0 1 0"/>
</joint>
"""

#: Two wheels with a radius of 0.1 m, 0.3 m apart.
WHEELED = _BASE + _WHEEL.format(side="left", y=0.15) + _WHEEL.format(side="right", y=-0.15)

#: One joint.
ARM = """\
<link name="base">
  <inertial>
    <mass value="3"/>
    <inertia ixx="0.03" ixy="0" ixz="0" iyy="0.03" iyz="0" izz="0.03"/>
  </inertial>
</link>
<link name="arm">
  <inertial>
    <mass value="0.5"/>
    <inertia ixx="0.001" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.001"/>
  </inertial>
</link>
<joint name="shoulder" type="continuous">
  <parent link="base"/>
  <child link="arm"/>
  <axis xyz="0 1 0"/>
</joint>
"""

#: What runs controllers in Gazebo, with their file.
CONTROL = """\
<gazebo>
  <plugin name="gz_ros2_control::GazeboSimROS2ControlPlugin" filename="gz_ros2_control-system">
    <parameters>/home/student/arm_description/config/bad.yaml</parameters>
  </plugin>
</gazebo>"""

#: The wheels under a controller.
DRIVEN = (
    WHEELED
    + """\
<ros2_control name="base" type="system">
  <hardware>
    <plugin>gz_ros2_control/GazeboSimSystem</plugin>
  </hardware>
  <joint name="left_joint">
    <command_interface name="velocity"/>
    <state_interface name="position"/>
  </joint>
  <joint name="right_joint">
    <command_interface name="velocity"/>
    <state_interface name="position"/>
  </joint>
</ros2_control>
"""
    + CONTROL
)

#: Its file of controllers.
DRIVE = b"""\
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
"""
