"""Values of Nav2, slam_toolbox and robot_localization that contradict one another.

Sources: ``observation_buffer.cpp``, ``inflation_layer.cpp`` and ``costmap_2d_ros.cpp`` of
nav2_costmap_2d, ``optimizer.cpp`` of nav2_mppi_controller, ``amcl_node.cpp`` (humble to rolling);
``ros_filter.cpp`` of robot_localization: what it takes from a message.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from math import hypot, inf

from urdfkit.lint.rules import Finding, Findings, Severity
from urdfkit.robot.values import number
from urdfkit.ros.launch.known_parameters import CONFIGURATION, given_values
from urdfkit.ros.node_parameters import NodeParameters
from urdfkit.text.located_yaml import Key, Node, Value, mapping, scalars

_MIN = re.compile(r"(?<![^_])min(?=imum_|_|$)")
#: The greatest ranges of an observation source, up to Foxy and later: of obstacles, and of the
#: rays that clear them.
_RANGES = (("obstacle_max_range", "raytrace_max_range"), ("obstacle_range", "raytrace_range"))
_CONTROLLER, _MPPI = "controller_server", "nav2_mppi_controller::MPPIController"
_FREQUENCY, _STEP = 20.0, 0.05  # Hz and s, if not given
_CONSIDERED, _OF_FOOTPRINT = "consider_footprint", ("CostCritic", "ObstaclesCritic")
_TOLERANCE = 1e-6
_SIDE = 5.0  # m, of a costmap, if not given
_PURSUIT = "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController"
_INFLATION = "InflationLayer"
#: The rows of three values in a configuration, and those that a message has.
_ROWS = ("position", "angles", "velocity", "angular velocity", "acceleration")
_OF_MESSAGE = {"odom": (0, 1, 2, 3), "imu": (1, 3, 4), "pose": (0, 1), "twist": (2, 3)}
_MESSAGES = {"odom": "Odometry", "imu": "Imu", "pose": "PoseWithCovarianceStamped"}
_MESSAGES |= {"twist": "TwistWithCovarianceStamped"}


def contradictions(node: NodeParameters) -> Findings:
    """All contradictions in the parameters of a node."""
    yield from _reversed_bounds(node)
    yield from _unread_pose(node)
    yield from _long_period(node)
    yield from _no_transform(node)
    yield from _missing_rows(node)
    yield from _gravity(node)
    for layer in map(mapping, node.values.values()):
        yield from _never_cleared(node, layer)
        yield from _not_reversing(node, layer)
    if node.name.endswith("_costmap"):
        yield from _radii(node)


def _reversed_bounds(node: NodeParameters) -> Findings:
    """A minimum above its maximum; a negative maximum stands for that of the sensor."""
    known = {name.rpartition(".")[2] for given in given_values(node) for name in given.known}
    for section in _sections(node.values) if known else ():
        for name, value in section.items():
            greatest = _MIN.sub("max", name)
            if greatest == name or not known.issuperset((name, greatest)):
                continue
            low, high = _number(value), _number(section.get(greatest))
            if low is not None and high is not None and low > high >= 0:
                yield _warning(
                    value,
                    f"'{node.name}': {name} is {low:g}, above {greatest}, {high:g}",
                    f"write {high:g} or less, or a greater {greatest}",
                )


def _unread_pose(node: NodeParameters) -> Findings:
    """An initial pose of AMCL that is not used, as ``set_initial_pose`` is false by default."""
    pose, switch = mapping(node.values.get("initial_pose")), node.values.get("set_initial_pose")
    x, is_moved = pose.get("x"), any(_number(value) for value in pose.values())
    is_unset = switch is None or (is_moved and _is(node.values, "set_initial_pose", "false"))
    if node.name == "amcl" and isinstance(x, Value) and is_unset:
        message = "'amcl': initial_pose is not read without set_initial_pose: true"
        yield _warning(switch or x, message, "write set_initial_pose: true")


def _long_period(node: NodeParameters) -> Findings:
    """A step of MPPI below the period of the controller, at which the controller stops."""
    frequency = _number(node.values.get("controller_frequency"), _FREQUENCY)
    for section in map(mapping, node.values.values()) if node.name == _CONTROLLER else ():
        plugin, step = section.get("plugin"), section.get("model_dt")
        seconds = _number(step, _STEP)
        if not isinstance(plugin, Value) or plugin.text.replace("/", "::") != _MPPI:
            continue
        if seconds and frequency and 1 / frequency > seconds + _TOLERANCE:
            yield Finding(
                (step if isinstance(step, Value) else plugin).span,
                f"'{node.name}' stops: model_dt is {seconds:g} s, below the period of "
                f"{1 / frequency:.4g} s of controller_frequency {frequency:g}",
                f"write model_dt: {_rounded_up(1 / frequency)}, or a controller_frequency of "
                f"{1 / seconds:g} or more",
                severity=Severity.ERROR,
            )


def _no_transform(node: NodeParameters) -> Findings:
    """A period of slam_toolbox that stands for no transform at all."""
    period = node.values.get("transform_publish_period")
    if node.name == "slam_toolbox" and isinstance(period, Value) and _number(period) == 0:
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
    if values and all(value.text.lower() == "false" for value in values):
        message = f"'{node.name}' reads nothing: all values of its inputs are false"
        yield _warning(values[0], message, "write true for what the filter reads of a message")
    for key, (kind, given) in inputs.items():
        for row, title in enumerate(_ROWS) if len(given) == 3 * len(_ROWS) else ():
            read = [value for value in given[3 * row : 3 * row + 3] if value.text.lower() == "true"]
            if read and row not in _OF_MESSAGE[kind]:
                yield _warning(
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
        if not is_imu or given[-1].text.lower() != "true" or _is(node.values, "two_d_mode", "true"):
            continue
        switch = f"{key.removesuffix('_config')}_remove_gravitational_acceleration"
        if switch not in node.values or _is(node.values, switch, "false"):
            message = (
                f"'{node.name}' reads the vertical acceleration of an IMU, which contains that "
            )
            message += f"of gravity, without {switch}: the robot rises"
            yield Finding(given[-1].span, message, f"write {switch}: true", severity=Severity.INFO)


def without_footprint(sections: list[NodeParameters]) -> Findings:
    """A critic of MPPI that considers the footprint of a robot that has only a radius."""
    costmaps = [node.values for node in sections if node.name == "local_costmap"]
    has_radius = len(costmaps) == 1 and "robot_radius" in costmaps[0]
    footprint = costmaps[0].get("footprint") if has_radius else None
    if not has_radius or (
        footprint and (not isinstance(footprint, Value) or footprint.text != "[]")
    ):
        return
    for node in sections:
        for plugin in map(mapping, node.values.values()) if node.name == _CONTROLLER else ():
            for name, critic in plugin.items():
                switch = mapping(critic).get(_CONSIDERED)
                is_on = isinstance(switch, Value) and switch.text.lower() == "true"
                if isinstance(switch, Value) and is_on and name in _OF_FOOTPRINT:
                    yield Finding(
                        switch.span,
                        f"'{node.name}' stops: {name} has {_CONSIDERED}, but local_costmap has "
                        "robot_radius and no footprint",
                        f"write {_CONSIDERED}: false, or give local_costmap a footprint",
                        severity=Severity.ERROR,
                    )


def _never_cleared(node: NodeParameters, layer: dict[str, Node]) -> Findings:
    """Sources of an obstacle layer that mark cells which no ray clears."""
    listed = layer.get("observation_sources")
    names = listed.text.split() if isinstance(listed, Value) else []
    sources = [mapping(layer.get(name)) for name in names]
    for source in sources:
        for marked, cleared in _RANGES:
            farthest, ray = _number(source.get(marked)), _number(source.get(cleared))
            value = source.get(cleared)
            if farthest and ray and ray < farthest and _is(source, "clearing", "true"):
                yield _warning(
                    value,
                    f"'{node.name}': {cleared} {ray:g} is below {marked} {farthest:g}: obstacles "
                    "behind it are never cleared",
                    f"write more than {farthest:g}",
                )
    switches = [source.get("clearing") for source in sources]
    if switches and all(_is(source, "clearing", "false") for source in sources):
        message = f"'{node.name}': obstacles are never cleared: no source has clearing: true"
        yield _warning(switches[0], message, "write clearing: true")


def _not_reversing(node: NodeParameters, section: dict[str, Node]) -> Findings:
    """Reversing, which the regulated pure pursuit does not do if it rotates on the spot."""
    plugin, switch = section.get("plugin"), section.get("allow_reversing")
    is_pursuit = isinstance(plugin, Value) and plugin.text.replace("/", "::") == _PURSUIT
    names = ("allow_reversing", "use_rotate_to_heading")
    if is_pursuit and all(_is(section, name, "true") for name in names):
        yield _warning(
            switch,
            f"'{node.name}' does not reverse: allow_reversing is not used with "
            "use_rotate_to_heading",
            "write use_rotate_to_heading: false, or remove allow_reversing",
        )


def _radii(node: NodeParameters) -> Findings:
    """An inflation radius within the robot, and a radius that a footprint replaces."""
    radius, footprint = node.values.get("robot_radius"), node.values.get("footprint")
    points = _points(footprint.text) if isinstance(footprint, Value) else []
    inscribed, circumscribed = _radii_of(points) if points else (_number(radius), None)
    given = _number(radius)
    if isinstance(footprint, Value) and circumscribed and circumscribed > _size(node):
        yield _warning(
            footprint,
            f"'{node.name}': the footprint reaches {circumscribed:.3g} m from the robot, beyond "
            f"the costmap of {_size(node):g} m",
            "write the footprint in metres",
        )
        return
    if (
        given
        and inscribed
        and circumscribed
        and not 0.9 * inscribed <= given <= 1.1 * circumscribed
    ):
        yield _warning(
            radius,
            f"'{node.name}': robot_radius {given:g} is not read: the costmap has a footprint, "
            f"of {inscribed:.3g} to {circumscribed:.3g} m",
            "remove robot_radius or the footprint",
        )
    for layer in map(mapping, node.values.values()):
        plugin, inflation = layer.get("plugin"), layer.get("inflation_radius")
        is_inflation = isinstance(plugin, Value) and plugin.text.endswith(_INFLATION)
        width = _number(inflation)
        if is_inflation and inscribed and width is not None and width < inscribed - _TOLERANCE:
            yield _warning(
                inflation,
                f"'{node.name}': inflation_radius {width:g} is below the inscribed radius of the "
                f"robot, {inscribed:.3g} m",
                f"write more than {inscribed:.3g}",
            )


def _size(node: NodeParameters) -> float:
    """The greater side of a costmap that moves with the robot, otherwise infinite."""
    if not _is(node.values, "rolling_window", "true"):
        return inf
    return max(_number(node.values.get(side), _SIDE) or inf for side in ("width", "height"))


def _points(text: str) -> list[tuple[float, float]]:
    pairs = re.findall(r"\[\s*([^\[\],]+),\s*([^\[\],]+)\]", text)
    values = [(number(x.strip()), number(y.strip())) for x, y in pairs]
    known = [(x, y) for x, y in values if x is not None and y is not None]
    return known if len(known) == len(pairs) >= 3 else []


def _radii_of(points: list[tuple[float, float]]) -> tuple[float, float]:
    """The least distance of an edge from the origin, and the greatest of a corner."""
    edges = zip(points, points[1:] + points[:1], strict=True)
    return min(_distance(*edge) for edge in edges), max(hypot(*point) for point in points)


def _distance(start: tuple[float, float], end: tuple[float, float]) -> float:
    """The distance of a line segment from the origin."""
    x, y = end[0] - start[0], end[1] - start[1]
    length = x * x + y * y
    at = -(start[0] * x + start[1] * y) / length if length else 0.0
    at = min(1.0, max(0.0, at))
    return hypot(start[0] + at * x, start[1] + at * y)


def _sections(values: dict[str, Node]) -> Iterator[dict[str, Node]]:
    stack = [values]
    while stack:
        section = stack.pop()
        yield section
        stack += [inner for inner in section.values() if isinstance(inner, dict)]


def _number(node: Node, default: float | None = None) -> float | None:
    """The number of a value; the default if there is no value."""
    return number(node.text) if isinstance(node, Value) else default if node is None else None


def _is(section: dict[str, Node], key: str, text: str) -> bool:
    value = section.get(key)
    return isinstance(value, Value) and value.text.lower() == text


def _warning(at: Node | Key, message: str, help: str) -> Finding:
    assert isinstance(at, Value)
    return Finding(at.span, message, help, severity=Severity.WARNING)
