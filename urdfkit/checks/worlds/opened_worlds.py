"""The worlds that a launch file starts."""

from __future__ import annotations

import os
from collections.abc import Iterator

from urdfkit.core.record import Record
from urdfkit.errors import UnreadableFile
from urdfkit.lint.rules import Context, Findings, Location, Related
from urdfkit.ros.gazebo.worlds import World, default_systems, has_model, read_world, shipped_worlds
from urdfkit.ros.launch.worlds import GZ, StartedWorld, world_file, worlds
from urdfkit.text.diagnostic import Problem
from urdfkit.text.source import Span


class OpenedWorld(Record):
    """A world that is started, and the contents of its file."""

    started: StartedWorld
    path: str  # of the file; empty for a world that is part of Gazebo, or is made for a model
    name: str  # of the world
    world: World | None  # None if the world is part of Gazebo, or if the file contains no world
    systems: frozenset[str]  # of a world that is part of gz sim
    problems: tuple[Problem, ...] = ()  # errors of the parser

    @property
    def place(self) -> Location | Span:
        """The ``<world>``, or the start of the world if the file is not available."""
        if self.world is not None:
            return self.world.at.span
        return self.started.at

    @property
    def note(self) -> tuple[Related, ...]:
        """The start of the world, for findings in its file."""
        return (Related(self.started.span, "the world is started here"),) if self.path else ()

    def noted(self, findings: Findings) -> Findings:
        """The findings; those that are not in the launch file with this note."""
        for finding in findings:
            is_in_launch_file = finding.span.source is self.started.span.source
            note = () if is_in_launch_file else self.note
            yield finding._replace(related=(*finding.related, *note))

    @property
    def title(self) -> str:
        return f"world '{self.name}'"


def opened_worlds(context: Context) -> Iterator[OpenedWorld]:
    """The available worlds that a launch file starts, without duplicates."""
    keys: set[tuple[str, str]] = set()
    for started in worlds(context.launch):
        opened = _opened(started, context)
        if opened and (key := (started.generation, opened.path or opened.name)) not in keys:
            keys.add(key)
            yield opened


def _opened(started: StartedWorld, context: Context) -> OpenedWorld | None:
    if started.is_shipped:
        name, systems = shipped_worlds()[started.name]
        return OpenedWorld(started, "", name, None, systems)
    if not started.name:
        systems = default_systems() if started.generation == GZ else frozenset()
        return OpenedWorld(started, "", "default", None, systems)
    path = world_file(started.name, context.source.path, context.resolver)
    if path is None:
        return None
    try:
        world, problems = read_world(path, context.resolver)
    except UnreadableFile:
        return None
    if world is None and started.generation == GZ and has_model(path, context.resolver):
        return OpenedWorld(started, "", "default", None, default_systems())
    name = world.name if world is not None else os.path.basename(path)
    return OpenedWorld(started, path, name, world, frozenset(), tuple(problems))
