"""Actions that a Python launch file starts after an event."""

import ast
from collections import Counter
from collections.abc import Iterable, Iterator

from urdfkit.ros.launch.calls import argument, called
from urdfkit.ros.launch.launch_description import ACTIONS, TRIGGERS
from urdfkit.ros.launch.scopes import is_read
from urdfkit.ros.launch.values import Values
from urdfkit.text.diagnostic import Problem, Severity

#: Event handlers of the process of an action.
_OF_PROCESS = ("OnProcessExit", "OnProcessIO", "OnProcessStart")
#: Handlers by the argument with the actions that they start, and what limits them to one event.
_STARTS = {"OnProcessExit": "on_exit", "OnProcessStart": "on_start"}
_ONCE = ("target_action", "handle_once")
#: Actions that are processes.
_PROCESSES = ("ExecuteProcess", "Node")
#: Arguments of a handler or timer with the actions to start.
_LATER = ("on_exit", "on_start", "actions")
#: Nodes that run until the launch ends, by package and executable.
_LASTING = frozenset(
    "controller_manager/ros2_control_node joint_state_publisher/joint_state_publisher "
    "joint_state_publisher_gui/joint_state_publisher_gui ros_gz_bridge/parameter_bridge "
    "robot_state_publisher/robot_state_publisher".split()
)


def wrong_handlers(calls: list[ast.Call], values: Values) -> Iterator[Problem]:
    """Event handlers whose action never starts, or starts twice."""
    for call in calls:
        if called(call) == "OnProcessExit":
            yield from _after_exit(call, values)
    yield from _endless(calls, values)
    yield from _started_twice(calls, values)
    yield from _without_process(calls, values)


def _after_exit(handler: ast.Call, values: Values) -> Iterator[Problem]:
    """Actions that wait for the exit of a node that does not exit, or of themselves."""
    target, waiting = (argument(handler, None, key) for key in ("target_action", "on_exit"))
    action = values.resolved(target)
    if target is None or waiting is None or not isinstance(action, ast.Call):
        return
    started = [item for item in _listed(waiting, values) if _is_action(item, values)]
    names = [values.text(argument(action, None, key)) for key in ("package", "executable")]
    if started and "/".join(map(str, names)) in _LASTING:
        message = f"started when {names[1]} exits, but it runs until shutdown"
        help = "use the preceding spawner as target_action, or use OnProcessStart"
        yield values.problem("LAU037", waiting, message, help, Severity.WARNING)
    if any(values.resolved(item) is action for item in started):
        message = "starts when it has exited itself: launch starts an action only once"
        help = "name the preceding action as target_action"
        yield values.problem("LAU037", target, message, help, Severity.WARNING)


def waits_for_unstarted(
    expressions: Iterable[ast.expr], calls: list[ast.Call], values: Values
) -> Iterator[Problem]:
    """Event handlers of an action that nothing starts: only handlers name it.

    Args:
        expressions: all of a whole launch file.
        calls: without those in handlers that are not used.
    """
    targets = [argument(call, 0, "target_action") for call in calls if called(call) in _OF_PROCESS]
    names = [target for target in targets if isinstance(target, ast.Name)]
    expressions = list(expressions)
    reads = Counter(node.id for node in expressions if is_read(node))
    reads.subtract(name.id for name in names)
    # A parameter of a function has other names where the function is called.
    assigned = {node.id for node in expressions if isinstance(node, ast.Name) and not is_read(node)}
    for target in targets:
        if isinstance(target, ast.Call) and called(values.created(target)) in _PROCESSES:
            message = "the handler waits for an action that it creates itself: nothing starts it"
            help = "name the action that is in the LaunchDescription"
            yield values.problem("LAU037", target, message, help, Severity.WARNING)
    for name in names:
        is_idle = name.id in assigned and not reads[name.id]
        if is_idle and _kind(name, values) in _PROCESSES:
            message = f"'{name.id}' is never started, and so nothing that waits for it"
            help = f"add {name.id} to the LaunchDescription"
            yield values.problem("LAU037", name, message, help, Severity.WARNING)


def _without_process(calls: list[ast.Call], values: Values) -> Iterator[Problem]:
    """Event handlers of a process for an action that is no process."""
    for call in calls:
        target = argument(call, 0, "target_action")
        name = called(values.resolved(target))
        if called(call) not in _OF_PROCESS or target is None:
            continue
        if name in (*ACTIONS, *TRIGGERS) and name not in _PROCESSES:
            message = f"{called(call)} waits for a process, but its target_action is {name}"
            help = "name the Node whose process it is, such as the one that spawns the robot"
            yield values.problem("LAU037", target, message, help)


def _endless(calls: list[ast.Call], values: Values) -> Iterator[Problem]:
    """Processes that a handler starts at an event of any process, also at their own."""
    for call in calls:
        given = {keyword.arg for keyword in call.keywords}
        waiting = argument(call, None, _STARTS.get(called(call), ""))
        if waiting is None or call.args or not given.isdisjoint((None, *_ONCE)):
            continue
        for item in _listed(waiting, values):
            if called(values.resolved(item)) in _PROCESSES:
                event = called(call).removeprefix("OnProcess").lower()
                yield values.problem(
                    "LAU037",
                    call.func,
                    f"{called(call)} has no target_action: the {event} of each process starts the "
                    "action, which launch starts only once",
                    "write target_action=..., or handle_once=True",
                    Severity.WARNING,
                )
                break


def _started_twice(calls: list[ast.Call], values: Values) -> Iterator[Problem]:
    """Actions that are both in a launch description and in its event handler or timer."""
    for call in calls:
        entities = argument(call, 0, "initial_entities")
        if called(call) != "LaunchDescription" or entities is None:
            continue
        listed = _listed(entities, values)
        direct = {item.id: item for item in listed if isinstance(item, ast.Name)}
        later = (name for item in listed for name in _later(values.resolved(item), values))
        for name in later:
            if name.id in direct and _is_action(name, values):
                message = f"'{name.id}' is started twice: launch stops at the second start"
                help = "keep it in the event handler only"
                yield values.problem("LAU037", direct[name.id], message, help)


def _later(action: ast.expr | None, values: Values) -> Iterator[ast.Name]:
    """The names of the actions that an event handler or a timer starts."""
    if not isinstance(action, ast.Call) or called(action) not in TRIGGERS:
        return
    if argument(action, None, "condition") is not None:
        return
    for node in ast.walk(action):
        if isinstance(node, ast.keyword) and node.arg in _LATER:
            for item in _listed(node.value, values):
                if isinstance(item, ast.Name):
                    yield item


def _listed(node: ast.expr, values: Values) -> list[ast.expr]:
    """The items of a list, or a single action."""
    if _is_action(node, values):
        return [node]
    return [item for item in values.items(node) if item is not None]


def _is_action(node: ast.expr, values: Values) -> bool:
    return _kind(node, values) in ACTIONS


def _kind(node: ast.expr, values: Values) -> str:
    """The class of an action, which a function of the file may create."""
    value = values.resolved(node)
    return called(values.created(value)) if value is not None else ""
