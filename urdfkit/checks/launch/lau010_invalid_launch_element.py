"""A launch file has an unknown, incomplete or invalid tag or call, or a command without spaces.

- A required attribute is missing (error). `roslaunch` stops: "<node> tag is missing required
  attribute"; `ros2 launch`, too: "Attribute 'exec' not found".
- An attribute is unknown, or its value is not allowed. `ros2 launch` stops: "Unexpected
  attribute(s) found"; `roslaunch` ignores it. Many are typos; others belong to the other version
  of ROS: the executable of a node is `type` in ROS 1 and `exec` in ROS 2.
- A substitution belongs to the other version of ROS (error): `$(find x)` and `$(arg x)` are
  `$(find-pkg-share x)` and `$(var x)` in ROS 2. A file with tags of both versions is read as one of
  the version of its package.
- A launch file of ROS 1 includes one of ROS 2 in Python or YAML, which `roslaunch` cannot parse.
- A tag is misspelt, or belongs to the other version of ROS, as `<rosparam>` does (error in ROS 2).
  Packages may define their own tags, so only typos of known tags are reported. Or `<remap>` or
  `<param>` is outside of a node in ROS 2, or an `<arg>` in it or with a value (error).
- The parts of a `Command` have no space between them (error). launch concatenates them:
  `["xacro", path]` runs a program called `xacro/home/...`; in `["xacro ", path, "sim:=true"]` the
  argument becomes part of the file name. Write `["xacro ", path, " sim:=true"]`.
- A call in Python has a value of the wrong type (error): a dictionary instead of a list for
  `parameters`, `launch_arguments` without `.items()`, `default_value=True`, a number in
  `arguments`, a string as a condition, a single node as the `actions` of a timer, a list among the
  actions, a launch description source of another format than the file, the document of
  `xacro.process_file` without `.toxml()`.
- A `default_value` is not one of the `choices` (error).
- A class has no such argument (error), as in `DeclareLaunchArgument("a", default="b")`: "unexpected
  keyword argument". Or a required one is missing, or is given without its name, as in
  `LogInfo("text")`. A name is not defined or imported (error; a
  warning under a condition), or is imported from a module that does not have it. The value of
  `output` is unknown, a substitution is in place of a condition, an event handler is among the
  actions without `RegisterEventHandler`, or the function of an `OpaqueFunction` returns no list
  (error).
- `SetParameter`, `push_ros_namespace` or a similar action stands behind the last node (warning): it
  applies to the actions after it. A condition of Python tests or compares a `LaunchConfiguration`
  (warning), which has no value when Python runs.
- A path is in place of the name of a package (error): `$(find-pkg-share arm/config)`.
- ROS arguments are not as rcl reads them (error): `-p name=value`. An option of the spawner or of
  static_transform_publisher, or a verb or state of `ros2 control`, does not exist, or no longer. Or
  static_transform_publisher has a wrong number of arguments (error): a period after the frames
  belongs to ROS 1.
- The command line of `ExecuteProcess` is one string (error): launch looks for a program that is
  called `ros2 topic list`.
- A string and a substitution are joined by a plus (error): "can only concatenate str (not
  LaunchConfiguration) to str"; or a function of Python gets a substitution, such as `os.path.join`
  or `open`: "expected str, bytes or os.PathLike object". The directory of a package and a path are
  joined without a slash.
- A method of `MoveItConfigsBuilder` has no such argument (error), or its configuration no such
  attribute. A `Node` is in place of a `ComposableNode` (error).
- A composable node names a class with a slash or another one than its package has, or is loaded
  into a container whose name is another one with its namespace (error); or an event handler starts
  an action when it has exited itself.
- A `PythonExpression` contains the text `true` without quotes (error): "name 'true' is not
  defined". Python takes the text `false` of an argument for true.
- In ROS 1, an argument has both a value and a default. In both versions, a condition is a
  comparison (error): `if="$(arg gui) == true"` is not a boolean. Write `$(eval ...)`.
- `generate_launch_description` is misspelt or returns nothing (error).
- An action is both in the launch description and in an event handler of it (error): launch starts
  it once and stops at the second start. Or an event handler without `target_action` starts a
  process at an event of each process (warning). An action waits for the exit of a node that does
  not exit, such as robot_state_publisher, and never starts; or for that of an included launch file,
  which is no process (error).
- A node that reads the keyboard, such as teleop_twist_keyboard, has no terminal in a launch file of
  ROS 2: "Inappropriate ioctl for device". Start it in one of its own, with `prefix="xterm -e"`.
- An action is created but not added to the launch description, so it is never started (info: often
  intended).

Sources:
    launch, type_utils.py: https://github.com/ros2/launch/blob/rolling/launch/launch/utilities/normalize_to_list_of_substitutions_impl.py
    launch_ros, node.py: https://github.com/ros2/launch_ros/blob/rolling/launch_ros/launch_ros/actions/node.py
    roslaunch, xmlloader.py: https://github.com/ros/ros_comm/blob/noetic-devel/tools/roslaunch/src/roslaunch/xmlloader.py
    launch, entity.py: https://github.com/ros2/launch/blob/rolling/launch_xml/launch_xml/entity.py
    drfenixion/freecad.robotcad#159: https://github.com/drfenixion/freecad.robotcad/issues/159
    launch, execute_local.py: https://github.com/ros2/launch/blob/rolling/launch/launch/actions/execute_local.py
    launch, command.py: https://github.com/ros2/launch/blob/rolling/launch/launch/substitutions/command.py
"""

from urdfkit.lint.rules import (
    Context,
    Finding,
    Findings,
    Location,
    Need,
    Severity,
    reported,
    rule,
)
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.transforms import mistakes

NAME = "robot.launch"
BAD = '<launch><node name="rviz" pkg="rviz" type="rviz" respwan="true"/></launch>'
GOOD = BAD.replace("respwan", "respawn")


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    for finding in reported(context, "LAU010"):
        yield finding._replace(group_key=finding.message)  # a file of the other ROS has many
    yield from _without_terminal(context)
    for program in context.launch.started:
        for word, message, help in mistakes(program):
            at = Location(word.span, program.frame)
            yield Finding(at, message, help, severity=Severity.ERROR)


def _without_terminal(context: Context) -> Findings:
    """Nodes that read the keyboard, which launch of ROS 2 does not pass to them."""
    if b"prefix" in context.source.data:
        return
    interactive = data("launch")["interactive"]
    for node in context.launch.started:
        if node.key in interactive and node.is_ros_2:
            is_python = context.source.path.endswith(".py")
            yield Finding(
                Location(node.span, node.frame),
                f"'{node.executable}' reads the keyboard and stops: it has no terminal in a "
                "launch file",
                f'write {"prefix" if is_python else "launch-prefix"}="xterm -e", or start it with '
                "ros2 run",
            )
