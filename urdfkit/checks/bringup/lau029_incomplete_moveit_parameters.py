"""MoveIt does not get parameters that it needs, or reads them in another place.

- A planning pipeline has no plugin (warning), neither in the file of MoveItConfigsBuilder nor in
  the dictionaries that the launch file passes to move_group ("Planning plugin name is empty or not
  defined in namespace 'ompl'").
- `default_planning_pipeline` is not in `planning_pipelines` (warning; the builder stops).
- The solvers are not below `robot_description_kinematics` (info: in Humble they may also be at the
  top level). RViz does not get them (warning): "No active joints or end effectors found", and no
  interactive markers.
- A file of MoveItConfigsBuilder has `ros__parameters`, or the name that the builder puts around it
  (warning). Or the builder cannot choose among several files of controllers.
- move_group gets no SRDF, or not the kinematics.yaml or joint_limits.yaml that the launch file
  mentions (warning).
- Servo does not get its parameters in `moveit_servo` (warning). Or it is the primary monitor of the
  planning scene next to move_group, which provides that scene (warning).

Sources:
    MoveIt, MoveItConfigsBuilder: https://github.com/moveit/moveit2/blob/main/moveit_configs_utils/moveit_configs_utils/moveit_configs_builder.py
    MoveIt, since Iron: https://github.com/Interbotix/interbotix_ros_manipulators/issues/133
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.core.words import few
from urdfkit.lint.rules import Context, Finding, Findings, Need, Related, Severity, reported, rule
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.text.located_yaml import Node, Value, load, mapping

NAME = "launch/move_group.launch.py"
BAD = """\
from launch_ros.actions import Node

OMPL = "ompl_interface/OMPLPlanner"
nodes = [
    Node(
        package="moveit_ros_move_group",
        executable="move_group",
        parameters=[{"planning_pipelines": ["ompl"], "ompl": {}}],
    ),
]
"""
GOOD = BAD.replace("{}", '{"planning_plugins": [OMPL]}')
FILES = {"package.xml": b"<package><name>arm</name></package>"}

_MOVE_GROUP, _SERVO = "moveit_ros_move_group", "moveit_servo"
_PRIMARY = "is_primary_planning_scene_monitor"


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    yield from reported(context, "LAU029")
    for program in context.launch.started:
        yield from _unknown_pipeline(program)
    yield from _second_scene(context)


def _unknown_pipeline(program: StartedProgram) -> Findings:
    """A default planning pipeline of MoveIt that is not loaded."""
    name = program.parameters.values.get("default_planning_pipeline")
    loaded = program.parameters.lists.get("planning_pipelines", ())
    names = [pipeline for pipeline in loaded if pipeline]
    if name and names and len(names) == len(loaded) and name not in names:
        yield Finding(
            program.at,
            f"default_planning_pipeline '{name}' is not in planning_pipelines: {few(names, 4)}",
            f"add '{name}' to planning_pipelines, with its settings",
            severity=Severity.WARNING,
        )


def _second_scene(context: Context) -> Findings:
    """A Servo that provides a planning scene of its own next to that of move_group."""
    started = {node.package: node for node in context.launch.started if node.is_sure}
    if _MOVE_GROUP not in started or _SERVO not in started:
        return
    paths = {file.path for file in context.launch.files if file.path.endswith((".yaml", ".yml"))}
    for path in sorted(paths):
        source = context.resolver.readable(path)
        is_meant = source is not None and _PRIMARY.encode() in source.data
        for value in _values_of(load(source), _PRIMARY) if source and is_meant else ():
            if value.boolean:
                yield Finding(
                    value.span,
                    f"Servo and move_group both provide the planning scene: {_PRIMARY} is true",
                    f"write {_PRIMARY}: false",
                    related=(Related(started[_MOVE_GROUP].span, "move_group is started here"),),
                    severity=Severity.WARNING,
                )


def _values_of(node: Node | None, name: str) -> Iterator[Value]:
    """The values of a name, also below other names."""
    for key, value in mapping(node).items():
        if key == name and isinstance(value, Value):
            yield value
        yield from _values_of(value, name) if isinstance(value, dict) else ()
