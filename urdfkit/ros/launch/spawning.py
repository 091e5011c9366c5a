"""The programs that spawn models in Gazebo, and their command lines: ``catalog/launch.json``."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from urdfkit.core.record import Record
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.contents import StartedProgram, Word


class ModelSpawner(Record):
    """A program that spawns models in Gazebo; the spawner of ros2_control loads controllers."""

    #: valued and plain: its options with and without a value.
    valued: frozenset[str]
    plain: frozenset[str]
    required: tuple[tuple[str, ...], ...]  # groups of options; one option of each is required
    is_strict: bool  # True if it rejects unknown options instead of ignoring them

    @property
    def known(self) -> frozenset[str]:
        return self.valued | self.plain


_NUMBER = re.compile(r"-[\d.]")
#: An option and its value in one word, which argparse accepts: ``-z0.5``, ``-z 0.5``.
_WITH_NUMBER = re.compile(r"-([A-Za-z]) *(-?[\d.]+) *$")


def model_spawner(program: StartedProgram) -> ModelSpawner | None:
    """The options of a program that spawns models in Gazebo; None for other programs."""
    entry = data("launch")["spawners"].get(program.key)
    if entry is None:
        return None
    valued, plain = (frozenset(entry[key].split()) for key in ("valued", "plain"))
    required = tuple(tuple(group.split()) for group in entry["required"])
    return ModelSpawner(valued, plain, required, entry["is_strict"])


def options(program: StartedProgram, spawner: ModelSpawner) -> tuple[dict[str, Word], bool]:
    """Options with the words of their values; the boolean is False if some may be unknown."""
    found_options: dict[str, Word] = {}
    is_known = True
    words = _without_ros_arguments(program.words)
    for word in words:
        text = word.text
        if text is None or not text.startswith("-") or _NUMBER.match(text):
            is_known = is_known and text is not None
            continue
        option, _, value = text.lstrip("-").partition("=")
        if spawner.is_strict and (match := _WITH_NUMBER.match(text)):
            option, value = match.groups()
        if not spawner.is_strict:
            option = option.replace("-", "_")  # gflags accepts both
        found_options[option] = Word(value, word.span) if value else word
        if option in spawner.valued and not value:
            found_options[option] = next(words, word)
    return found_options, is_known


def _without_ros_arguments(words: Iterable[Word]) -> Iterator[Word]:
    """The words that are not between ``--ros-args`` and ``--``."""
    is_of_ros = False
    for word in words:
        text = word.text or ""
        if text.startswith("--ros-args"):
            is_of_ros = True
        elif is_of_ros:
            is_of_ros = text != "--"
        else:
            yield word


def spawn_option(program: StartedProgram, name: str) -> Word | None:
    """The value of an option of a program that spawns models; None if it is missing."""
    spawner = model_spawner(program)
    return options(program, spawner)[0].get(name) if spawner else None


def spawns_sdf(program: StartedProgram) -> bool:
    """True for a program that spawns a model of a file in SDF, or of an unknown one."""
    file = spawn_option(program, "file")
    return file is not None and (file.text is None or file.text.endswith(".sdf"))
