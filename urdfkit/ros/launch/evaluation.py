"""``$(eval ...)`` of ROS 1, in the sandbox of xacro's expressions.

Source: ``_eval`` and ``_DictWrapper`` in ``roslaunch/substitution_args.py`` of ros/ros_comm.
"""

from collections.abc import Callable, Mapping

from urdfkit.xacro.budget import Budget, deadline
from urdfkit.xacro.expressions import evaluate as evaluate_in
from urdfkit.xacro.sandbox import Sandbox

#: What roslaunch defines besides the arguments and functions of its own.
_NAMES = {"true": True, "false": False} | {
    kind.__name__: kind for kind in (list, dict, map, str, float, int)
}
#: The longest text that an expression may give.
MAX_LENGTH = 4096


def evaluate(
    text: str, arguments: Mapping[str, str], functions: Mapping[str, Callable[[str], str]]
) -> str | None:
    """The text that an expression gives; None where only roslaunch knows it.

    Args:
        arguments: of the launch file; they can be called by name.
        functions: such as ``find``, which take one text.
    """
    values = {name: _converted(value) for name, value in arguments.items()}
    names = _NAMES | {"arg": values.__getitem__, **functions, **values}
    try:
        found = evaluate_in(text.strip(), names, Sandbox(Budget(deadline())))
    except Exception:  # whatever goes wrong in an expression
        return None
    is_text = isinstance(found, (str, bool, int, float)) and len(str(found)) <= MAX_LENGTH
    return str(found) if is_text else None


def _converted(text: str) -> str | bool | int | float:
    """The value of an argument, as roslaunch takes it in an expression."""
    if text.lower() in ("true", "false"):
        return text.lower() == "true"
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text
