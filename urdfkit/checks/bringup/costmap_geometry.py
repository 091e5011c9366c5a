"""Costmaps that do not move, do not inflate, or have their map or topics elsewhere.

Sources: ``costmap_2d_ros.cpp``, ``layered_costmap.cpp``, ``static_layer.cpp`` and
``obstacle_layer.cpp`` of nav2_costmap_2d, humble to rolling; ros-navigation/navigation2#1214.
"""

from __future__ import annotations

import re

from urdfkit.checks.bringup.costmaps import COSTMAPS, class_of_active_layer, class_of_layer
from urdfkit.lint.rules import Context, Finding, Findings, Severity
from urdfkit.ros.launch.releases import is_for_jazzy
from urdfkit.ros.node_parameters import NodeParameters
from urdfkit.text.located_yaml import Node, Value, mapping, scalar, scalars, words
from urdfkit.workspace.launch_files import launch_files

_STATIC, _INFLATION = "StaticLayer", "InflationLayer"
_OF_OBSTACLES = ("ObstacleLayer", _STATIC, "VoxelLayer")
#: Layers that take the size of the costmap as it is.
_SIZELESS = ("InflationLayer", "ObstacleLayer", "VoxelLayer", "SpatioTemporalVoxelLayer")
#: Who publishes the map once, and the switch of a static layer that gets it later, too.
_SERVER, _LATCHED = "map_server", "map_subscribe_transient_local"
#: The frame of the map in the parameters of the nodes that localize.
_MAP_FRAMES = {"amcl": "global_frame_id", "slam_toolbox": "map_frame", "map_server": "frame_id"}
#: What a costmap publishes, by the ending of the parameter that names it, and its readers.
_PUBLISHED = {"costmap_topic": "costmap_raw", "footprint_topic": "published_footprint"}
_READERS = ("behavior_server", "collision_monitor", "docking_server", "smoother_server")
#: Names of plugins up to Iron, and parameters of Kilted and later.
_OLD = re.compile(rb"\bnav2_(behaviors|navfn_planner|smac_planner|recoveries)/")
_NEW = re.compile(rb"\b(introspection_mode|bond_heartbeat_period|allow_parameter_qos_overrides)\b")


def unmoved(node: NodeParameters) -> Findings:
    """A costmap that stays where the robot started, without a map that gives it a size."""
    classes = _classes_of_layers(node)
    has_size = "width" in node.values and "height" in node.values
    if not classes or not set(classes) <= {*_SIZELESS} or _rolls(node) is not False:
        return
    if node.name == COSTMAPS[0] or not has_size:
        switch = scalar(node.values, "rolling_window")
        at = switch.span if switch else node.at
        yield Finding(
            at,
            f"'{node.name}' does not move with the robot, which leaves it: rolling_window is "
            f"false, and no layer is a {_STATIC}",
            f"write rolling_window: true, or add a {_STATIC}",
        )


def not_inflated(node: NodeParameters) -> Findings:
    """A layer of obstacles behind the inflation layer, which inflates those of earlier layers."""
    layers = scalars(node.values.get("plugins")) if node.name in COSTMAPS else []
    kinds = [class_of_active_layer(node.values.get(layer.text)) for layer in layers]
    if _INFLATION not in kinds:
        return
    last = len(kinds) - 1 - kinds[::-1].index(_INFLATION)
    for layer, kind in list(zip(layers, kinds, strict=True))[last + 1 :]:
        if kind in _OF_OBSTACLES:
            yield Finding(
                layer.span,
                f"'{node.name}': the obstacles of '{layer.text}' are not inflated: it stands "
                f"behind '{layers[last].text}'",
                f"write {layers[last].text} behind {layer.text}",
            )


def untransformed_map(sections: list[NodeParameters]) -> Findings:
    """A costmap with the map in the frame of odometry: only a rolling one transforms the map."""
    frames = {
        value.text.strip("/")
        for node in sections
        if isinstance(value := node.values.get(_MAP_FRAMES.get(node.name, "")), Value)
    }
    for node in sections if frames == {"map"} else ():
        frame = scalar(node.values, "global_frame")
        has_map = _STATIC in _classes_of_layers(node) and _rolls(node) is False
        if has_map and frame and frame.text.strip("/") == "odom":
            yield Finding(
                frame.span,
                f"'{node.name}' has the map in '{frame.text}' without a transform from 'map', "
                "as it does not roll",
                "write global_frame: map",
            )


