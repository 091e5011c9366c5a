"""Which descriptions a check is about: those that files and directories stand for."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from urdfkit.core import disk, expansion_limits
from urdfkit.core.record import Record
from urdfkit.errors import UnreadableFile, UrdfkitError
from urdfkit.lint.config import ConfigError, matches
from urdfkit.lint.report import Crashed, Launched, Skipped, crash
from urdfkit.text.file_kinds import is_launch
from urdfkit.text.source import Source, shown
from urdfkit.workspace.resolve import Resolver

if TYPE_CHECKING:
    from urdfkit.lint.entry_points import DirectoryContents
    from urdfkit.lint.options import Options
    from urdfkit.ros.launch.contents import FileUse, LaunchedDescription
    from urdfkit.text.document import CallFrame


#: Sets of arguments of the launch files of a directory with which one robot is checked.
MAX_LAUNCHED = 4
#: The families with rules that compare a robot with the parameter files of its controllers.
_READ_PARAMETERS = ("controllers", "drives", "ros2_control")


class Job(Record):
    """One description to check."""

    path: str  # of the file
    name: str  # of the variant; empty if there is one only
    arguments: dict[str, str]  # for xacro
    found: bool  # True if it was found in a directory, not named
    frame: CallFrame | None = None  # the launch file that loads it, if one does
    parameters: tuple[FileUse, ...] = ()  # the files of parameters that this launch file loads
    #: The arguments that it lacks by itself, and where their values are from.
    launched: tuple[Launched, ...] = ()
    #: Those of them that no launch file starts this robot with, as ``name=value``; else empty.
    assumed: str = ""
    codes: frozenset[str] = frozenset()  # of the rules that are asked; all if empty
    #: The text, if it was read already. That of a robot in a directory is read when its turn comes:
    #: there may be thousands.
    source: Source | None = None

    def text(self, resolver: Resolver) -> Source:
        """The text of the file.

        Raises:
            UnreadableFile: it is gone.
        """
        return self.source or resolver.read(self.path)


def planned(
    files: Iterable[str | os.PathLike[str] | Source], resolver: Resolver, options: Options
) -> Plan:
    """The descriptions to check for what a user names.

    Args:
        files: URDF, xacro or launch files, Sources, or directories.

    Raises:
        ConfigError: a robot has no variant of this name.
    """
    plan = Plan(resolver, options)
    if options.changed:
        plan.add_changed(files)
    else:
        files = list(files)
        for file in files:
            plan.add(file)
        plan.note_without_robot([os.fspath(f) for f in files if not isinstance(f, Source)])
    return plan


class Plan:
    """Which descriptions to check, with which arguments."""

    def __init__(self, resolver: Resolver, options: Options) -> None:
        self.resolver = resolver
        expansion_limits.allow(options.config.limits)
        if options.trust:
            resolver.admit(os.curdir, trust=True)
        self.config = options.config
        self.arguments = dict(options.arguments)
        self.variant = options.variant
        self.jobs: list[Job] = []
        self.skipped: list[Skipped] = []
        self.crashed: list[Crashed] = []
        #: Why nothing of a file, or of a directory with it, is checked, and what to do about it.
        self.unchecked: list[tuple[str, str, str]] = []
        #: The arguments with which the robots of a directory are checked, by path.
        self._launched: dict[str, list[dict[str, str]]] = {}

    def add(self, file: str | os.PathLike[str] | Source) -> None:
        """A file, with its variants if the configuration has some, or a directory."""
        if isinstance(file, Source):
            self.resolver.admit(file.path)
            self._add_source(file)
        elif disk.is_directory(os.fspath(file)):
            from urdfkit.lint.discovery import discover, launch_files

            directory, config = os.fspath(file), self.config
            self.resolver.admit(os.path.join(directory, "x"))
            launches = list(launch_files(directory, config, self.resolver.directories))
            try:
                self._add_found(discover(directory, config, self.resolver), directory)
            except UnreadableFile:
                if not launches:  # of robots that lie elsewhere
                    raise
            except UrdfkitError:
                raise
            except Exception as error:  # a bug in urdfkit must not hide what else was named
                self.crashed.append(crash("", directory, error))
            for path in launches:
                try:
                    self._add_launch(self.resolver.read(_spelt(path, directory)), found=True)
                except UnreadableFile:  # a link that leads outside
                    self._add_closed(path)
        else:
            self._add_source(self.resolver.admit_and_read(os.fspath(file)))

    def add_changed(self, files: Iterable[str | os.PathLike[str] | Source]) -> None:
        """The entry points that some changed files are part of."""
        from urdfkit.lint.discovery import affected

        paths = [file.path if isinstance(file, Source) else os.fspath(file) for file in files]
        for path in paths:
            self.resolver.admit(path)
        self._add_found(affected(paths, self.config, self.resolver), *paths[:1])

    def _add_found(self, found: DirectoryContents, given: str = "") -> None:
        """The entry points of a directory, or of what was given otherwise."""
        robots = [robot for robot in found.robots if self.variant in ("", robot.name)]
        if found.robots and not robots:
            raise ConfigError(f"no robot has a variant '{self.variant}'")
        for robot in robots:
            self._add_robot(_spelt(robot.file, given), robot.name, robot.arguments)
        for library in found.libraries:
            reason = "defines no link, and no file includes it: check a robot that uses it"
            self.skipped.append(Skipped("", library, reason))
        self.skipped += (Skipped("", path, reason) for path, reason in found.others.items())
        for path in found.closed:
            self._add_closed(path)

    def _add_closed(self, path: str) -> None:
        """A file of a directory that is called like a robot and cannot be opened."""
        help = "check the symbolic link and the file permissions"
        self.unchecked.append((path, "robot not checked: the file cannot be opened", help))
        self.skipped.append(Skipped("", path, f"cannot be opened; {help}"))

    def note_without_robot(self, given: Iterable[str]) -> None:
        """Leave a note if directories hold no robot: a report on launch files is no verdict."""
        directories = list(filter(disk.is_directory, given))
        launches = [job.path for job in self.jobs if is_launch(job.path)]
        if not directories or len(launches) < len(self.jobs) or self.unchecked or self.crashed:
            return
        if launches:
            what = f"only {len(launches)} launch file{'s'[len(launches) == 1 :]}"
            help = "check the package of the robot, too, or pass --package NAME=DIRECTORY"
        else:
            what = "".join(f"{shown(one.path)} {one.reason}" for one in self.skipped[:1])
            help = "name a robot to check; urdfkit check --show-files lists the files"
        named = ", ".join(f"'{shown(directory)}'" for directory in directories)
        first = [*launches, *(skip.path for skip in self.skipped), *directories][0]
        self.unchecked.append((first, f"no robot checked in {named}: {what}", help))

    def _add_source(self, source: Source) -> None:
        if is_launch(source.path):
            self._add_launch(source)
            return
        for robot in self.config.entries(source.path, self.arguments, self.variant):
            self.jobs.append(Job(source.path, robot.name, robot.arguments, False, source=source))

    def _add_launch(self, source: Source, *, found: bool = False) -> None:
        """A launch file, and the robots that it describes.

        Args:
            found: it was found in a directory, whose robots are checked anyway. What is left is a
                robot with the arguments that the launch file gives it, and its controllers.
        """
        from urdfkit.lint import rule_index
        from urdfkit.ros.launch import read_launch

        self.jobs.append(Job(source.path, "", self.arguments, False, source=source))
        try:
            launch = read_launch(source, self.resolver, self.arguments)
        except UrdfkitError:
            raise
        except Exception:  # a bug in urdfkit, which the check of the launch file meets and reports
            return
        # Of several robots nobody knows which one the controllers are for.
        parameters = launch.parameters if len({d.path for d in launch.descriptions}) == 1 else ()
        codes = frozenset().union(*map(rule_index.of_family, _READ_PARAMETERS))
        for one in launch.descriptions:
            if found and matches(self.config.relative(one.path), self.config.exclude):
                continue
            is_new = not found or self._is_other(one)
            if not is_new and not parameters:
                continue
            robot = _spelt(one.path, source.path)
            arguments = {**self.config.arguments, **one.arguments}
            job = Job(robot, "", arguments, not one.is_whole, one.frame, parameters)
            self.jobs.append(job if is_new else job._replace(codes=codes))

    def _is_other(self, description: LaunchedDescription) -> bool:
        """True if a robot is not checked yet with these arguments, nor too often with others."""
        real = disk.real(description.path)
        if real not in self._launched:
            self._launched[real] = [] if self._was_passed_over(real) else [{}]
        sets = self._launched[real]
        if description.arguments in sets or len(sets) > MAX_LAUNCHED:
            return False
        sets.append(description.arguments)
        return True

    def _was_passed_over(self, robot: str) -> bool:
        """True if discovery skipped a robot, which now is not: what starts it is known."""
        if self.config.robots:
            return False
        skipped, self.skipped = self.skipped, []
        self.skipped += (one for one in skipped if disk.real(one.path) != robot)
        return len(self.skipped) < len(skipped)

    def _add_robot(self, path: str, name: str, arguments: Mapping[str, str]) -> None:
        every = {**self.config.arguments, **arguments, **self.arguments}
        self.jobs.append(Job(path, name, every, True))


def _spelt(path: str, given: str) -> str:
    """A path as a user would type it who typed another one."""
    return shown(os.path.abspath(path)) if os.path.isabs(given) else os.path.relpath(path)
