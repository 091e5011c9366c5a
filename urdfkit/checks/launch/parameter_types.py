"""Values of parameters that a node of ROS 2 does not take.

Sources: rcl_yaml_param_parser (no lists in lists); the declarations of Nav2 and robot_localization;
rst-tu-dortmund/teb_local_planner#202 ("expected [double] got [integer]").
"""

import re
from collections.abc import Iterator

from urdfkit.lint.rules import Finding, Findings, Location, Severity
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.node_parameters import NodeParameters
from urdfkit.text.located_yaml import Key, Node, Value

PUBLISHER, FREQUENCY = "robot_state_publisher", "publish_frequency"
#: Parameters that are declared with a fraction, by the node; in a filter, all of these.
_OF_COSTMAP = frozenset(
    "cost_scaling_factor footprint_padding inflation_radius obstacle_max_range obstacle_min_range "
    "publish_frequency raytrace_max_range raytrace_min_range resolution robot_radius "
    "transform_tolerance update_frequency".split()
)
_FRACTIONS = {
    "controller_server": frozenset(("controller_frequency",)),
    "planner_server": frozenset(("expected_planner_frequency",)),
    PUBLISHER: frozenset((FREQUENCY,)),
    "local_costmap": _OF_COSTMAP,
    "global_costmap": _OF_COSTMAP,
}
_OF_FILTER = frozenset(("frequency", "sensor_timeout"))
#: What AMCL loads instead of the names of ROS 1.
_MODELS = {
    "differential": "nav2_amcl::DifferentialMotionModel",
    "omnidirectional": "nav2_amcl::OmniMotionModel",
}
_FILTERED = re.compile(r"(odom|imu|pose|twist)\d+_config")


def wrong_types(node: NodeParameters) -> Findings:
    """Whole numbers for fractions, at which the node stops, and lists in lists."""
    fractions = _FRACTIONS.get(node.name, frozenset())
    if any(map(_FILTERED.fullmatch, node.values)):
        fractions |= _OF_FILTER
    for key, value in _all(node.values):
        # The end of an inner list ends the outer one, too: one alone is read as if it were flat.
        if isinstance(value, list) and sum(isinstance(one, list) for one in value) > 1:
            yield Finding(
                Location(key.span),
                f"'{node.name}': {key} is a list of lists, which ROS 2 does not read",
                'write one list, or for a footprint a text: "[[x, y], ...]"',
            )
        elif isinstance(value, Value) and key in fractions and _is_whole(value):
            yield Finding(
                Location(value.span),
                f"'{node.name}' stops: {key} is declared as a double, and {value.text} is an "
                "integer",
                f"write {value.text}.0",
            )


def wrong_sizes(node: NodeParameters) -> Findings:
    """Fractions for the sizes of a costmap, which are whole metres."""
    for key in ("width", "height") if node.name.endswith("_costmap") else ():
        value = node.values.get(key)
        if isinstance(value, Value) and re.fullmatch(r"[-+]?\d+\.\d*", value.text):
            message = f"'{node.name}' stops: {key} is declared as an integer, not {value.text}"
            yield Finding(Location(value.span), message, f"write {round(float(value.text))}")


def whole_frequency(started: StartedProgram) -> Findings:
    """A frequency of robot_state_publisher in a launch file of ROS 2; ROS 1 takes any number."""
    value = started.parameters.values.get(FREQUENCY) or ""
    is_ros2 = started.span.source.path.endswith(".py")
    if started.package == PUBLISHER and is_ros2 and re.fullmatch(r"\d+", value):
        message = (
            f"{PUBLISHER} stops: {FREQUENCY} is declared as a double, and {value} is an integer"
        )
        yield Finding(Location(started.span, started.frame), message, f"write {value}.0")


def old_model(node: NodeParameters) -> Findings:
    """A model of AMCL's motion as ROS 1 and Foxy call it."""
    model = node.values.get("robot_model_type")
    name = _MODELS.get(model.text) if isinstance(model, Value) and node.name == "amcl" else None
    if name and isinstance(model, Value):
        yield Finding(
            Location(model.span),
            f"'amcl' of Humble and later stops: robot_model_type is a class, not '{model.text}'",
            f"write {name}",
            severity=Severity.WARNING,
        )


def _all(values: dict[str, Node]) -> Iterator[tuple[Key, Node]]:
    for key, value in values.items():
        if isinstance(key, Key):
            yield key, value
        if isinstance(value, dict):
            yield from _all(value)


def _is_whole(value: Value) -> bool:
    """True for an integer that is not in quotes."""
    start, end = value.span.start, value.span.end
    return end - start == len(value.text) and re.fullmatch(r"[-+]?\d+", value.text) is not None
