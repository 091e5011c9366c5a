"""check(): descriptions of robots make a Report."""

from __future__ import annotations

import gc
import os
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import TYPE_CHECKING

from urdfkit.core import disk, limits
from urdfkit.core.file_log import FileLog
from urdfkit.core.own_sources import note_sources
from urdfkit.errors import UrdfkitError
from urdfkit.lint import rule_index, rules
from urdfkit.lint.config import Config
from urdfkit.lint.context import Subject
from urdfkit.lint.merging import Checked, merged_report
from urdfkit.lint.options import Options
from urdfkit.lint.plan import Job, Plan, as_launched, planned, unknown_arguments
from urdfkit.lint.report import Report, Skipped, crash
from urdfkit.lint.runner import FileResult, diagnose, run_rules
from urdfkit.text.diagnostic import Diagnostic, Severity
from urdfkit.text.file_kinds import is_launch
from urdfkit.text.source import Source, Span
from urdfkit.workspace.resolve import Resolver

if TYPE_CHECKING:
    from concurrent.futures import Future, ProcessPoolExecutor
    from typing import TypeAlias

#: What a process must know: rules of other packages, options, whether it notes what it depends
#: on, and what files the user named.
Known: TypeAlias = "tuple[Mapping[str, str], Options, bool, tuple[str, ...]]"
#: The results of some robots, and what they depend on if that is noted.
Batch: TypeAlias = "tuple[list[list[Checked]], FileLog | None]"

#: Robots for each process that make a further one worth while.
FEW = 10
#: Robots that go to a process at a time.
MOST_OF_A_BATCH = 16


