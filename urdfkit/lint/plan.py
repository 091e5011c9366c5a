"""The descriptions to check for the files and directories that a user passes."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping

from urdfkit.core import disk, expansion_limits
from urdfkit.core.record import Record
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.core.words import counted, listed
from urdfkit.errors import UnreadableFile, UrdfkitError
from urdfkit.lint.config import ConfigError, matches
from urdfkit.lint.report import Crashed, Launched, Skipped, crash
from urdfkit.text.file_kinds import is_launch, is_parameter_file
from urdfkit.text.source import Source, shown
from urdfkit.workspace.file_head import MAX_BYTES
from urdfkit.workspace.resolve import Resolver

if TYPE_CHECKING:
    from urdfkit.lint.entry_points import DirectoryContents
    from urdfkit.lint.options import Options
    from urdfkit.ros.launch.contents import FileUse
    from urdfkit.ros.launch.robot_arguments import RobotArguments
    from urdfkit.text.document import CallFrame


#: Families of rules that compare a robot with the parameter files of its controllers, and the one
#: whose findings explain some of theirs.
_READ_PARAMETERS = ("controllers", "drives", "ros2_control", "xacro")


class Job(Record):
    """One description to check."""

    path: str  # path of the file
    name: str  # name of the variant; empty if there is only one
    arguments: dict[str, str]  # xacro arguments
    #: True if it need not expand: it was found in a directory, or a launch file passes values that
    #: are known only at run time.
    may_fail: bool
    frame: CallFrame | None = None  # the launch file that loads it; None if there is none
    parameters: tuple[FileUse, ...] = ()  # the parameter files that this launch file loads
    #: Arguments that override those of launch files; None if it is not checked with those.
    overriding: dict[str, str] | None = None
    #: The arguments from the launch files of a checked directory.
    launch_sets: tuple[RobotArguments, ...] = ()
    #: The arguments without a default, with the origin of their values.
    launched: tuple[Launched, ...] = ()
    #: Argument values that no launch file passes to this robot, as ``name=value``; may be empty.
    assumed: str = ""
    #: An argument with a value that nobody passes, as ``name=value``; may be empty.
    switched: str = ""
    #: The places of the tags that the robot also has without it, in order, by path.
    present: Mapping[str, list[tuple[int, int]]] = {}
    #: True if another such value or a package that is not found adds links or joints, which may
    #: have to come with this one.
    needs_others: bool = False
    #: Arguments whose default is checked although no launch file starts the robot with it.
    replaced: frozenset[str] = frozenset()
    #: Arguments whose value the launch file knows only at run time; "" stands for any name.
    unknown: tuple[str, ...] = ()
    codes: frozenset[str] = frozenset()  # codes of the rules to run; all if empty
    #: The text, if it was already read. A robot in a directory is read when it is checked: there
    #: may be thousands.
    source: Source | None = None

    def text(self, resolver: Resolver) -> Source:
        """The text of the file.

        Raises:
            UnreadableFile: the file no longer exists.
        """
        return self.source or resolver.read(self.path)

    def about_parameters(self) -> Job:
        """The job with only the rules about parameter files, for a robot with another job."""
        from urdfkit.lint import rule_index

        codes = frozenset().union(*map(rule_index.of_family, _READ_PARAMETERS))
        return self._replace(codes=codes)


def planned(
    files: Iterable[str | os.PathLike[str] | Source], resolver: Resolver, options: Options
) -> Plan:
    """The descriptions to check for the files that a user passes.

    Args:
        files: URDF, xacro or launch files, Sources, or directories.

    Raises:
        ConfigError: a robot has no variant of this name.
    """
    plan = Plan(resolver, options)
    if options.changed:
        plan.add_changed(files)
        plan.add_launch_sets()
    else:
        files = list(files)
        for file in files:
            plan.add(file)
        plan.add_launch_sets()
        plan.note_without_robot([os.fspath(f) for f in files if not isinstance(f, Source)])
    return plan


class Plan:
    """The descriptions to check, with their arguments."""

    def __init__(self, resolver: Resolver, options: Options) -> None:
        self.resolver = resolver
        expansion_limits.allow(options.config.limits)
        if options.trust:
            resolver.admit(os.curdir, trust=True)
        self.config = options.config
        self.arguments = dict(options.arguments)
        self.variant = options.variant
        self._as_launched = options.as_launched
        self._selected = options.select
        self.jobs: list[Job] = []
        self.skipped: list[Skipped] = []
        self.crashed: list[Crashed] = []
        self.srdfs: list[str] = []  # the SRDFs below checked directories
        #: Files that are not checked: path, message and help.
        self.unchecked: list[tuple[str, str, str]] = []
        #: Displayed path and arguments of the robots that launch files of directories start, by
        #: real path.
        self._launch_sets: dict[str, tuple[str, list[RobotArguments]]] = {}
        #: Paths of the robots that are also checked with the arguments of launch files.
        self._with_launch_files: set[str] = set()
        self._loaded: set[str] = set()  # real paths of the parameter files of launch files
        self._parameter_files = 0  # number of the others

    def add(self, file: str | os.PathLike[str] | Source) -> None:
        """Add a file with its variants in the configuration, or a directory."""
        if isinstance(file, Source):
            self.resolver.admit(file.path)
            self._add_source(file)
        elif disk.is_directory(os.fspath(file)):
            from urdfkit.lint.discovery import discover, launch_files, srdf_files_below

            directory, config = os.fspath(file), self.config
            self.resolver.admit(os.path.join(directory, "x"))
            launches = list(launch_files(directory, config, self.resolver.directories))
            without_robot: UnreadableFile | None = None
            try:
                self._add_contents(discover(directory, config, self.resolver), directory)
            except UnreadableFile as error:
                without_robot = error
            except UrdfkitError:
                raise
            except Exception as error:  # a bug in urdfkit must not prevent the other checks
                self.crashed.append(crash("", directory, error))
            if not self._selected or any(code.startswith("SRD") for code in self._selected):
                self.srdfs += srdf_files_below(directory, config, self.resolver)
            for path in launches:
                try:
                    source = self.resolver.read(_relative_as(path, directory))
                    self._add_launch(source, in_directory=True)
                except UnreadableFile:  # a link to a file outside of the directory
                    self._add_closed(path)
            files = self.resolver.directories.walk(directory)
            has_parameters = self._add_parameter_files(files, directory)
            # Launch files may start robots of other directories.
            if without_robot and not (launches or has_parameters):
                raise without_robot
        else:
            self._add_source(self.resolver.admit_and_read(os.fspath(file)))

    def _add_parameter_files(self, files: Iterable[str], start: str) -> bool:
        """Add those among some files that are parameter files which no launch file loads.

        Returns:
            True if there are any.
        """
        from urdfkit.lint.parameter_files import unloaded_parameter_files

        before = len(self.jobs)
        for path in unloaded_parameter_files(files, self._loaded, self.config, self.resolver):
            self._add_source(self.resolver.read(_relative_as(path, start)))
        return len(self.jobs) > before

    def add_changed(self, files: Iterable[str | os.PathLike[str] | Source]) -> None:
        """Add the entry points that use changed files."""
        from urdfkit.lint.discovery import affected

        paths = [file.path if isinstance(file, Source) else os.fspath(file) for file in files]
        for path in paths:
            self.resolver.admit(path)
        contents = affected(paths, self.config, self.resolver)
        self._add_contents(contents, *paths[:1])
        for path in contents.launches:
            self._add_launch(self.resolver.read(_relative_as(path, paths[0])), in_directory=True)
        self._add_parameter_files(map(os.path.abspath, paths), *paths[:1])

    def _add_contents(self, contents: DirectoryContents, start: str = "") -> None:
        """Add the entry points of a directory, or of changed files.

        Args:
            start: the directory or file as the user named it.
        """
        robots = [robot for robot in contents.robots if self.variant in ("", robot.name)]
        if contents.robots and not robots:
            raise ConfigError(f"no robot has a variant '{self.variant}'")
        for robot in robots:
            self._add_robot(_relative_as(robot.file, start), robot.name, robot.arguments)
        for library in contents.libraries:
            reason = "defines no link, and no file includes it: check a robot that uses it"
            self.skipped.append(Skipped("", library, reason))
        self.skipped += (Skipped("", path, reason) for path, reason in contents.others.items())
        for path in contents.closed:
            self._add_closed(path)

    def _add_closed(self, path: str) -> None:
        """Add a file of a directory that has a robot's suffix but cannot be opened."""
        help = "check the symbolic link and the file permissions"
        self.unchecked.append((path, "robot not checked: the file cannot be opened", help))
        self.skipped.append(Skipped("", path, f"cannot be opened; {help}"))

    def note_without_robot(self, files: Iterable[str]) -> None:
        """Add a finding if directories contain no robot, even if launch files are checked."""
        directories = list(filter(disk.is_directory, files))
        launches = [job.path for job in self.jobs if is_launch(job.path)]
        others = [job.path for job in self.jobs if not is_launch(job.path)]
        has_robot = len(others) > self._parameter_files
        if not directories or has_robot or self.unchecked or self.crashed:
            return
        if self.jobs:
            kinds = {"launch file": len(launches), "parameter file": len(others)}
            contents = f"only {listed([counted(n, kind) for kind, n in kinds.items() if n])}"
            help = "check the package of the robot, too, or pass --package NAME=DIRECTORY"
        else:
            contents = "".join(f"{shown(skip.path)} {skip.reason}" for skip in self.skipped[:1])
            help = "name a robot to check; urdfkit check --show-files lists the files"
        named = ", ".join(f"'{shown(directory)}'" for directory in directories)
        first = [*launches, *others, *(skip.path for skip in self.skipped), *directories][0]
        self.unchecked.append((first, f"no robot checked in {named}: {contents}", help))

    def _add_source(self, source: Source) -> None:
        if is_launch(source.path):
            self._add_launch(source)
            return
        if is_parameter_file(source):
            if len(source.data) > MAX_BYTES:
                message = f"parameter file not checked: it is larger than {MAX_BYTES:,} bytes"
                self.unchecked.append((source.path, message, "divide it"))
                return
            self._parameter_files += 1
            self.jobs.append(Job(source.path, "", {}, False, source=source))
            return
        for robot in self.config.entries(source.path, self.arguments, self.variant):
            job = Job(source.path, robot.name, robot.arguments, False, source=source)
            self.jobs.append(job if self.arguments else self._also_as_launched(job))

    def _add_launch(self, source: Source, *, in_directory: bool = False) -> None:
        """Add a launch file, and the robots that it describes.

        Args:
            in_directory: True if it was found in a directory, whose robots are checked anyway.
        """
        from urdfkit.ros.launch import read_launch
        from urdfkit.ros.launch.robot_arguments import started_robots

        self.jobs.append(Job(source.path, "", self.arguments, False, source=source))
        try:
            launch = read_launch(source, self.resolver, self.arguments)
        except UrdfkitError:
            raise
        except Exception:  # a bug in urdfkit, which the check of the launch file reports
            return
        self._loaded.update(disk.real(file.path) for file in launch.parameters)
        for path, robot in started_robots(launch, source.path):
            if not in_directory:
                self.jobs.append(self._started_by_launch(_relative_as(path, source.path), robot))
            elif not matches(self.config.relative(path), self.config.exclude):
                real = disk.real(path)
                self._launch_sets.setdefault(real, (_relative_as(path, source.path), []))[1].append(
                    robot
                )

    def _started_by_launch(self, path: str, robot: RobotArguments) -> Job:
        """The job of a robot with the arguments of a launch file."""
        arguments = {**self.config.arguments, **robot.arguments}
        job = Job(path, "", arguments, not robot.is_whole, robot.frame, robot.parameters)
        return job._replace(unknown=robot.unknown)

    def _also_as_launched(self, job: Job) -> Job:
        """The job, also with the arguments of launch files; only for the first of its variants.

        A variant that the user selected is checked alone.
        """
        if self.variant or job.path in self._with_launch_files or not self._as_launched:
            return job
        self._with_launch_files.add(job.path)
        return job._replace(overriding={**self.config.arguments, **self.arguments})

    def add_launch_sets(self) -> None:
        """Add the arguments of launch files in directories, after all robots were added."""
        if not self._launch_sets:
            return
        for index, job in enumerate(self.jobs):
            _, sets = self._launch_sets.pop(disk.real(job.path), ("", []))
            self.jobs[index] = job._replace(launch_sets=tuple(sets))
        for real, (path, sets) in self._launch_sets.items():
            self.jobs += self._elsewhere(path, sets, was_skipped=self._was_skipped(real))

    def _elsewhere(
        self, path: str, sets: list[RobotArguments], *, was_skipped: bool
    ) -> Iterable[Job]:
        """The jobs of a robot outside of the checked directories that launch files there start.

        A robot without arguments is checked with its own directory, unless discovery skipped it.
        """
        distinct = [robot for robot in sets if robot.arguments or was_skipped]
        if distinct:
            job = self._started_by_launch(path, distinct[0])
            return [job._replace(overriding=dict(self.config.arguments), launch_sets=tuple(sets))]
        with_files = (robot for robot in sets if robot.parameters)
        return [self._started_by_launch(path, robot).about_parameters() for robot in with_files]

    def _was_skipped(self, robot: str) -> bool:
        """Remove a robot with a launch file from the skipped files; True if it was one of them."""
        if self.config.robots:
            return False
        skipped, self.skipped = self.skipped, []
        self.skipped += (skip for skip in skipped if disk.real(skip.path) != robot)
        return len(self.skipped) < len(skipped)

    def _add_robot(self, path: str, name: str, arguments: Mapping[str, str]) -> None:
        merged = {**self.config.arguments, **arguments, **self.arguments}
        self.jobs.append(self._also_as_launched(Job(path, name, merged, True)))


def _relative_as(path: str, other: str) -> str:
    """A path that is absolute or relative as another one, which the user named."""
    return shown(os.path.abspath(path)) if os.path.isabs(other) else os.path.relpath(path)
