"""A map lacks a value or has an invalid one, or a node that localizes gets no map.

- map_server stops at a map without `image`, `resolution`, `origin` or a threshold, and at a value
  that is not a number. Thresholds are shares of black: above 1, or with the free one above the
  occupied one, cells are wrong (warning).
- map_server gets no map: "parameter 'yaml_filename' is not initialized" (warning).
- For `localization` slam_toolbox needs a `map_file_name` (info: RViz or a service may load it).

Sources:
    Nav2, map server: https://docs.nav2.org/configuration/packages/configuring-map-server.html
    Nav2, map_io.cpp: https://github.com/ros-navigation/navigation2/blob/main/nav2_map_server/src/map_io.cpp
    slam_toolbox: https://github.com/SteveMacenski/slam_toolbox
"""

from collections.abc import Iterator

from urdfkit.checks.bringup.read_parameters import read_sections
from urdfkit.core.suggest import did_you_mean
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.robot.values import number
from urdfkit.ros.launch.contents import MAP, StartedProgram
from urdfkit.ros.launch.samples import nav2_launch
from urdfkit.text.located_yaml import Node, Value, is_template, load, mapping, scalar, scalars
from urdfkit.text.source import Source, Span
from urdfkit.workspace.launch_files import launch_files

NAME = "launch/localization.launch.py"
BAD = nav2_launch("nav2_map_server", "map_server", '{"yaml_filename": "../hall.yaml"}')
GOOD = BAD.replace("hall.yaml", "sound.yaml")
_MAP_FILE = b"image: hall.pgm\nresolution: %s\norigin: [0.0, 0.0, 0.0]\nnegate: 0\n"
_LIMITS = b"occupied_thresh: 0.65\nfree_thresh: 0.25\n"
FILES = {
    "hall.yaml": _MAP_FILE % b"5 cm" + _LIMITS,
    "sound.yaml": _MAP_FILE % b"0.05" + _LIMITS,
    "hall.pgm": b"P5 1 1 255\n\xff",
    "package.xml": b"<package><name>arm</name></package>",
}

_MAP, _GRAPH = "yaml_filename", "map_file_name"
_REQUIRED = ("image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh")
_NUMBERS = ("resolution", "occupied_thresh", "free_thresh")
_MODES = ("trinary", "scale", "raw")


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    yield from _invalid_maps(context)
    yield from _missing_maps(context)
    yield from _missing_graphs(context)


def _invalid_maps(context: Context) -> Findings:
    """Maps of a launch file that lack a value, or have one that is not readable."""
    for path in dict.fromkeys(use.path for use in context.launch.files if use.purpose == MAP):
        source = context.resolver.readable(path) if path.endswith((".yaml", ".yml")) else None
        values = mapping(load(source)) if source else {}
        if source and values.keys() & {"image", "resolution"}:
            for at, message, help in _problems(source, values):
                yield Finding(at, f"map_server stops: {message}", help)
            yield from _thresholds(values)


def _missing_maps(context: Context) -> Findings:
    """A map_server that gets no map."""
    for node in context.launch.started if not context.launch.has_scopes else ():
        is_server = node.key == "nav2_map_server/map_server"
        if is_server and node.is_sure and not _may_have_map(node, context):
            yield Finding(
                node.at,
                f"map_server stops: parameter '{_MAP}' is not given",
                f"set {_MAP} to the YAML file of a map",
                severity=Severity.WARNING,
            )


def _missing_graphs(context: Context) -> Findings:
    """Localization of slam_toolbox without a map; an info, as RViz or a service may load it."""
    directory = context.resolver.packages.workspace(context.source.path)
    for node in read_sections(context):
        mode = node.values.get("mode") if node.name == "slam_toolbox" else None
        is_localizing = isinstance(mode, Value) and mode.text == "localization"
        if not isinstance(mode, Value) or not is_localizing or _GRAPH in node.values:
            continue
        if not any(launch_files(directory, _GRAPH, context.resolver)):
            yield Finding(
                mode.span,
                f"'slam_toolbox' starts without a map to localize in: {_GRAPH} is not given",
                "write the path of a serialized map, without .posegraph, or mode: mapping",
                severity=Severity.INFO,
            )


def _may_have_map(node: StartedProgram, context: Context) -> bool:
    """True if a parameter names the map, or is unknown."""
    given = node.parameters
    if not given.is_whole or _MAP in given.values or node.words:
        return True
    sources = [context.resolver.readable(path) for path in given.files]
    return any(source is None or _MAP.encode() in source.data for source in sources)


def _problems(source: Source, values: dict[str, Node]) -> Iterator[tuple[Span, str, str]]:
    for key in _REQUIRED:
        if key not in values:
            hint = did_you_mean(key, values.keys() - set(_REQUIRED))
            yield Span(source, 0, 0), f"the map has no {key}{hint}", f"add {key}"
    for key in _NUMBERS:
        value = scalar(values, key)
        if value and not is_template(value.text) and number(value.text) is None:
            yield value.span, f"{key} '{value.text}' is not a number", "write a number"
    resolution, mode = scalar(values, "resolution"), scalar(values, "mode")
    if resolution and (number(resolution.text) or 1.0) < 0:
        yield resolution.span, f"resolution {resolution.text} is negative", "write m per pixel"
    origin = values.get("origin")
    numbers = [number(value.text) for value in scalars(origin)]
    if isinstance(origin, list) and origin and (len(numbers) != 3 or None in numbers):
        first = scalars(origin)[0].span if scalars(origin) else Span(source, 0, 0)
        yield first, f"origin has {len(origin)} values, not 3 numbers", "write [x, y, yaw]"
    if mode and not is_template(mode.text) and mode.text not in _MODES:
        hint = did_you_mean(mode.text, _MODES)
        yield mode.span, f"unknown mode '{mode.text}'{hint}", f"write {', '.join(_MODES)}"


def _thresholds(values: dict[str, Node]) -> Findings:
    """A cell cannot be free and occupied; thresholds are shares of black, not percent."""
    for key in _NUMBERS[1:]:
        value = scalar(values, key)
        share = number(value.text) if value else None
        if value and share is not None and share > 1:
            yield Finding(
                value.span,
                f"{key} is {share:g}, above 1: it is the share of black of a cell",
                f"write {share / 100:g}" if share <= 100 else "write a number from 0 to 1",
                severity=Severity.WARNING,
            )
    free, occupied = scalar(values, "free_thresh"), scalar(values, "occupied_thresh")
    if free and occupied:
        low, high = number(free.text), number(occupied.text)
        if low is not None and high is not None and low > high:
            yield Finding(
                free.span,
                f"free_thresh {low:g} is above occupied_thresh {high:g}: free cells are occupied",
                "write free_thresh: 0.25 and occupied_thresh: 0.65",
                severity=Severity.WARNING,
            )