def check(
    *files: str | os.PathLike[str] | Source,
    arguments: Mapping[str, str] | None = None,
    packages: Mapping[str, str] | None = None,
    select: Iterable[str] = (),
    ignore: Iterable[str] = (),
    targets: Iterable[str] = (),
    trust: bool = False,
    config: Config | None = None,
    options: Options = Options(),
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
        files: URDF, xacro or launch files, Sources, or directories, whose entry points are checked.
        arguments: xacro arguments, as ``name:=value`` gives them on the command line.
        packages: folders of ROS packages by name; they win over every search.
        select: codes, beginnings of codes or names; only these rules run. All if empty.
        ignore: codes, beginnings of codes or names of rules that do not run.
        targets: names of the programs to check for; inferred from each model if empty.
        trust: do not sandbox the expressions of the model, and let it read any file.
        config: settings of the project; the other arguments win over them.
        options: those that are rarely given; the arguments above win over its own.

    Raises:
        UnreadableFile: a file is missing or may not be read.
        ConfigError: a robot has no variant of this name.
        UnknownRule: a word of ``select`` or ``ignore`` means no rule.
        UnknownTarget: a name is no target.
        RuleError: a package of rules is missing or cannot be used.
    """
    given = options.given(
        arguments=arguments,
        packages=packages,
        select=tuple(select),
        ignore=tuple(ignore),
        targets=tuple(targets),
        trust=trust,
        config=config,
    )
    return check_with(given, files)


def check_with(
    options: Options,
    files: Iterable[str | os.PathLike[str] | Source],
    resolver: Resolver | None = None,
    *,
    spills: bool = False,
) -> Report:
    """Check descriptions of robots.

    Args:
        options: how.
        files: as of ``check``.
        resolver: what an earlier check with these packages has found of packages and folders;
            for many checks in a row, while nothing changes on disk.
        spills: keep the findings of very many robots on disk, for a report that is only printed.

    Raises:
        UrdfkitError: as of ``check``.
    """
    options = options.resolved()
    if resolver is None:
        resolver = Resolver(options.packages, texts=options.texts)
    else:
        resolver = resolver.with_texts(options.texts)
    plan = planned(files, resolver, options)
    checked = _checked(plan.jobs, options, resolver)
    return merged_report(plan, checked, _unchecked(plan, options), spills=spills)


def check_robots(
    options: Options, file: str | os.PathLike[str] | Source, resolver: Resolver
) -> tuple[Report, list[Subject]]:
    """Check the robots of one file, which are returned with the report.

    Args:
        options: how; resolved.
        file: as of ``check``.
        resolver: as of ``check_with``.

    Raises:
        UrdfkitError: as of ``check``.
    """
    plan, read = planned([file], resolver, options), _reader(options, resolver)
    robots = [pair for job in plan.jobs for pair in as_launched(job, read)]
    checked = [(job, _result(job, subject, options)) for job, subject in robots]
    return merged_report(plan, checked, ()), [subject for _, subject in robots]


def subjects(
    options: Options, files: Iterable[str | os.PathLike[str] | Source]
) -> Iterator[Subject | None]:
    """The descriptions that a check with the same options looks at, in the same order.

    None stands for a launch file, and for a robot that another description is already, of which
    only some rules are asked. Nothing is read before it is asked for.
    """
    options = options.with_config()
    resolver = Resolver(options.packages, texts=options.texts)
    for planned_job in planned(files, resolver, options).jobs:
        for job, subject in as_launched(planned_job, _reader(options, resolver)):
            yield None if is_launch(job.path) or job.codes else subject


def _reader(options: Options, resolver: Resolver) -> Callable[[Job], Subject]:
    """Reads the description of a job."""
    targets = None
    if options.targets:
        from urdfkit.ros.targets import parse

        targets = parse(options.targets)

    def read(job: Job) -> Subject:
        return Subject(
            job.text(resolver),
            resolver,
            job.arguments,
            trust=options.trust,
            targets=targets,
            frame=job.frame,
            parameters=job.parameters,
            cache=options.cache,
            progress=options.progress,
        )

    return read


def _checked(jobs: list[Job], options: Options, resolver: Resolver) -> Iterator[Checked]:
    if len(jobs) == 1:
        yield from _check_job(jobs[0], options, resolver)
        return
    progress, options = options.progress, options._replace(progress=None)
    for done, some in enumerate(_each(jobs, options, resolver), 1):
        yield from some
        if progress is not None:
            progress(done, len(jobs))


def _each(jobs: list[Job], options: Options, resolver: Resolver) -> Iterator[list[Checked]]:
    count = processes(options.jobs, len(jobs))
    if count > 1:
        admitted = tuple(resolver.admitted.values())
        known = (rule_index.foreign(), options, disk.log() is not None, admitted)
        yield from _in_processes(jobs, known, count)
        return
    for job in jobs:
        yield _check_one_of_many(job, options, resolver)


def processes(asked: int, robots: int) -> int:
    """How many processes check some robots.

    Args:
        asked: by the user; 0 for as many as are worth while.
        robots: how many there are.
    """
    if asked:
        return min(asked, robots)
    return min(os.cpu_count() or 1, robots // FEW)


def _in_processes(jobs: list[Job], known: Known, count: int) -> Iterator[list[Checked]]:
    """The results of some jobs in their order, by several processes.

    A process that dies takes the others of its pool with it. What they had not done is checked
    again one by one, which shows the robot that it dies of.
    """
    from collections import deque
    from concurrent.futures.process import BrokenProcessPool

    size = max(1, min(MOST_OF_A_BATCH, len(jobs) // (8 * count)))
    batches = deque(jobs[start : start + size] for start in range(0, len(jobs), size))
    waiting: deque[tuple[list[Job], Future[Batch]]] = deque()
    with _pool(count, known) as pool:
        try:
            while batches or waiting:
                while batches and len(waiting) < 4 * count:  # results must not pile up
                    waiting.append((batches[0], pool.submit(_check_batch, batches[0])))
                    batches.popleft()
                done = waiting[0][1].result()
                waiting.popleft()
                yield from _noted(done)
        except BrokenProcessPool:
            _wait_for_ctrl_c()
    if waiting:
        yield from _one_by_one([job for batch, _ in waiting for job in batch], known)
    if batches:
        yield from _in_processes([job for batch in batches for job in batch], known, count)


def _one_by_one(jobs: list[Job], known: Known) -> Iterator[list[Checked]]:
    """The results of some jobs, each of which may kill its process."""
    from concurrent.futures.process import BrokenProcessPool

    done = 0
    while done < len(jobs):
        with _pool(1, known) as pool:
            try:
                for job in jobs[done:]:
                    yield from _noted(pool.submit(_check_batch, [job]).result())
                    done += 1
            except BrokenProcessPool:
                _wait_for_ctrl_c()
                died = RuntimeError("the process of its check died")
                yield [(jobs[done], _failed(jobs[done], died))]
                done += 1


def _wait_for_ctrl_c() -> None:
    """The processes may have heard it first; then it is raised here."""
    import time

    time.sleep(1)


def _pool(count: int, known: Known) -> ProcessPoolExecutor:
    from concurrent.futures import ProcessPoolExecutor

    return ProcessPoolExecutor(count, initializer=_begin, initargs=known)


#: Of a process of a pool: the options, and what it has found of packages and folders.
_own: tuple[Options, Resolver]


def _begin(
    foreign: Mapping[str, str], options: Options, is_noting: bool, admitted: tuple[str, ...]
) -> None:
    """A process begins, which knows no rules of other packages and has noted nothing."""
    import signal

    # Ctrl-C reaches every process of the terminal; only the first one has something to say.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    rule_index.register(foreign)
    disk.log_to(FileLog() if is_noting else None)
    global _own  # noqa: PLW0603 - a process has one
    _own = (options, Resolver(options.packages, texts=options.texts))
    limits.allow(options.config.limits)
    for path in admitted:
        _own[1].admit(path, trust=options.trust)


def _check_batch(jobs: list[Job]) -> Batch:
    options, resolver = _own
    checked = [_check_one_of_many(job, options, resolver) for job in jobs]
    log = disk.log()
    if log is not None:
        note_sources()
        disk.log_to(FileLog())
    return checked, log


def _noted(batch: Batch) -> list[list[Checked]]:
    """The results of a batch; what they depend on is noted in this process, too."""
    checked, log = batch
    own = disk.log()
    if own is not None and log is not None:
        own.add(log)
    return checked


def _check_one_of_many(job: Job, options: Options, resolver: Resolver) -> list[Checked]:
    """Check one of several robots, and keep nothing but the result.

    A robot is full of references in circles. The meshes that they hold are no more than a few
    objects to the collector, but hundreds of megabytes: it would let dozens of robots pile up.
    """
    checked = _check_job(job, options, resolver)
    if "numpy" in sys.modules:
        gc.collect()
    return checked


def _check_job(job: Job, options: Options, resolver: Resolver) -> list[Checked]:
    try:
        return [
            (launched, _result(launched, subject, options))
            for launched, subject in as_launched(job, _reader(options, resolver))
        ]
    except UrdfkitError:
        raise
    except Exception as error:  # a bug in urdfkit must not hide the findings of other robots
        return [(job, _failed(job, error))]


def _failed(job: Job, error: Exception) -> FileResult:
    """The result of a robot on which urdfkit itself fails."""
    return FileResult((), (), (crash("", job.path, error),), frozenset(), None, 0)


def _result(job: Job, subject: Subject, options: Options) -> FileResult:
    chosen = [code for code in options.select if not job.codes or code in job.codes]
    # That a robot of a folder cannot be expanded by itself is no defect of it.
    lacking = subject.without_arguments if job.found else ()
    codes = [code for code in chosen if code not in lacking]
    result = _skipped_as_one(run_rules(subject, codes, options), subject)
    return result._replace(unknown_arguments=unknown_arguments(subject, options.arguments))


def _skipped_as_one(result: FileResult, subject: Subject) -> FileResult:
    """A description that cannot be read, of which no error says so, is skipped as a whole."""
    errors = {
        d.code
        for d in result.diagnostics
        if d.severity is Severity.ERROR or d.code in rule_index.NOT_EXPANDED
    }
    if subject.is_readable or subject.is_fragment or not errors <= {rule_index.NOT_CHECKED}:
        return result
    from urdfkit.lint.unchecked import why_unchecked

    why, _ = why_unchecked(subject.reading, subject.source, subject.resolver)
    return result._replace(skipped=(Skipped("", subject.source.path, why),))


def _unchecked(plan: Plan, options: Options) -> Iterator[Diagnostic]:
    """A finding for each file that looks like a robot and is none that can be checked."""
    code, config = rule_index.NOT_CHECKED, options.config
    for path, message, help in plan.unchecked if code in options.select else ():
        at = rules.Location(Span(Source(path, b""), 0, 0))
        for found in diagnose(rule_index.get(code), [rules.Finding(at, message, help)]):
            severity = config.severities.get(code, found.severity)
            if not config.ignores(code, path, severity):
                yield found._replace(severity=severity)
