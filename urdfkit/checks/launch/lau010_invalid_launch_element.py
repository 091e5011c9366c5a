"""A launch file has an unknown, incomplete or invalid tag, attribute or substitution.

- A required attribute is missing (error). `roslaunch` stops: "<node> tag is missing required
  attribute"; `ros2 launch`, too: "Attribute 'exec' not found".
- An attribute is unknown, or its value is not allowed. `ros2 launch` stops: "Unexpected
  attribute(s) found"; `roslaunch` ignores it. Many are typos; others belong to the other version
  of ROS: the executable of a node is `type` in ROS 1 and `exec` in ROS 2.
- A substitution belongs to the other version of ROS (error): `$(find x)`, `$(arg x)` and
  `$(optenv X y)` are `$(find-pkg-share x)`, `$(var x)` and `$(env X y)` in ROS 2. A file with tags
  of both versions is read as one of the version of its package.
- A launch file of ROS 1 includes one of ROS 2 in Python or YAML, which `roslaunch` cannot parse.
- A tag is misspelt, or belongs to the other version of ROS, as `<rosparam>` does (error in ROS 2).
  Packages may define their own tags, so only typos of known tags are reported. Or `<remap>` or
  `<param>` is outside of a node in ROS 2, or an `<arg>` in it or with a value (error).
- A path is in place of the name of a package (error): `$(find-pkg-share arm/config)`.
- In ROS 1, an argument has both a value and a default. In both versions, a condition is a
  comparison (error): `if="$(arg gui) == true"` is not a boolean. Write `$(eval ...)`.

Sources:
    roslaunch, xmlloader.py: https://github.com/ros/ros_comm/blob/noetic-devel/tools/roslaunch/src/roslaunch/xmlloader.py
    launch, entity.py: https://github.com/ros2/launch/blob/rolling/launch_xml/launch_xml/entity.py
"""

from urdfkit.checks.launch.launch_problems import launch_problems
from urdfkit.lint.rules import Context, Findings, Need, Severity, rule

NAME = "robot.launch"
BAD = '<launch><node name="rviz" pkg="rviz" type="rviz" respwan="true"/></launch>'
GOOD = BAD.replace("respwan", "respawn")


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    return launch_problems(context, "LAU010")