def missed_maps(context: Context, sections: list[NodeParameters]) -> Findings:
    """A static layer that gets no message from before its start: map_server publishes one."""
    if not any(node.executable == _SERVER and node.is_sure for node in context.launch.programs):
        return
    for node in sections if not context.launch.has_scopes else ():
        for name, layer in node.values.items() if node.name in COSTMAPS else ():
            switch, topic = scalar(layer, _LATCHED), scalar(layer, "map_topic")
            is_of_server = topic is None or topic.text.strip("/") in ("", "map")
            is_static = class_of_active_layer(layer) == _STATIC
            if is_static and is_of_server and switch and switch.boolean is False:
                yield Finding(
                    switch.span,
                    f"'{node.name}': '{name}' misses a map that was published before it started",
                    f"write {_LATCHED}: true",
                )


def misread_costmaps(node: NodeParameters) -> Findings:
    """A topic of a costmap that it does not publish, or publishes for RViz alone."""
    stack: list[dict[str, Node]] = [node.values] if node.name in _READERS else []
    while stack:
        section = stack.pop()
        stack += [inner for inner in section.values() if isinstance(inner, dict)]
        for key, value in section.items():
            topic = next((name for end, name in _PUBLISHED.items() if key.endswith(end)), "")
            parts = value.text.strip("/").split("/") if isinstance(value, Value) else []
            is_of_costmap = topic and len(parts) > 1 and parts[-2] in COSTMAPS
            if is_of_costmap and isinstance(value, Value) and parts[-1] != topic:
                right = value.text.removesuffix(parts[-1]) + topic
                yield Finding(
                    value.span,
                    f"'{node.name}': {key} '{value.text}' is not '{topic}', which a costmap "
                    "publishes for it",
                    f"write {right}",
                )


def relative_topics(context: Context, sections: list[NodeParameters]) -> Findings:
    """Topics of layers without a slash, which are in the namespace of the costmap up to Jazzy."""
    sources = {node.at.source.path: node.at.source.data for node in sections}
    if any(_NEW.search(text) for text in sources.values()):
        return
    is_old = any(_OLD.search(text) for text in sources.values())
    if not is_old and not is_for_jazzy(context.source.path, context.resolver, sources):
        return
    reported: set[str] = set()
    for node in sections if not context.launch.has_scopes else ():
        for topic in _relative(node):
            name = f"{node.name}/{topic.text}"
            if name not in reported and not _is_renamed(topic.text, context):
                reported.add(name)
                root = _namespace(node, context)
                yield Finding(
                    topic.span,
                    f"'{node.name}' reads '{root}{name}', as up to Jazzy a relative topic is in "
                    "its namespace",
                    f"write {root}{topic.text}",
                    severity=Severity.WARNING if is_old else Severity.INFO,
                )


def _namespace(node: NodeParameters, context: Context) -> str:
    """The namespace of a costmap: a launch file passes it to Nav2, or its section has it."""
    for file in context.launch.includes:
        words = dict(file.arguments or {})
        if any(word.text == node.at.source.path for word in words.values()):
            namespace = words.get("namespace")
            name = namespace.name if namespace and namespace.text is not None else ""
            return f"/{name}/" if name else "/"
    above = node.namespace.strip("/").rpartition("/")[0]
    return f"/{above}/" if above and "*" not in above else "/"


def _is_renamed(topic: str, context: Context) -> bool:
    """True if a launch file of the workspace remaps the topic, in the costmap or everywhere."""
    directory = context.resolver.packages.workspace(context.source.path)
    renamed = [node.remappings for node in context.launch.programs]
    in_costmap = f"_costmap/{topic}".encode()
    return any(names is None or topic in names for names in renamed) or any(
        in_costmap in source.data for source in launch_files(directory, "", context.resolver)
    )


def _relative(node: NodeParameters) -> list[Value]:
    """The relative topics of the sources of a costmap's layers."""
    found: list[Value] = []
    for layer in map(mapping, node.values.values()) if node.name in COSTMAPS else ():
        for name in words(layer, "observation_sources"):
            topic = scalar(layer, name, "topic")
            if topic and re.match(r"\w", topic.text):
                found.append(topic)
    return found


def _classes_of_layers(node: NodeParameters) -> list[str]:
    """The classes of the layers of a costmap, in order; empty for other nodes."""
    layers = scalars(node.values.get("plugins")) if node.name in COSTMAPS else []
    return [class_of_layer(node.values.get(layer.text)) for layer in layers]


def _rolls(node: NodeParameters) -> bool | None:
    """None if it is not known."""
    value = scalar(node.values, "rolling_window")
    return value.boolean if value else False
