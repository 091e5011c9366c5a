"""The worlds that a launch file starts, read, and the robots that it describes."""

from __future__ import annotations

import os
from collections.abc import Iterator

from urdfkit.core import disk
from urdfkit.core.record import Record
from urdfkit.errors import UnreadableFile
from urdfkit.lint.rules import Context, Location, Related
from urdfkit.ros.gazebo.worlds import World, default_systems, read_world, shipped_worlds
from urdfkit.ros.launch.collect import UNKNOWN
from urdfkit.ros.launch.worlds import GZ, StartedWorld, worlds
from urdfkit.text.diagnostic import Problem

#: Directories of a workspace that are searched for a world without a path.
_MAX_DIRECTORIES = 2000


class OpenedWorld(Record):
    """A world that is started."""

    started: StartedWorld  # by what
    path: str  # of the file; empty for one that comes with Gazebo
    name: str  # of the world
    #: In the file; None for one that comes with Gazebo, and where the file has none.
    world: World | None
    systems: frozenset[str]  # of one that comes with gz sim
    problems: tuple[Problem, ...] = ()  # what is wrong with the text of the file

    @property
    def place(self) -> Location:
        """The ``<world>``, or where the world is started if that has no file here."""
        if self.world is not None:
            return Location(self.world.at.span)
        return Location(self.started.span, self.started.frame)

    @property
    def note(self) -> tuple[Related, ...]:
        """For a finding in the file of the world."""
        return (Related(self.started.span, "the world is started here"),) if self.path else ()

    @property
    def title(self) -> str:
        return f"world '{self.name}'"


def opened_worlds(context: Context) -> Iterator[OpenedWorld]:
    """The worlds that a launch file starts and that are at hand, each once."""
    seen: set[tuple[str, str]] = set()
    for started in worlds(context.launch):
        found = _opened(started, context)
        if found and (key := (started.generation, found.path or found.name)) not in seen:
            seen.add(key)
            yield found


def _opened(started: StartedWorld, context: Context) -> OpenedWorld | None:
    if started.is_shipped:
        name, systems = shipped_worlds()[started.name]
        return OpenedWorld(started, "", name, None, systems)
    if not started.name:
        systems = default_systems() if started.generation == GZ else frozenset()
        return OpenedWorld(started, "", "default", None, systems)
    path = world_file(started.name, context)
    if path is None:
        return None
    try:
        world, problems = read_world(path, context.resolver)
    except UnreadableFile:
        return None
    name = world.name if world is not None else os.path.basename(path)
    return OpenedWorld(started, path, name, world, frozenset(), tuple(problems))


def world_file(name: str, context: Context) -> str | None:
    """The file of a world: by its path, or the only one of that name in the workspace."""
    resolver = context.resolver
    if os.path.isabs(name):
        if name.startswith(f"{UNKNOWN}/"):
            return None
        return name if disk.is_file(name) else resolver.installed(name)
    root = resolver.packages.workspace(context.source.path)
    files = resolver.directories.files_below(root, _MAX_DIRECTORIES)
    ending = f"/{os.path.normpath(name)}"
    found = [path for path in files if path.endswith(ending)]
    return found[0] if len(found) == 1 else None
