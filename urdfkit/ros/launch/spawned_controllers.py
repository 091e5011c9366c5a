"""Controllers that a launch file loads: command lines of the spawner and of ros2control.

Sources: ``spawner`` of ros-controls/ros_control (noetic) and of ros-controls/ros2_control (humble
to rolling), ``load_controller`` of its ros2controlcli.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import pairwise

from urdfkit.core.record import Record
from urdfkit.core.suggest import CLOSE_TYPO, nearest
from urdfkit.ros.launch.contents import StartedProgram, Word
from urdfkit.text.document import Location

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
#: Suffixes of the files that the spawner of ROS 1 takes instead of a name.
_FILES = (".yaml", ".yml")
#: Options that define the type of a controller.
_DEFINING = frozenset(("-t", "--controller-type"))


class SpawnedController(Record):
    """A controller that a program loads."""

    word: Word  # of the command line
    program: StartedProgram

    @property
    def name(self) -> str:
        return self.word.name

    @property
    def at(self) -> Location:
        """Location of its name in the command line."""
        return Location(self.word.span, self.program.frame)

    @property
    def is_activated(self) -> bool:
        """True if the program also starts the controllers that it loads."""
        texts = {word.text for word in self.program.words}
        return None not in texts and texts.isdisjoint(_LEFT_INACTIVE)


def spawned_controllers(programs: Iterable[StartedProgram]) -> Iterator[SpawnedController]:
    """The controllers that programs load, unless a program defines their type itself."""
    for program in programs:
        yield from (SpawnedController(word, program) for word in _controllers(program))


def spawns_controllers(program: StartedProgram) -> bool:
    return any(True for _ in _controllers(program))


def _controllers(program: StartedProgram) -> Iterator[Word]:
    """The names of controllers in the command line of a program.

    The spawner of ROS 1 also takes parameter files, and loads all that they define.
    """
    words = _arguments(program)
    texts = [(word.text or "").partition("=")[0] for word in words]
    if not _DEFINING.isdisjoint(texts):
        return
    is_value = False
    for word, text in zip(words, texts, strict=True):
        if text == "--ros-args":
            return
        is_option = text.startswith("-")
        is_file = text.endswith(_FILES) and not program.is_ros_2
        if not is_value and word.text and not is_option and not is_file:
            yield word
        is_misspelt = text.startswith("--") and bool(nearest(text, _VALUED, CLOSE_TYPO))
        is_value = (has_value(text) or is_misspelt) and "=" not in (word.text or "")


def parameter_files(started: StartedProgram) -> Iterator[Word]:
    """The files of ``--param-file`` in the command line of a spawner."""
    for flag, word in pairwise(_arguments(started)):
        if flag.text in ("-p", "--param-file"):
            yield word


def has_value(option: str) -> bool:
    """True for an option with a value; argparse also accepts its first letters."""
    if option.startswith("--") and len(option) > 2:
        return any(valued.startswith(option) for valued in _VALUED)
    return option in _VALUED


def manager(program: StartedProgram) -> Word | None:
    """The controller manager in the command line of a program; None if it is missing."""
    words = _arguments(program)
    for flag, word in pairwise(words):
        if flag.text in _MANAGER:
            return word
    assigned = (word for word in words if (word.text or "").startswith("--controller-manager="))
    assignment = next(assigned, None)
    return assignment and Word((assignment.text or "").partition("=")[2], assignment.span)


def manager_name(program: StartedProgram) -> str | None:
    """Full name of the controller manager that a program calls; None if unknown."""
    option = manager(program)
    is_known = bool(option.text) if option else all(word.text for word in program.words)
    has_namespace = any((word.text or "").startswith("--namespace") for word in program.words)
    if program.namespace is None or not is_known or has_namespace:  # --namespace is of ROS 1
        return None
    return resolve_name(option.text or "" if option else MANAGER, program.namespace)


def resolve_name(name: str, namespace: str | None) -> str:
    """Full name of a ROS resource, such as a topic, in a namespace."""
    return name if name.startswith("/") else f"/{namespace}/{name}".replace("//", "/")


def topic_name(name: str, program: StartedProgram) -> str | None:
    """Full name of a topic of a node, after remapping; None if unknown."""
    if program.remappings is None or program.namespace is None:
        return None
    if name.startswith("~") and not program.name:
        return None
    full_name = _resolved(name, program)
    renames = {_resolved(old, program): new for old, new in program.remappings.items()}
    return _resolved(renames.get(full_name, full_name), program)


def _resolved(name: str, program: StartedProgram) -> str:
    """Full name of a topic of a node; ``~`` stands for the node."""
    own = f"{program.name}{name[1:]}" if name.startswith("~/") and program.name else name
    return resolve_name(own, program.namespace)


def _arguments(program: StartedProgram) -> tuple[Word, ...]:
    """The words after the command; empty if it loads no controllers."""
    words = program.words
    if program.package == MANAGER:
        if program.executable in _SPAWNERS:
            return words
        if program.executable == MANAGER and words and words[0].text in _LOADS:
            return words[1:]
    if tuple(word.text for word in words[:3]) == _LOAD_CONTROLLER:
        return words[3:]
    return ()
