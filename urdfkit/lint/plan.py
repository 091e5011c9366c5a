"""Which descriptions a check is about: those that files and folders stand for."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from urdfkit.core import disk
from urdfkit.core.record import Record
from urdfkit.core.suggest import nearest
from urdfkit.errors import UnreadableFile, UrdfkitError
from urdfkit.lint.config import ConfigError
from urdfkit.lint.report import Crashed, Launched, Skipped, crash
from urdfkit.text.file_kinds import is_launch
from urdfkit.text.source import Source, shown
from urdfkit.workspace.resolve import Resolver

if TYPE_CHECKING:
    from collections.abc import Callable

    from urdfkit.lint.context import Subject
    from urdfkit.lint.discovery import FolderContents
    from urdfkit.lint.options import Options
    from urdfkit.ros.launch.contents import FileUse, LaunchedDescription
    from urdfkit.text.document import CallFrame


#: Sets of arguments of the launch files of a folder with which one robot is checked.
MAX_LAUNCHED = 4
#: Sets of values with which a robot is checked that lacks arguments; the UR arms have nine.
MAX_GIVEN = 16
#: The families with rules that compare a robot with the parameter files of its controllers.
_READ_PARAMETERS = ("controllers", "drives", "ros2_control")


class Job(Record):
    """One description to check.

    Attributes:
        path: of the file.
        name: of the variant; empty if there is one only.
        arguments: for xacro.
        found: True if it was found in a folder, not named.
        frame: the launch file that loads it, if one does.
        parameters: the files of parameters that this launch file loads.
        launched: the arguments that it lacks by itself, and where their values are from.
        codes: of the rules that are asked; all if empty.
        source: the text, if it was read already. That of a robot in a folder is read when its turn
            comes: there may be thousands.
    """

    path: str
    name: str
    arguments: dict[str, str]
    found: bool
    frame: CallFrame | None = None
    parameters: tuple[FileUse, ...] = ()
    launched: tuple[Launched, ...] = ()
    codes: frozenset[str] = frozenset()
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
        files: URDF, xacro or launch files, Sources, or folders.
        resolver: finds files, and reads them.
        options: of the check.

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
        if options.trust:
            resolver.admit(os.curdir, trust=True)
        self.config = options.config
        self.arguments = dict(options.arguments)
        self.variant = options.variant
        self.jobs: list[Job] = []
        self.skipped: list[Skipped] = []
        self.crashed: list[Crashed] = []
        #: Why nothing of a file, or of a folder with it, is checked, and what to do about it.
        self.unchecked: list[tuple[str, str, str]] = []
        #: The arguments with which the robots of a folder are checked, by path.
        self._launched: dict[str, list[dict[str, str]]] = {}

    def add(self, file: str | os.PathLike[str] | Source) -> None:
        """A file, with its variants if the configuration has some, or a folder."""
        if isinstance(file, Source):
            self.resolver.admit(file.path)
            self._add_source(file)
        elif disk.is_folder(os.fspath(file)):
            from urdfkit.lint.discovery import discover, launch_files

            folder, config = os.fspath(file), self.config
            self.resolver.admit(os.path.join(folder, "x"))
            launches = list(launch_files(folder, config, self.resolver.folders))
            try:
                self._add_found(discover(folder, config, self.resolver), folder)
            except UnreadableFile:
                if not launches:  # of robots that lie elsewhere
                    raise
            except UrdfkitError:
                raise
            except Exception as error:  # a bug in urdfkit must not hide what else was named
                self.crashed.append(crash("", folder, error))
            for path in launches:
                try:
                    self._add_launch(self.resolver.read(_spelt(path, folder)), found=True)
                except UnreadableFile:  # a link that leads outside
                    self._add_closed(path)
        else:
            self._add_source(self.resolver.given(os.fspath(file)))

    def add_changed(self, files: Iterable[str | os.PathLike[str] | Source]) -> None:
        """The entry points that some changed files are part of."""
        from urdfkit.lint.discovery import affected

        paths = [file.path if isinstance(file, Source) else os.fspath(file) for file in files]
        for path in paths:
            self.resolver.admit(path)
        self._add_found(affected(paths, self.config, self.resolver), *paths[:1])

    def _add_found(self, found: FolderContents, given: str = "") -> None:
        """The entry points of a folder, or of what was given otherwise."""
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
        folders = list(filter(disk.is_folder, given))
        launches = [job.path for job in self.jobs if is_launch(job.path)]
        if not folders or len(launches) < len(self.jobs) or self.unchecked or self.crashed:
            return
        if launches:
            what = f"only {len(launches)} launch file{'s'[len(launches) == 1 :]}"
            help = "check the package of the robot, too, or pass --package NAME=DIRECTORY"
        else:
            what = "only macros and parts of robots"
            help = "check a robot that uses them; urdfkit check --show-files lists the files"
        named = ", ".join(f"'{shown(folder)}'" for folder in folders)
        first = [*launches, *(skip.path for skip in self.skipped), *folders][0]
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
            source: of the launch file.
            found: it was found in a folder, whose robots are checked anyway. What is left is a
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
            is_new = not found or self._is_other(one)
            if not is_new and not parameters:
                continue
            robot = _spelt(one.path, source.path)
            arguments = {**self.config.arguments, **one.arguments}
            job = Job(robot, "", arguments, not one.is_whole, one.frame, parameters)
            self.jobs.append(job if is_new else job._replace(codes=codes))

    def _is_other(self, description: LaunchedDescription) -> bool:
        """True if a robot is not checked yet with these arguments, nor too often with others."""
        sets = self._launched.setdefault(disk.real(description.path), [{}])
        if description.arguments in sets or len(sets) > MAX_LAUNCHED:
            return False
        sets.append(description.arguments)
        return True

    def _add_robot(self, path: str, name: str, arguments: Mapping[str, str]) -> None:
        """A robot that was found."""
        every = {**self.config.arguments, **arguments, **self.arguments}
        self.jobs.append(Job(path, name, every, True))


def as_launched(job: Job, read: Callable[[Job], Subject]) -> list[tuple[Job, Subject]]:
    """A job with its description.

    A robot that cannot be expanded for want of arguments, or that uses them above their default,
    comes with those that launch files give it: once for each set of them. Where none gives them
    all, one that cannot be expanded comes with the values that are found otherwise and with which
    it expands.

    Args:
        job: one description.
        read: makes the description of a job.
    """
    subject = read(job)
    if is_launch(job.path) or not (names := subject.arguments_to_pass):
        return [(job, subject)]
    from urdfkit.ros.launch.robot_arguments import given

    found, failed = [], {}
    sets = given(job.path, names, subject.resolver)
    for one in sets[:MAX_GIVEN]:
        values = {name: (one.arguments[name], one.launch) for name in names}
        arguments = {**one.arguments, **job.arguments}
        now = job._replace(frame=one.frame, launched=_launched(job, values), arguments=arguments)
        pair = (now, read(now))
        if pair[1].missing_arguments:
            failed[tuple(one.arguments[name] for name in names)] = pair[1]
        else:
            found.append(pair)
    if found:
        offered = [{name: one.arguments[name] for name in names} for one in sets]
        _note_unchecked(found, offered, failed)
        return found
    if not subject.missing_arguments:
        return [(job, subject)]
    return _as_found(job, read, subject, names) or [(job, subject)]


def _as_found(
    job: Job, read: Callable[[Job], Subject], subject: Subject, names: tuple[str, ...]
) -> list[tuple[Job, Subject]]:
    """A job with values that nobody starts it with; empty if it expands with none of them."""
    from urdfkit.lint.argument_values import combinations

    xacro = subject.reading.xacro
    assert xacro is not None, "only a xacro lacks arguments"
    found: list[tuple[Job, Subject]] = []
    failed: dict[tuple[str, ...], Subject] = {}
    more: tuple[str, ...] = ()
    sets = list(combinations(names, xacro, subject.resolver))
    offered = [{name: value for name, (value, _) in values.items()} for values in sets]
    for values, given in list(zip(sets, offered, strict=True))[:MAX_GIVEN]:
        now = job._replace(arguments={**given, **job.arguments}, launched=_launched(job, values))
        pair = (now, read(now))
        if pair[1].reading.document is not None:
            found.append(pair)
        else:
            failed[tuple(given.values())] = pair[1]
        more += pair[1].missing_arguments
    if found:
        _note_unchecked(found, offered, failed)
    if found or set(more) <= set(names):
        return found
    return _as_found(job, read, subject, tuple(dict.fromkeys((*names, *more))))


def _note_unchecked(
    found: list[tuple[Job, Subject]],
    offered: list[dict[str, str]],
    failed: Mapping[tuple[str, ...], Subject],
) -> None:
    """Leave with the first description which values of its arguments none is checked with.

    Args:
        found: the descriptions that are checked.
        offered: sets of values that files give.
        failed: descriptions that do not expand, by their values in the order of the names.
    """
    from urdfkit.lint.context import UncheckedValues
    from urdfkit.lint.unchecked import why_unchecked

    left: dict[tuple[str, str], list[str]] = {}
    for values in offered:
        subject = failed.get(tuple(values.values()))
        why = f"only {MAX_GIVEN} sets of arguments are tried"
        if subject is not None:
            why, _ = why_unchecked(subject.reading, subject.source, subject.resolver)
        for name, value in values.items():
            known = left.setdefault((name, why), [])
            if all(job.arguments.get(name) != value for job, _ in found) and value not in known:
                known.append(value)
    found[0][1].unchecked = tuple(
        UncheckedValues(name, tuple(values), len({one[name] for one in offered}), why)
        for (name, why), values in left.items()
        if values
    )


def _launched(job: Job, values: Mapping[str, tuple[str, str]]) -> tuple[Launched, ...]:
    """The values of arguments with where they are from, each place once."""
    origins: dict[str, dict[str, str]] = {}
    for name, (value, origin) in values.items():
        origins.setdefault(origin, {})[name] = value
    return tuple(Launched(job.path, *one) for one in origins.items())


def unknown_arguments(subject: Subject, given: Iterable[str]) -> dict[str, str]:
    """The given arguments that a description never mentions, each with the suggested one.

    xacro takes any, so that a typo has no effect and is not reported. A launch file may pass them
    on, and of what cannot be read not all is known: neither has any.
    """
    names = () if is_launch(subject.source.path) else tuple(given)
    if not names or subject.reading.document is None:
        return {}
    xacro = subject.reading.xacro
    declared = {argument.name for argument in xacro.arguments} if xacro else set()
    mentioned = declared | (xacro.usage.names if xacro else frozenset())
    return {name: nearest(name, declared) or "" for name in names if name not in mentioned}


def _spelt(path: str, given: str) -> str:
    """A path as a user would type it who typed another one."""
    return shown(os.path.abspath(path)) if os.path.isabs(given) else os.path.relpath(path)
