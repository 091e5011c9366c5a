"""The programs that put models into Gazebo, and their command lines: ``catalog/launch.json``."""

from __future__ import annotations

import re

from urdfkit.core.record import Record
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.contents import StartedProgram, Word


class Spawner(Record):
    """A program that puts models into Gazebo."""

    #: valued and plain: its options with and without a value.
    valued: frozenset[str]
    plain: frozenset[str]
    required: tuple[tuple[str, ...], ...]  # groups of options, of each of which one must be there
    is_strict: bool  # True if it stops at other options; else it ignores them

    @property
    def known(self) -> frozenset[str]:
        """All its options."""
        return self.valued | self.plain


_NUMBER = re.compile(r"-[\d.]")
#: What argparse takes for an option and its value: ``-z0.5``.
_WITH_NUMBER = re.compile(r"-([A-Za-z])(-?[\d.]+)$")


def spawner_of(started: StartedProgram) -> Spawner | None:
    """The program that is started, if it puts models into Gazebo."""
    entry = data("launch")["spawners"].get(f"{started.package}/{started.executable}")
    if entry is None:
        return None
    valued, plain = (frozenset(entry[key].split()) for key in ("valued", "plain"))
    required = tuple(tuple(group.split()) for group in entry["required"])
    return Spawner(valued, plain, required, entry["is_strict"])


def options(started: StartedProgram, spawner: Spawner) -> tuple[dict[str, Word], bool]:
    """The options, with the words of their values; False if there may be others."""
    given: dict[str, Word] = {}
    is_known = True
    words = iter(started.words)
    for word in words:
        text = word.text
        if text is None or not text.startswith("-") or _NUMBER.match(text):
            is_known = is_known and text is not None
            continue
        if text.startswith("--ros-args"):
            break
        option, _, value = text.lstrip("-").partition("=")
        if spawner.is_strict and (both := _WITH_NUMBER.match(text)):
            option, value = both.groups()
        if not spawner.is_strict:
            option = option.replace("-", "_")  # gflags takes both
        given[option] = Word(value, word.span) if value else word
        if option in spawner.valued and not value:
            given[option] = next(words, word)
    return given, is_known
