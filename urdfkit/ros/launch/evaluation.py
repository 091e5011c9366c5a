"""``$(eval ...)`` of ROS 1, in the sandbox of xacro's expressions.

Source: ``_eval`` and ``_DictWrapper`` in ``roslaunch/substitution_args.py`` of ros/ros_comm.
"""

from collections.abc import Callable, Mapping

from urdfkit.xacro.budget import Budget, deadline
from urdfkit.xacro.expressions import evaluate as evaluate_in
from urdfkit.xacro.sandbox import Sandbox

#: Names that roslaunch defines, apart from arguments and functions.
_NAMES = {"true": True, "false": False} | {
    kind.__name__: kind for kind in (list, dict, map, str, float, int)
}
#: Length of the longest result of an expression.
MAX_LENGTH = 4096


def evaluate(
    text: str, arguments: Mapping[str, str], functions: Mapping[str, Callable[[str], str]]
) -> str | None:
    """The result of an expression as text; None if it is unknown.

    Args:
        arguments: of the launch file; available by name.
        functions: of one text, such as ``find``.
    """
    values = {name: _converted(value) for name, value in arguments.items()}
    names = _NAMES | {"arg": values.__getitem__, **functions, **values}
    try:
        result = evaluate_in(text.strip(), names, Sandbox(Budget(deadline())))
    except Exception:  # an expression may raise any exception
        return None
    is_text = isinstance(result, (str, bool, int, float)) and len(str(result)) <= MAX_LENGTH
    return str(result) if is_text else None


def _converted(text: str) -> str | bool | int | float:
    """The value of an argument in an expression, as roslaunch converts it."""
    if text.lower() in ("true", "false"):
        return text.lower() == "true"
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text
