"""Bridges between gz-sim and ROS."""

from collections.abc import Iterable

from urdfkit.ros.launch.bridges import TO_GAZEBO, bridged_topics, is_bridge
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.spawning import model_spawner
from urdfkit.workspace.resolve import Resolver

_TRANSFORMS = "TFMessage"


def bridges_of_gz(programs: tuple[StartedProgram, ...]) -> list[StartedProgram] | None:
    """The bridges of a gz-sim with a robot; None without it, or if their topics are unknown."""
    is_spawned = any(node.package == "ros_gz_sim" and model_spawner(node) for node in programs)
    bridges = [node for node in programs if is_bridge(node)]
    return bridges if is_spawned and all(map(_is_known, bridges)) else None


def may_bridge_transforms(programs: Iterable[StartedProgram], resolver: Resolver) -> bool:
    """True if a bridge forwards transforms of Gazebo, or its topics are unknown."""
    return any(
        (is_bridge(node) and not _is_known(node))
        or any(
            topic.ros_type.endswith(_TRANSFORMS) and topic.direction != TO_GAZEBO
            for topic in bridged_topics(node, resolver)
        )
        for node in programs
    )


def _is_known(bridge: StartedProgram) -> bool:
    """True if all topics of a bridge are known."""
    has_file = bridge.parameters.values.get("config_file", "") is not None
    is_whole = bridge.parameters.every is not None
    return has_file and is_whole and all(word.text is not None for word in bridge.words)
