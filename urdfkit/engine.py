"""check(): descriptions of robots make a Report."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping

from urdfkit import rules as catalogue
from urdfkit.diagnostic import Diagnostic, Report, Severity, Skipped
from urdfkit.judge import Verdict, judge
from urdfkit.reading import is_launch
from urdfkit.record import Record
from urdfkit.source import Source
from urdfkit.static import TYPE_CHECKING
from urdfkit.subject import Subject
from urdfkit.workspace.resolve import Resolver

if TYPE_CHECKING:
    from typing import TypedDict

    from urdfkit.config import Config
    from urdfkit.discovery import Found
    from urdfkit.document import Frame
    from urdfkit.launch import FileUse
    from urdfkit.reading import Problem
    from urdfkit.targets import Targets

    class Options(TypedDict, total=False):
        """What ``check`` takes besides files, for functions that check as a part of their work."""

        arguments: Mapping[str, str] | None
        packages: Mapping[str, str] | None
        select: Iterable[str]
        ignore: Iterable[str]
        targets: Iterable[str]
        trust: bool
        rules: Iterable[str]
        config: Config | None
        changed: bool
        jobs: int
        progress: Callable[[int, int], None] | None
        texts: Mapping[str, bytes] | None
        cache: bool


class Job(Record):
    """One description to check.

    Attributes:
        source: the file.
        name: of the variant; empty if there is one only.
        arguments: for xacro.
        found: True if it was found in a folder, not named.
        frame: the launch file that asks for it, if one does.
        parameters: the files of parameters that this launch file loads.
    """

    source: Source
    name: str
    arguments: dict[str, str]
    found: bool
    frame: Frame | None = None
    parameters: tuple[FileUse, ...] = ()


class Settings(Record):
    """What is the same for every job; goes to other processes too."""

    chosen: tuple[str, ...]
    packages: dict[str, str]
    targets: Targets | None
    trust: bool
    config: Config | None
    foreign: dict[str, str]
    texts: dict[str, bytes]
    cache: bool


def check(
    *files: str | os.PathLike[str] | Source,
    arguments: Mapping[str, str] | None = None,
    packages: Mapping[str, str] | None = None,
    select: Iterable[str] = (),
    ignore: Iterable[str] = (),
    targets: Iterable[str] = (),
    trust: bool = False,
    rules: Iterable[str] = (),
    config: Config | None = None,
    changed: bool = False,
    jobs: int = 1,
    progress: Callable[[int, int], None] | None = None,
    texts: Mapping[str, bytes] | None = None,
    cache: bool = True,
    resolver: Resolver | None = None,
) -> Report:
    """Check descriptions of robots.

    >>> report = check("models/good/gripper.urdf")
    >>> report.ok, len(report.crashed), report.exit_code()
    (True, 0, 0)
    >>> text = b'<robot name="r"><link name="a"/><link name="a"/></robot>'
    >>> report = check(Source("r.urdf", text), select=["NAM"])
    >>> [(found.code, found.span.column) for found in report.diagnostics]
    [('NAM001', 45)]

    Args:
        files: URDF, xacro or launch files, Sources, or folders, whose entry points are checked.
        arguments: xacro arguments, as ``name:=value`` gives them on the command line.
        packages: folders of ROS packages by name; they win over every search.
        select: codes, beginnings of codes or names; only these rules run. All if empty.
        ignore: codes, beginnings of codes or names of rules that do not run.
        targets: names of consumers to check for; inferred from each model if empty.
        trust: let expressions of the model run unfenced and read any file.
        rules: packages of rules that run, too: names under which they are installed (entry
            points of the group ``urdfkit.rules``), or of modules, which are imported.
        config: settings of the project; the other arguments go before them.
        changed: the files are changed files of any kind; the robots that they are part of are
            checked, each once.
        jobs: processes that check at the same time.
        progress: called with the number of descriptions done and of all; of a single one, with
            those of its mesh files.
        texts: files whose bytes are not those on disk, by path, such as an editor's buffers.
        cache: keep what is measured of mesh files for the next run.
        resolver: what an earlier check with these packages has found of packages and folders;
            for many checks in a row, while nothing changes on disk.

    Raises:
        UnreadableFile: a file is missing or may not be read.
        UnknownRule: a word of ``select`` or ``ignore`` means no rule.
        UnknownTarget: a name is no target.
        RuleError: a package of rules is missing or cannot be used.
    """
    foreign = (*(config.rules if config else ()), *_added(rules))
    settings = Settings(
        tuple(choose(select, ignore, config, foreign)),
        {**(config.packages if config else {}), **(packages or {})},
        _given(targets, config),
        trust or (config is not None and config.trust),
        config,
        catalogue.foreign(),
        dict(texts or {}),
        cache,
    )
    if resolver is None:
        resolver = Resolver(settings.packages, texts=settings.texts)
    else:
        resolver = resolver.with_texts(settings.texts)
    plan = _planned(files, resolver, config, arguments, changed=changed)
    verdicts = _verdicts(plan.jobs, settings, resolver, jobs, progress)
    return _report(plan, verdicts)


def subjects(
    *files: str | os.PathLike[str] | Source,
    arguments: Mapping[str, str] | None = None,
    packages: Mapping[str, str] | None = None,
    trust: bool = False,
    config: Config | None = None,
    changed: bool = False,
    texts: Mapping[str, bytes] | None = None,
) -> Iterator[Subject | None]:
    """The descriptions that ``check`` checks with the same arguments, in the same order.

    None stands for a launch file, and for what cannot be read.
    """
    known = {**(config.packages if config else {}), **(packages or {})}
    resolver = Resolver(known, texts=texts)
    is_trusted = trust or (config is not None and config.trust)
    for job in _planned(files, resolver, config, arguments, changed=changed).jobs:
        subject = Subject(job.source, resolver, job.arguments, trust=is_trusted, frame=job.frame)
        is_robot = not is_launch(job.source.path) and subject.reading.document is not None
        yield subject if is_robot else None


def _planned(
    files: Iterable[str | os.PathLike[str] | Source],
    resolver: Resolver,
    config: Config | None,
    arguments: Mapping[str, str] | None,
    *,
    changed: bool,
) -> _Plan:
    plan = _Plan(resolver, config, arguments or {})
    if changed:
        plan.add_changed(files)
    for file in () if changed else files:
        plan.add(file)
    return plan


def _added(packages: Iterable[str]) -> list[str]:
    """The codes of packages of rules."""
    names = tuple(packages)
    if not names:
        return []
    from urdfkit.rule_packages import add

    return add(names, modules=True)


def _given(names: Iterable[str], config: Config | None) -> Targets | None:
    """The targets that were asked for; None if none were."""
    names = tuple(names) or (config.targets if config else ())
    if not names:
        return None
    from urdfkit.targets import parse

    return parse(names)


def choose(
    select: Iterable[str],
    ignore: Iterable[str],
    config: Config | None = None,
    foreign: Iterable[str] = (),
) -> list[str]:
    """The codes that one of ``select`` means and none of ``ignore``.

    Args:
        select: codes, beginnings of codes or names; all of urdfkit's and ``foreign`` if empty.
        ignore: likewise.
        config: what the project selects and ignores.
        foreign: codes of the rules of other packages.

    Raises:
        UnknownRule: one of the words means no rule. To pass over a slip would check with
            other rules than were asked for, and say nothing.
    """
    selected = {code for word in select for code in catalogue.matching(word)}
    ignored = {code for word in ignore for code in catalogue.matching(word)}
    if config is not None:
        # What is selected by hand runs, whatever the configuration leaves out.
        ignored |= config.ignore - selected
        selected = selected or set(config.select)
    chosen = selected or {*catalogue.codes(), *foreign}
    return sorted(chosen - ignored)


class _Plan:
    """Which descriptions to check, with which arguments."""

    def __init__(
        self, resolver: Resolver, config: Config | None, arguments: Mapping[str, str]
    ) -> None:
        self.resolver = resolver
        self.config = config
        self.arguments = dict(arguments)
        self.jobs: list[Job] = []
        self.skipped: list[Skipped] = []

    def add(self, file: str | os.PathLike[str] | Source) -> None:
        """A file, with its variants if the configuration has some, or a folder."""
        if isinstance(file, Source):
            self._add_source(file)
        elif os.path.isdir(file):
            from urdfkit.config import Config
            from urdfkit.discovery import discover

            self.add_found(discover(os.fspath(file), self.config or Config(), self.resolver))
        else:
            self._add_file(os.fspath(file))

    def add_changed(self, files: Iterable[str | os.PathLike[str] | Source]) -> None:
        """The entry points that some changed files are part of."""
        from urdfkit.config import Config
        from urdfkit.discovery import affected

        paths = [file.path if isinstance(file, Source) else os.fspath(file) for file in files]
        self.add_found(affected(paths, self.config or Config(), self.resolver))

    def add_found(self, found: Found) -> None:
        """The entry points of a folder."""
        for robot in found.robots:
            source = self.resolver.read(_shown(robot.file))
            self._add(source, robot.name, robot.arguments, found=True)
        for library in found.libraries:
            reason = "makes no link itself, and no file includes it: check a robot that uses it"
            self.skipped.append(Skipped("", library, reason))

    def _add_source(self, source: Source) -> None:
        if is_launch(source.path):
            self._add_launch(source)
        else:
            self._add(source, "", {}, found=False)

    def _add_file(self, path: str) -> None:
        source = self.resolver.read(path)
        robots = self.config.robots if self.config else ()
        real = os.path.abspath(path)
        variants = [robot for robot in robots if robot.file == real]
        if not variants or self.arguments:
            self._add_source(source)
        for robot in variants if not self.arguments else ():
            self._add(source, robot.name, robot.arguments, found=False)

    def _add_launch(self, source: Source) -> None:
        """A launch file, and the robots that it describes."""
        from urdfkit.launch import read_launch

        self.jobs.append(Job(source, "", self.arguments, False))
        launch = read_launch(source, self.resolver, self.arguments)
        for description in launch.descriptions:
            robot = self.resolver.read(_shown(description.path))
            common = self.config.arguments if self.config else {}
            arguments = {**common, **description.arguments}
            job = Job(robot, "", arguments, False, description.frame, launch.parameters)
            self.jobs.append(job)

    def _add(self, source: Source, name: str, arguments: Mapping[str, str], *, found: bool) -> None:
        common = self.config.arguments if self.config else {}
        every = {**common, **arguments, **self.arguments}
        self.jobs.append(Job(source, name, every, found))


def _shown(path: str) -> str:
    """A path as a user would type it."""
    return os.path.relpath(path)


def _verdicts(
    jobs: list[Job],
    settings: Settings,
    resolver: Resolver,
    processes: int,
    progress: Callable[[int, int], None] | None,
) -> list[Verdict]:
    if len(jobs) == 1:
        return [_run(jobs[0], settings, resolver, progress)]
    verdicts: list[Verdict] = []
    for verdict in _each(jobs, settings, resolver, processes):
        verdicts.append(verdict)
        if progress is not None:
            progress(len(verdicts), len(jobs))
    return verdicts


def _each(
    jobs: list[Job], settings: Settings, resolver: Resolver, processes: int
) -> Iterable[Verdict]:
    if processes <= 1:
        return (_run(job, settings, resolver) for job in jobs)
    return _in_processes(jobs, settings, processes)


def _in_processes(jobs: list[Job], settings: Settings, processes: int) -> Iterable[Verdict]:
    from concurrent.futures import ProcessPoolExecutor

    with ProcessPoolExecutor(min(processes, len(jobs))) as pool:
        yield from pool.map(_run_alone, jobs, [settings] * len(jobs), chunksize=4)


def _run_alone(job: Job, settings: Settings) -> Verdict:
    catalogue.register(settings.foreign)  # this process may have begun with nothing
    return _run(job, settings, Resolver(settings.packages, texts=settings.texts))


def _run(
    job: Job,
    settings: Settings,
    resolver: Resolver,
    progress: Callable[[int, int], None] | None = None,
) -> Verdict:
    subject = Subject(
        job.source,
        resolver,
        job.arguments,
        trust=settings.trust,
        targets=settings.targets,
        frame=job.frame,
        parameters=job.parameters,
        cache=settings.cache,
        progress=progress,
    )
    verdict = judge(subject, settings.chosen, settings.config)
    return _without_arguments(verdict, job) if job.found else verdict


def _without_arguments(verdict: Verdict, job: Job) -> Verdict:
    """A file that was found, not named, and cannot be expanded for want of arguments is skipped."""
    names = missing_arguments(verdict.diagnostics)
    if not names:
        return verdict
    needed = ", ".join(names)
    reason = f"needs arguments ({needed}): give them in the configuration, as [[robot]]"
    return verdict._replace(diagnostics=(), skipped=(Skipped("", job.source.path, reason),))


def missing_arguments(found: Iterable[Diagnostic | Problem]) -> list[str]:
    """The arguments without which a xacro does not expand, by what was found in it."""
    return list(dict.fromkeys(one.message.split("'")[1] for one in found if one.code == "XAC010"))


def _report(plan: _Plan, verdicts: list[Verdict]) -> Report:
    once: dict[tuple[object, ...], Diagnostic] = {}
    files_of: dict[str, str] = {}
    for verdict in verdicts:
        for diagnostic in verdict.diagnostics:
            # Two robots of one run may include the same file, each in its own words; its defect
            # is told once.
            path = diagnostic.span.source.path
            file = files_of.get(path) or files_of.setdefault(path, os.path.realpath(path))
            key = (diagnostic.code, file, *diagnostic.span[1:], diagnostic.message)
            once.setdefault(key, diagnostic)
    files = Counter(job.source.path for job in plan.jobs)
    return Report(
        tuple(files),
        tuple(sorted(once.values(), key=_reading_order)),
        (*plan.skipped, *(skip for verdict in verdicts for skip in verdict.skipped)),
        tuple(crash for verdict in verdicts for crash in verdict.crashed),
        tuple(sorted({code for verdict in verdicts for code in verdict.ran})),
        tuple(
            (job.source.path, verdict.targets)
            for job, verdict in zip(plan.jobs, verdicts, strict=True)
            if verdict.targets is not None
        ),
        sum(verdict.suppressed for verdict in verdicts),
        errors=tuple(
            tuple(d.code for d in verdict.diagnostics if d.severity is Severity.ERROR)
            for verdict in verdicts
        ),
        proposals=tuple(
            tuple(edit for d in verdict.diagnostics if d.fix for edit in d.fix.edits)
            for verdict in verdicts
        ),
    )


def _reading_order(diagnostic: Diagnostic) -> tuple[str, int, str, str]:
    span = diagnostic.span
    return (span.source.path, span.start, diagnostic.code, diagnostic.message)
