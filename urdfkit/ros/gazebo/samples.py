"""Small robots for the examples of rules about sensors, drives and controllers."""

from urdfkit.robot.samples import arm_xml, element_xml, inertial_xml, joint_xml, link_xml, robot_xml


def solid_xml(name: str, *inside: str, mass: str = "1", moments: str = "0.01 0.01 0.01") -> str:
    """A ``<link>`` with a mass in kg, moments in kg·m² about x, y and z, and other elements."""
    return link_xml(name, inertial_xml(mass, moments), *inside)


def gazebo_xml(*inside: str, reference: str = "") -> str:
    """A ``<gazebo>`` block, of a link or joint if it has a reference."""
    return element_xml(f'gazebo reference="{reference}"' if reference else "gazebo", *inside)


def plugin_xml(name: str, filename: str, *inside: str) -> str:
    """A ``<plugin>`` with some parameters."""
    return element_xml(f'plugin name="{name}" filename="{filename}"', *inside)


def sensor_xml(name: str, kind: str, *inside: str) -> str:
    """A ``<sensor>`` of a type with some settings."""
    return element_xml(f'sensor name="{name}" type="{kind}"', *inside)


def control_xml(hardware: str, *inside: str, name: str = "arm") -> str:
    """A ``<ros2_control>`` block of type ``system`` with a hardware plugin."""
    plugin = element_xml("hardware", f"<plugin>{hardware}</plugin>")
    return element_xml(f'ros2_control name="{name}" type="system"', plugin, *inside)


def driven_xml(name: str, command: str = "position") -> str:
    """A ``<joint>`` of ``<ros2_control>`` with a command and a state interface."""
    return element_xml(
        f'joint name="{name}"',
        f'<command_interface name="{command}"/>',
        '<state_interface name="position"/>',
    )


#: Two links without shape or mass, and a revolute joint between them.
SHOULDER = arm_xml(
    "revolute", '<axis xyz="0 0 1"/>', '<limit lower="-1" upper="1" effort="10" velocity="1"/>'
)

_BASE = solid_xml("base") + "\n"

#: A forward-looking lidar.
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

#: A lidar on the link ``scanner`` with a field of view of 360 degrees.
SCANNER = gazebo_xml(
    sensor_xml(
        "front",
        "gpu_lidar",
        "<update_rate>10</update_rate>",
        "<lidar>"
        "<scan><horizontal><samples>360</samples><min_angle>-3.1</min_angle>"
        "<max_angle>3.1</max_angle></horizontal></scan>"
        "<range><min>0.1</min><max>10</max></range>"
        "</lidar>",
    ),
    reference="scanner",
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
ARM = (
    robot_xml(
        solid_xml("base", mass="3", moments="0.03 0.03 0.03"),
        solid_xml("arm", mass="0.5", moments="0.001 0.001 0.001"),
        joint_xml("continuous", '<axis xyz="0 1 0"/>'),
    )
    + "\n"
)

#: The control plugin of Gazebo, with a parameter file.
CONTROL = gazebo_xml(
    plugin_xml(
        "gz_ros2_control::GazeboSimROS2ControlPlugin",
        "gz_ros2_control-system",
        "<parameters>/home/student/arm_description/config/bad.yaml</parameters>",
    )
)

#: Wheels with a controller.
DRIVEN = (
    WHEELED
    + control_xml(
        "gz_ros2_control/GazeboSimSystem",
        driven_xml("left_joint", "velocity"),
        driven_xml("right_joint", "velocity"),
    )
    + "\n"
    + CONTROL
)


def controller_yaml(kind: str, *parameters: str) -> bytes:
    """A parameter file with a controller ``arm`` of a type; parameters are such as ``a: 1``."""
    own = "".join(f"    {line}\n" for line in parameters)
    manager = f"controller_manager:\n  ros__parameters:\n    arm:\n      type: {kind}\n"
    return f"{manager}arm:\n  ros__parameters:\n{own}".encode()


#: The parameter file of the wheels.
DRIVE = controller_yaml(
    "diff_drive_controller/DiffDriveController",
    "left_wheel_names: [left_joint]",
    "right_wheel_names: [right_joint]",
    "wheel_separation: 0.3",
    "wheel_radius: 0.1",
)
