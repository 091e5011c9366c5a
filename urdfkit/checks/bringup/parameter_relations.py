"""Values of Nav2, slam_toolbox and robot_localization that contradict one another.

Sources: ``observation_buffer.cpp`` of nav2_costmap_2d, ``optimizer.cpp`` of nav2_mppi_controller,
``amcl_node.cpp`` (humble to rolling);
``ros_filter.cpp`` of robot_localization: what it takes from a message.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfkit.lint.rules import Finding, Findings, Related, Severity
from urdfkit.robot.values import number
from urdfkit.ros.launch.known_parameters import CONFIGURATION, given_values, plugin_class
from urdfkit.ros.node_parameters import NodeParameters
from urdfkit.text.located_yaml import Key, Node, Value, mapping, scalar, scalars, words

_MIN = re.compile(r"(?<![^_])min(?=imum_|_|$)")
#: The greatest ranges of an observation source, up to Foxy and later: of obstacles, and of the
#: rays that clear them.
_RANGES = (("obstacle_max_range", "raytrace_max_range"), ("obstacle_range", "raytrace_range"))
_CONTROLLER, _MPPI = "controller_server", "nav2_mppi_controller::MPPIController"
_DWB = "dwb_core::DWBLocalPlanner"
_PURSUIT = "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController"
#: The greatest speeds of controllers, and by what factor they may exceed that of the smoother.
_GREATEST = {_MPPI: "vx_max", _DWB: "max_vel_x", _PURSUIT: "desired_linear_vel"}
_BEYOND = 2.0
#: The speed of DWB along y, and the model of AMCL for a robot without one.
_SIDEWAYS, _DIFFERENTIAL = "max_vel_y", "nav2_amcl::DifferentialMotionModel"
_FREQUENCY, _STEP = 20.0, 0.05  # Hz and s, if not given
_TOLERANCE = 1e-6
_PURSUIT = "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController"
#: The rows of three values in a configuration, and those that a message has.
_ROWS = ("position", "angles", "velocity", "angular velocity", "acceleration")
_OF_MESSAGE = {"odom": (0, 1, 2, 3), "imu": (1, 3, 4), "pose": (0, 1), "twist": (2, 3)}
_MESSAGES = {"odom": "Odometry", "imu": "Imu", "pose": "PoseWithCovarianceStamped"}
_MESSAGES |= {"twist": "TwistWithCovarianceStamped"}


def contradictions(node: NodeParameters) -> Findings:
    """All contradictions in the parameters of a node."""
    yield from reversed_bounds(node)
    yield from _unread_pose(node)
    yield from _long_period(node)
    yield from _no_transform(node)
    yield from _missing_rows(node)
    yield from _gravity(node)
    for key, section in node.values.items():
        yield from _never_cleared(node, key, mapping(section))
        yield from _not_reversing(node, mapping(section))


def held_sideways(sections: list[NodeParameters]) -> Findings:
    """A controller that moves the robot sideways, which the velocity_smoother forbids."""
    smoothers = [node for node in sections if node.name == "velocity_smoother"]
    limits = scalars(smoothers[0].values.get("max_velocity")) if len(smoothers) == 1 else ()
    if len(limits) != 3 or _number(limits[1]) != 0:
        return
    for node, name, at in _moving_sideways(sections):
        yield Finding(
            at.span,
            f"'{node.name}' moves the robot sideways by {name}, but the velocity_smoother "
            "does not: its max_velocity in y is 0",
            f"write {'0.0' if name == _SIDEWAYS else 'DiffDrive'}, or a max_velocity in y",
            related=(Related(limits[1].span, "the limit in y"),),
        )


def of_differential_drive(sections: list[NodeParameters]) -> Findings:
    """A model of AMCL for robots that do not move sideways, which a controller does."""
    for _, name, at in _moving_sideways(sections):
        for node in sections:
            model = scalar(node.values, "robot_model_type")
            if node.name == "amcl" and model and model.text == _DIFFERENTIAL:
                yield Finding(
                    model.span,
                    f"'amcl' takes the robot for a differential drive, but {name} of the "
                    "controller_server moves it sideways",
                    "write nav2_amcl::OmniMotionModel",
                    related=(Related(at.span, "the controller"),),
                )
        return


def _moving_sideways(
    sections: list[NodeParameters],
) -> Iterator[tuple[NodeParameters, str, Value]]:
    """Controllers that move the robot sideways, each with what says so."""
    for node in sections:
        for plugin in map(mapping, node.values.values()) if node.name == _CONTROLLER else ():
            model, speed = scalar(plugin, "motion_model"), scalar(plugin, _SIDEWAYS)
            if plugin_class(plugin) == _MPPI and model and model.text == "Omni":
                yield node, "motion_model Omni", model
            elif plugin_class(plugin) == _DWB and speed and (_number(speed) or 0.0) > 0:
                yield node, _SIDEWAYS, speed


def beyond_smoother(sections: list[NodeParameters]) -> Findings:
    """A controller whose greatest speed is far above the limit of the velocity_smoother."""
    smoothers = [node for node in sections if node.name == "velocity_smoother"]
    limits = scalars(smoothers[0].values.get("max_velocity")) if len(smoothers) == 1 else []
    limit = _number(limits[0]) if limits else None
    for node in sections:
        plugins = node.values.values() if node.name == _CONTROLLER and limit else ()
        for plugin in map(mapping, plugins):
            name = _GREATEST.get(plugin_class(plugin), "")
            value = scalar(plugin, name) if name else None
            speed = _number(value)
            if value and limit and speed and speed >= _BEYOND * limit:
                yield Finding(
                    value.span,
                    f"'{node.name}': {name} is {speed:g} m/s, but the velocity_smoother limits "
                    f"commands to {limit:g} m/s",
                    f"write {limit:g} or less, or a greater max_velocity",
                    related=(Related(limits[0].span, "the limit"),),
                )


def reversed_bounds(node: NodeParameters) -> Findings:
    """A minimum above its maximum; a negative maximum stands for that of the sensor."""
    known = {name.rpartition(".")[2] for given in given_values(node) for name in given.known}
    for section in _sections(node.values) if known else ():
        for name, value in section.items():
            greatest = _MIN.sub("max", name)
            if greatest == name or not known.issuperset((name, greatest)):
                continue
            low, high = _number(value), _number(section.get(greatest))
            if low is not None and high is not None and low > high >= 0:
                yield _finding(
                    value,
                    f"'{node.name}': {name} is {low:g}, above {greatest}, {high:g}",
                    f"write {high:g} or less, or a greater {greatest}",
                )


def _unread_pose(node: NodeParameters) -> Findings:
    """An initial pose of AMCL that is not used, as ``set_initial_pose`` is false by default."""
    pose, switch = mapping(node.values, "initial_pose"), scalar(node.values, "set_initial_pose")
    x, is_moved = scalar(pose, "x"), any(map(_number, pose.values()))
    is_unset = switch is None or (is_moved and switch.boolean is False)
    if node.name == "amcl" and x and is_unset:
        message = "'amcl': initial_pose is not read without set_initial_pose: true"
        yield _finding(switch or x, message, "write set_initial_pose: true")


def _long_period(node: NodeParameters) -> Findings:
    """A step of MPPI below the period of the controller, at which the controller stops."""
    frequency = _number(node.values.get("controller_frequency"), _FREQUENCY)
    for section in map(mapping, node.values.values()) if node.name == _CONTROLLER else ():
        at = scalar(section, "model_dt") or scalar(section, "plugin")
        seconds = _number(section.get("model_dt"), _STEP)
        if at is None or plugin_class(section) != _MPPI:
            continue
        if seconds and frequency and 1 / frequency > seconds + _TOLERANCE:
            yield Finding(
                at.span,
                f"'{node.name}' stops: model_dt is {seconds:g} s, below the period of "
                f"{1 / frequency:.4g} s of controller_frequency {frequency:g}",
                f"write model_dt: {_rounded_up(1 / frequency)}, or a controller_frequency of "
                f"{1 / seconds:g} or more",
                severity=Severity.ERROR,
            )


def _no_transform(node: NodeParameters) -> Findings:
    """A period of slam_toolbox that stands for no transform at all."""
    period = scalar(node.values, "transform_publish_period")
    if node.name == "slam_toolbox" and period and _number(period) == 0:
        message = "'slam_toolbox' publishes no transform from map to odom: "
        message += "transform_publish_period is 0"
        yield Finding(period.span, message, "write 0.02", severity=Severity.INFO)


def _rounded_up(seconds: float) -> str:
    """Four decimals that are not below a period."""
    rounded = round(seconds, 4)
    return f"{rounded if rounded >= seconds - _TOLERANCE else rounded + 1e-4:.4g}"


def _missing_rows(node: NodeParameters) -> Findings:
    """Values that robot_localization does not take from a message of this type."""
    inputs = {
        key: (match.group(2), scalars(value))
        for key, value in node.values.items()
        if (match := CONFIGURATION.fullmatch(key))
    }
    values = [value for _, given in inputs.values() for value in given]
    if values and all(value.boolean is False for value in values):
        message = f"'{node.name}' reads nothing: all values of its inputs are false"
        yield _finding(values[0], message, "write true for what the filter reads of a message")
    for key, (kind, given) in inputs.items():
        for row, title in enumerate(_ROWS) if len(given) == 3 * len(_ROWS) else ():
            read = [value for value in given[3 * row : 3 * row + 3] if value.boolean]
            if read and row not in _OF_MESSAGE[kind]:
                yield _finding(
                    read[0],
                    f"'{node.name}': {key} has true in row {row + 1}, {title}, which "
                    f"{_MESSAGES[kind]} does not contain",
                    "write five rows: position, angles, velocity, angular velocity, acceleration",
                )


def _gravity(node: NodeParameters) -> Findings:
    """A vertical acceleration with that of gravity; an info, as a driver may have removed it."""
    for key, value in node.values.items():
        match, given = CONFIGURATION.fullmatch(key), scalars(value)
        is_imu = match is not None and match.group(2) == "imu" and len(given) == 3 * len(_ROWS)
        if not is_imu or not given[-1].boolean or _is_on(node.values, "two_d_mode"):
            continue
        switch = f"{key.removesuffix('_config')}_remove_gravitational_acceleration"
        if switch not in node.values or _is_off(node.values, switch):
            message = (
                f"'{node.name}' reads the vertical acceleration of an IMU, which contains that "
            )
            message += f"of gravity, without {switch}: the robot rises"
            yield Finding(given[-1].span, message, f"write {switch}: true", severity=Severity.INFO)


def _never_cleared(node: NodeParameters, layer: str, values: dict[str, Node]) -> Findings:
    """Sources of an obstacle layer that mark cells which no ray clears."""
    if _is_off(values, "enabled"):
        return
    sources = [mapping(values, name) for name in words(values, "observation_sources")]
    for source in sources:
        for marked, cleared in _RANGES:
            farthest, ray = _number(source.get(marked)), _number(source.get(cleared))
            if farthest and ray and ray < farthest and _is_on(source, "clearing"):
                yield _finding(
                    source[cleared],
                    f"'{node.name}', {layer}: {cleared} {ray:g} is below {marked} {farthest:g}: "
                    "obstacles behind it are never cleared",
                    f"write more than {farthest:g}",
                )
    switches = [source.get("clearing") for source in sources]
    if switches and all(_is_off(source, "clearing") for source in sources):
        message = f"'{node.name}': the obstacles of {layer} are never cleared: no source has "
        yield _finding(switches[0], f"{message}clearing: true", "write clearing: true")


def _not_reversing(node: NodeParameters, section: dict[str, Node]) -> Findings:
    """Reversing, which the regulated pure pursuit does not do if it rotates on the spot."""
    switches = ("allow_reversing", "use_rotate_to_heading")
    if plugin_class(section) == _PURSUIT and all(_is_on(section, name) for name in switches):
        yield _finding(
            section["allow_reversing"],
            f"'{node.name}' does not reverse: allow_reversing is not used with "
            "use_rotate_to_heading",
            "write use_rotate_to_heading: false, or remove allow_reversing",
        )


def _sections(values: dict[str, Node]) -> Iterator[dict[str, Node]]:
    stack = [values]
    while stack:
        section = stack.pop()
        yield section
        stack += [inner for inner in section.values() if isinstance(inner, dict)]


def _number(node: Node, default: float | None = None) -> float | None:
    """The number of a value; the default if there is no value."""
    return number(node.text) if isinstance(node, Value) else default if node is None else None


def _is_on(section: dict[str, Node], key: str) -> bool:
    value = scalar(section, key)
    return value is not None and value.boolean is True


def _is_off(section: dict[str, Node], key: str) -> bool:
    value = scalar(section, key)
    return value is not None and value.boolean is False


def _finding(at: Node | Key, message: str, help: str) -> Finding:
    assert isinstance(at, Value)
    return Finding(at.span, message, help)
