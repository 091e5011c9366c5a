"""Which descriptions a check is about: those that files and directories stand for."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping

from urdfkit.core import disk, expansion_limits
from urdfkit.core.record import Record
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.errors import UnreadableFile, UrdfkitError
from urdfkit.lint.config import ConfigError, matches
from urdfkit.lint.report import Crashed, Launched, Skipped, crash
from urdfkit.text.file_kinds import is_launch
from urdfkit.text.source import Source, shown
from urdfkit.workspace.resolve import Resolver

if TYPE_CHECKING:
    from urdfkit.lint.entry_points import DirectoryContents
    from urdfkit.lint.options import Options
    from urdfkit.ros.launch.contents import FileUse
    from urdfkit.ros.launch.robot_arguments import RobotArguments
    from urdfkit.text.document import CallFrame


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
    #: The arguments that hold also where a launch file starts it; None if it is checked as it is.
    shared: dict[str, str] | None = None
    #: What the launch files of a checked directory start it with.
    started: tuple[RobotArguments, ...] = ()
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

    def about_parameters(self) -> Job:
        """The job of a robot that is checked otherwise, and whose parameter files are new."""
        from urdfkit.lint import rule_index

        codes = frozenset().union(*map(rule_index.of_family, _READ_PARAMETERS))
        return self._replace(codes=codes)


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
        plan.add_started()
    else:
        files = list(files)
        for file in files:
            plan.add(file)
        plan.add_started()
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
        self._as_launched = options.as_launched
        self.jobs: list[Job] = []
        self.skipped: list[Skipped] = []
        self.crashed: list[Crashed] = []
        #: Why nothing of a file, or of a directory with it, is checked, and what to do about it.
        self.unchecked: list[tuple[str, str, str]] = []
        #: What the launch files of directories start, by real path.
        self._started: dict[str, tuple[str, list[RobotArguments]]] = {}
        self._named: set[str] = set()  # the paths of robots that are checked as these start them

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
        found = affected(paths, self.config, self.resolver)
        self._add_found(found, *paths[:1])
        for path in found.launches:
            self._add_launch(self.resolver.read(_spelt(path, paths[0])), found=True)

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
            job = Job(source.path, robot.name, robot.arguments, False, source=source)
            self.jobs.append(job if self.arguments else self._also_started(job))

    def _add_launch(self, source: Source, *, found: bool = False) -> None:
        """A launch file, and the robots that it describes.

        Args:
            found: it was found in a directory, whose robots are checked anyway.
        """
        from urdfkit.ros.launch import read_launch
        from urdfkit.ros.launch.robot_arguments import started

        self.jobs.append(Job(source.path, "", self.arguments, False, source=source))
        try:
            launch = read_launch(source, self.resolver, self.arguments)
        except UrdfkitError:
            raise
        except Exception:  # a bug in urdfkit, which the check of the launch file meets and reports
            return
        for path, one in started(launch, source.path):
            if not found:
                self.jobs.append(self._as_started(_spelt(path, source.path), one))
            elif not matches(self.config.relative(path), self.config.exclude):
                real = disk.real(path)
                self._started.setdefault(real, (_spelt(path, source.path), []))[1].append(one)

    def _as_started(self, path: str, one: RobotArguments) -> Job:
        """A robot as a launch file starts it."""
        arguments = {**self.config.arguments, **one.arguments}
        return Job(path, "", arguments, not one.is_whole, one.frame, one.parameters)

    def _also_started(self, job: Job) -> Job:
        """A robot that is checked as launch files start it, too; of its variants, the first.

        A variant that the user chose is checked alone.
        """
        if self.variant or job.path in self._named or not self._as_launched:
            return job
        self._named.add(job.path)
        return job._replace(shared={**self.config.arguments, **self.arguments})

    def add_started(self) -> None:
        """Add what the launch files of directories start, once all robots are known."""
        if not self._started:
            return
        for place, job in enumerate(self.jobs):
            _, sets = self._started.pop(disk.real(job.path), ("", []))
            self.jobs[place] = job._replace(started=tuple(sets))
        for real, (path, sets) in self._started.items():
            self.jobs += self._elsewhere(path, sets, passed_over=self._was_passed_over(real))

    def _elsewhere(
        self, path: str, sets: list[RobotArguments], *, passed_over: bool
    ) -> Iterable[Job]:
        """The jobs of a robot that is none of a directory, but that launch files there start.

        Without arguments it is checked in its own directory, unless that was passed over.
        """
        others = [one for one in sets if one.arguments or passed_over]
        if others:
            job = self._as_started(path, others[0])
            return [job._replace(shared=dict(self.config.arguments), started=tuple(sets))]
        with_files = (one for one in sets if one.parameters)
        return [self._as_started(path, one).about_parameters() for one in with_files]

    def _was_passed_over(self, robot: str) -> bool:
        """True if discovery skipped a robot, which now is not: what starts it is known."""
        if self.config.robots:
            return False
        skipped, self.skipped = self.skipped, []
        self.skipped += (one for one in skipped if disk.real(one.path) != robot)
        return len(self.skipped) < len(skipped)

    def _add_robot(self, path: str, name: str, arguments: Mapping[str, str]) -> None:
        every = {**self.config.arguments, **arguments, **self.arguments}
        self.jobs.append(self._also_started(Job(path, name, every, True)))


def _spelt(path: str, given: str) -> str:
    """A path as a user would type it who typed another one."""
    return shown(os.path.abspath(path)) if os.path.isabs(given) else os.path.relpath(path)
