"""A launch file in Python uses a substitution as a text, which it is only when launch runs.

- A string and a substitution are joined by a plus: "can only concatenate str (not
  LaunchConfiguration) to str". launch joins the items of a list.
- A function of Python gets a substitution, such as `os.path.join`, `open` or `int`: "expected str,
  bytes or os.PathLike object". Or an f-string contains one: its text is the name of the class.
- A condition of Python tests or compares a `LaunchConfiguration` (warning), or tests the text
  `false`, which is true in Python (warning).
- A `PythonExpression` contains the text `true` without quotes: "name 'true' is not defined".

Sources:
    launch, substitutions: https://docs.ros.org/en/rolling/Tutorials/Intermediate/Launch/Using-Substitutions.html
    launch, type_utils.py: https://github.com/ros2/launch/blob/rolling/launch/launch/utilities/normalize_to_list_of_substitutions_impl.py
"""

from urdfkit.checks.launch.launch_problems import launch_problems
from urdfkit.lint.rules import Context, Findings, Need, Severity, rule

NAME = "robot.launch.py"
BAD = """\
from launch.actions import LogInfo
from launch.substitutions import LaunchConfiguration

actions = [LogInfo(msg="robot: " + LaunchConfiguration("robot", default="arm"))]
"""
GOOD = BAD.replace('"robot: " + ', '["robot: ", ').replace('"arm")', '"arm")]')


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    return launch_problems(context, "LAU034")
