"""Controllers that a launch file loads: command lines of the spawner and of ros2control.

Sources: ``spawner`` of ros-controls/ros_control (noetic) and of ros-controls/ros2_control (humble
to rolling), ``load_controller`` of its ros2controlcli.
"""

from collections.abc import Iterator
from itertools import pairwise

from urdfkit.ros.launch.contents import StartedProgram, Word

_SPAWNERS = ("spawner", "spawner.py")
_LOADS = ("load", "spawn")
_LOAD_CONTROLLER = ("ros2", "control", "load_controller")
MANAGER = "controller_manager"
_MANAGER = ("-c", "--controller-manager")
#: Options with a value.
_VALUED = frozenset(
    "-c --controller-manager -p --param-file -n --namespace -t --controller-type -r --timeout "
    "--controller-manager-timeout --switch-timeout --service-call-timeout --controller-ros-args "
    "--wait-for --shutdown-timeout --set-state --spin-time".split()
)
#: Options and words that load controllers without starting them.
_LEFT_INACTIVE = ("--inactive", "--stopped", "--load-only", "load")
#: Options that define the type of a controller.
_DEFINING = frozenset(("-t", "--controller-type"))


def controllers(started: StartedProgram) -> Iterator[Word]:
    """Names of the controllers that a program loads, unless it defines their type itself."""
    words = _arguments(started)
    texts = [(word.text or "").partition("=")[0] for word in words]
    if not _DEFINING.isdisjoint(texts):
        return
    is_value = False
    for word, text in zip(words, texts, strict=True):
        if text == "--ros-args":
            return
        if not is_value and word.text and not text.startswith("-"):
            yield word
        is_value = has_value(text) and "=" not in (word.text or "")


def has_value(option: str) -> bool:
    """True for an option with a value; argparse also accepts its first letters."""
    if option.startswith("--") and len(option) > 2:
        return any(valued.startswith(option) for valued in _VALUED)
    return option in _VALUED


def manager(started: StartedProgram) -> Word | None:
    """The controller manager in the command line of a program; None if it is missing."""
    words = _arguments(started)
    for flag, word in pairwise(words):
        if flag.text in _MANAGER:
            return word
    assigned = (word for word in words if (word.text or "").startswith("--controller-manager="))
    assignment = next(assigned, None)
    return assignment and Word((assignment.text or "").partition("=")[2], assignment.span)


def manager_name(started: StartedProgram) -> str | None:
    """Full name of the controller manager that a program calls; None if unknown."""
    option = manager(started)
    is_known = option is None or bool(option.text)
    has_namespace = any((word.text or "").startswith("--namespace") for word in started.words)
    if started.namespace is None or not is_known or has_namespace:  # --namespace is of ROS 1
        return None
    return resolve_name(option.text or "" if option else MANAGER, started.namespace)


def resolve_name(name: str, namespace: str | None) -> str:
    """Full name of a ROS resource, such as a topic, in a namespace."""
    return name if name.startswith("/") else f"/{namespace}/{name}".replace("//", "/")


def topic_name(name: str, started: StartedProgram) -> str | None:
    """Full name of a topic of a node, after remapping; None if unknown."""
    if started.remappings is None or started.namespace is None:
        return None
    full_name = resolve_name(name, started.namespace)
    renames = {resolve_name(old, started.namespace): new for old, new in started.remappings.items()}
    return resolve_name(renames.get(full_name, full_name), started.namespace)


def activates(started: StartedProgram) -> bool:
    """True if a program also starts the controllers that it loads."""
    texts = {word.text for word in started.words}
    return None not in texts and texts.isdisjoint(_LEFT_INACTIVE)


def _arguments(started: StartedProgram) -> tuple[Word, ...]:
    """The words after the command; empty if it loads no controllers."""
    words = started.words
    if started.package == MANAGER:
        if started.executable in _SPAWNERS:
            return words
        if started.executable == MANAGER and words and words[0].text in _LOADS:
            return words[1:]
    if tuple(word.text for word in words[:3]) == _LOAD_CONTROLLER:
        return words[3:]
    return ()
