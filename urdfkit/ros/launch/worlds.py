"""The Gazebo worlds that a launch file starts: ``catalog/worlds.json``."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from urdfkit.core import disk
from urdfkit.core.record import Record
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.collect import UNKNOWN
from urdfkit.ros.launch.command_line import command_words
from urdfkit.ros.launch.contents import IncludedFile, Launch, StartedProgram, Word
from urdfkit.text.document import CallFrame, Location
from urdfkit.text.source import Span
from urdfkit.workspace.resolve import Resolver

GZ, CLASSIC = "gz", "classic"
#: The library of Gazebo Classic that spawns robots in ROS 2.
FACTORY = "libgazebo_ros_factory.so"

#: Libraries that the launch files and nodes of gazebo_ros load.
_OF_ROS = ("libgazebo_ros_init.so", FACTORY)
#: Commands that start Gazebo's server: a program, or a program and its first word.
_COMMANDS = {("gz", "sim"): GZ, ("ign", "gazebo"): GZ, ("gazebo",): CLASSIC, ("gzserver",): CLASSIC}

#: Directories of a workspace that are searched for a world without a path.
_MAX_DIRECTORIES = 2000

#: The option for messages, and its long form.
_VERBOSE = ("-v", "--verbose")
#: An option, or the number of the verbosity, and an absolute path.
_GLUED = re.compile(r"(-\w+|--[a-z-]+|\d+)(/.*)")
#: The option that starts the simulation at once, alone or with others of one letter.
_RUN = re.compile(r"-[a-z]*r[a-z]*\d*$")


class StartedWorld(Record):
    """A world that a launch file starts."""

    generation: str  # ``gz`` or ``classic``
    name: str  # a path, or the name of a world that comes with Gazebo; empty for the default one
    engine: str  # the render engine in the command line; empty if it is missing
    libraries: tuple[str, ...]  # system plugins that the command line loads into Gazebo Classic
    has_window: bool  # False if only the server is started
    span: Span  # of the world's name
    frame: CallFrame | None  # the including launch files
    is_sure: bool  # False if it depends on a condition that is known only at run time
    is_paused: bool = False  # True if gz sim waits until the user starts the simulation
    glued_to: str = ""  # the option or its value from which no space separates the world

    @property
    def at(self) -> Location:
        """Location of the world's name."""
        return Location(self.span, self.frame)

    @property
    def is_shipped(self) -> bool:
        """True for a world that comes with gz sim."""
        return self.generation == GZ and self.name in data("worlds")["worlds"]


def worlds(launch: Launch) -> Iterator[StartedWorld]:
    """The known worlds of a launch file and of the files that it includes."""
    for included in launch.includes:
        if world := _of_file(included):
            yield world
    for program in launch.programs:
        if world := _of_program(program):
            yield world


def world_file(name: str, near: str, resolver: Resolver) -> str | None:
    """The file of a world: its path, or the only file of that name in the workspace of a file."""
    if os.path.isabs(name):
        if name.startswith(f"{UNKNOWN}/"):
            return None
        return name if disk.is_file(name) else resolver.installed(name)
    root = resolver.packages.workspace(near)
    files = resolver.directories.files_below(root, _MAX_DIRECTORIES)
    ending = f"/{os.path.normpath(name)}"
    matches = [path for path in files if path.endswith(ending)]
    return matches[0] if len(matches) == 1 else None


def _of_file(included: IncludedFile) -> StartedWorld | None:
    """The world of a launch file of Gazebo's packages."""
    name = "/".join(included.path.split("/")[-3:])
    generation, *names = data("worlds")["files"].get(name, "").split() or ("",)
    if not generation or included.arguments is None:
        return None
    passed = [included.arguments[name] for name in names if name in included.arguments]
    word = next(iter(passed), Word("", included.span))
    if word.text is None:
        return None
    is_line = names[0].endswith("_args")
    runs = ["-r"] if generation == GZ else []
    words = command_words(word.text) if is_line else [*runs, word.text]
    world = _started(generation, words, word.span, included)
    return world._replace(libraries=_OF_ROS) if world else None


def _of_program(program: StartedProgram) -> StartedWorld | None:
    """The world of a node, or of a command."""
    generation = data("worlds")["programs"].get(program.key, "")
    texts = [word.text for word in program.words]
    if generation == GZ:
        path = program.parameters.values.get("world_sdf_file")
        return _started(GZ, ["-s", "-r", path], program.span, program) if path else None
    known = [text for text in texts if text is not None]
    if len(known) < len(texts):
        return None
    words = command_words(" ".join(known)) if not program.package else known
    for command, kind in _COMMANDS.items() if not program.package else ():
        if tuple(words[: len(command)]) == command:
            generation, words = kind, words[len(command) :]
            break
    world = _started(generation, words, program.span, program) if generation else None
    return world._replace(libraries=_OF_ROS) if world and program.package else world


def _split(words: list[str]) -> tuple[list[str], str]:
    """The words of a command line, and what a path follows without a space; empty if nothing."""
    parts: list[str] = []
    glued = ""
    for word in words:
        match = _GLUED.fullmatch(word)
        if match and (word.startswith("-") or (parts and parts[-1] in _VERBOSE)):
            parts += match.groups()
            glued = match[1]
        else:
            parts.append(word)
    return parts, glued


def _started(
    generation: str, words: list[str], span: Span, by: IncludedFile | StartedProgram
) -> StartedWorld | None:
    """The world of a command line; None if it starts only the window."""
    valued = data("worlds")["valued"][generation].split()
    options: dict[str, str] = {}
    libraries: list[str] = []
    names: list[str] = []
    parts, glued_to = _split(words) if generation == GZ else (words, "")
    rest = iter(parts)
    for word in rest:
        option, _, value = word.partition("=")
        if not word.startswith("-"):
            names.append(word)
            continue
        if option in valued and not value:
            value = next(rest, "")
        if generation == CLASSIC and option in ("-s", "--server-plugin"):
            libraries.append(os.path.basename(value))
        options[option] = value
    if generation == GZ and "-g" in options:
        return None
    runs = any(_RUN.match(option) for option in options)
    engine = options.get("--render-engine-server") or options.get("--render-engine", "")
    return StartedWorld(
        generation,
        names[0] if names else "",
        engine,
        tuple(libraries),
        generation == CLASSIC or "-s" not in options,
        span,
        by.frame,
        by.is_sure,
        is_paused=generation == GZ and not runs,
        glued_to=glued_to,
    )
