"""A launch file in Python calls launch with an argument that it does not have or rejects.

- A class has no such argument, as in `DeclareLaunchArgument("a", default="b")`: "unexpected keyword
  argument". Or a required one is missing, or is given without its name, as in `LogInfo("text")`.
- A value has the wrong type: a dictionary instead of a list for `parameters`, an empty list as the
  value of one, `launch_arguments` without `.items()`, `default_value=True`, a number in `arguments`
  or in the `mappings` of xacro, a string as a condition, a single node as the `actions` of a timer,
  a list among the actions, the document of `xacro.process_file` without `.toxml()`, a substitution
  in place of a condition.
- A launch description source has another format than the file. An event handler is among the
  actions without `RegisterEventHandler`.
- A `default_value` is not one of the `choices`. The value of `output` is unknown.
- The function of an `OpaqueFunction` returns no list. `generate_launch_description` is misspelt or
  returns nothing.
- A method of `MoveItConfigsBuilder` has no such argument, or its configuration no such attribute.
- `node_executable` and similar arguments were removed after Foxy (info).

Sources:
    launch, type_utils.py: https://github.com/ros2/launch/blob/rolling/launch/launch/utilities/normalize_to_list_of_substitutions_impl.py
    launch_ros, node.py: https://github.com/ros2/launch_ros/blob/rolling/launch_ros/launch_ros/actions/node.py
    launch_ros, evaluate_parameters.py: https://github.com/ros2/launch_ros/blob/rolling/launch_ros/launch_ros/utilities/evaluate_parameters.py
    drfenixion/freecad.robotcad#159: https://github.com/drfenixion/freecad.robotcad/issues/159
"""

from urdfkit.checks.launch.launch_problems import launch_problems
from urdfkit.lint.rules import Context, Findings, Need, Severity, rule

NAME = "robot.launch.py"
BAD = """\
from launch_ros.actions import Node

nodes = [Node(package="rviz2", executable="rviz2", parameters={"use_sim_time": True})]
"""
GOOD = BAD.replace('{"use_sim_time": True}', '[{"use_sim_time": True}]')


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    return launch_problems(context, "LAU033")
