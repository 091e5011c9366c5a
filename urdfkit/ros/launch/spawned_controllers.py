"""The controllers that a launch file has loaded, by the spawner's and ros2control's command line.

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
#: Options after which the command line itself says what a controller is.
#: Options and words with which controllers are loaded and not started.
_LEFT_INACTIVE = ("--inactive", "--stopped", "--load-only", "load")
_DEFINING = frozenset(("-t", "--controller-type"))


def controllers(started: StartedProgram) -> Iterator[Word]:
    """The names of controllers that a program loads by what others define."""
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
        is_value = text in _VALUED and "=" not in (word.text or "")


def manager(started: StartedProgram) -> Word | None:
    """The controller manager that a program is told to talk to; None if it is told none."""
    words = _arguments(started)
    for flag, word in pairwise(words):
        if flag.text in _MANAGER:
            return word
    assigned = (word for word in words if (word.text or "").startswith("--controller-manager="))
    found = next(assigned, None)
    return found and Word((found.text or "").partition("=")[2], found.span)


def manager_name(started: StartedProgram) -> str | None:
    """The controller manager that a program talks to, in its namespace; None if it is not known."""
    wanted = manager(started)
    is_named = wanted is None or bool(wanted.text)
    is_elsewhere = any((word.text or "").startswith("--namespace") for word in started.words)
    if started.namespace is None or not is_named or is_elsewhere:  # --namespace is of ROS 1
        return None
    return resolve_name(wanted.text or "" if wanted else MANAGER, started.namespace)


def resolve_name(name: str, namespace: str | None) -> str:
    """A name of ROS in a namespace."""
    return name if name.startswith("/") else f"/{namespace}/{name}".replace("//", "/")


def topic_name(name: str, started: StartedProgram) -> str | None:
    """The whole name of a topic of a node, after its remappings; None where it is not known."""
    if started.remappings is None or started.namespace is None:
        return None
    whole = resolve_name(name, started.namespace)
    renamed = {resolve_name(old, started.namespace): new for old, new in started.remappings.items()}
    return resolve_name(renamed.get(whole, whole), started.namespace)


def activates(started: StartedProgram) -> bool:
    """True if a program that loads controllers starts them, too."""
    texts = {word.text for word in started.words}
    return None not in texts and texts.isdisjoint(_LEFT_INACTIVE)


def _arguments(started: StartedProgram) -> tuple[Word, ...]:
    """The words after the command; none if it loads no controllers."""
    words = started.words
    if started.package == MANAGER:
        if started.executable in _SPAWNERS:
            return words
        if started.executable == MANAGER and words and words[0].text in _LOADS:
            return words[1:]
    if tuple(word.text for word in words[:3]) == _LOAD_CONTROLLER:
        return words[3:]
    return ()
