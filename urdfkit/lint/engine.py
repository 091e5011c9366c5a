"""check(): checks robot descriptions and returns a Report."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping

from urdfkit.core import disk, limits
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.lint import rule_index, rules
from urdfkit.lint.argument_sets import as_checked
from urdfkit.lint.check_job import check_context, check_job, check_one_of_many, check_sets, reader
from urdfkit.lint.config import Config
from urdfkit.lint.context import Context
from urdfkit.lint.findings import diagnose
from urdfkit.lint.merging import Checked, merged_report
from urdfkit.lint.options import Options
from urdfkit.lint.plan import Job, Plan, planned
from urdfkit.lint.report import Report
from urdfkit.text.diagnostic import Diagnostic
from urdfkit.text.source import Source, Span
from urdfkit.workspace.resolve import Resolver

if TYPE_CHECKING:
    from urdfkit.lint.processes import Workers

#: Least number of robots per process.
ROBOTS_PER_PROCESS = 10


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
    """Check robot descriptions.

    >>> report = check("models/good/gripper.urdf")
    >>> report.ok, len(report.crashed), report.exit_code()
    (True, 0, 0)
    >>> text = b'<robot name="r"><link name="a"/><link name="a"/></robot>'
    >>> report = check(Source("r.urdf", text), select=["NAM"])
    >>> [(found.code, found.span.column) for found in report.diagnostics]
    [('NAM001', 45)]

    Args:
        files: URDF, xacro or launch files, Sources, or directories, whose entry points are checked.
        arguments: xacro arguments, like ``name:=value`` on the command line.
        packages: directories of ROS packages by name; they override every search.
        select: rules to run, by code, prefix of codes, or name; all if empty.
        ignore: rules not to run, by code, prefix of codes, or name.
        targets: names of the programs to check for; detected from each model if empty.
        trust: do not sandbox the expressions of the model, and let it read any file.
        config: settings of the project; the other arguments override them.
        options: less common options; the arguments above override them.

    Raises:
        UnreadableFile: a file is missing or may not be read.
        ConfigError: a robot has no variant of this name.
        UnknownRule: a word of ``select`` or ``ignore`` matches no rule.
        UnknownTarget: a name is not a target.
        RuleError: a package of rules is missing or cannot be used.
    """
    options = options.given(
        arguments=arguments,
        packages=packages,
        select=select,
        ignore=ignore,
        targets=targets,
        trust=trust,
        config=config,
    )
    return check_with(options, files)


def check_with(
    options: Options,
    files: Iterable[str | os.PathLike[str] | Source],
    resolver: Resolver | None = None,
    *,
    workers: Workers | None = None,
    spills: bool = False,
) -> Report:
    """Check robot descriptions.

    Args:
        files: see ``check``.
        resolver: resolver of an earlier check with these packages, with its caches; for repeated
            checks while nothing changes on disk.
        workers: the processes of these checks; created for this check if None.
        spills: store the findings of very many robots on disk, for a report that is only printed.

    Raises:
        UrdfkitError: see ``check``.
    """
    options = options.resolved()
    if resolver is None:
        resolver = Resolver(options.packages, texts=options.texts)
    else:
        resolver = resolver.with_texts(options.texts)
    plan = planned(files, resolver, options)
    checked = _checked(plan.jobs, options, resolver, workers)
    return merged_report(plan, checked, _unchecked(plan, options), spills=spills)


def check_read(options: Options, context: Context) -> Report:
    """Check a robot that has already been read.

    Args:
        options: resolved, and for this robot only (`Options.for_one`).
        context: the robot, read for the targets of the options.
    """
    plan = Plan(context.resolver, options)
    job = Job(context.source.path, "", context.arguments, False, source=context.source)
    plan.jobs.append(job)
    return merged_report(plan, [(job, check_context(job, context, options))], ())


def check_robots(
    options: Options, file: str | os.PathLike[str] | Source, resolver: Resolver
) -> tuple[Report, list[Context]]:
    """Check the robots of one file; return them with the report.

    Args:
        options: resolved.
        file: see ``check``.
        resolver: see ``check_with``.

    Raises:
        UrdfkitError: see ``check``.
    """
    plan, read = planned([file], resolver, options), reader(options, resolver)
    robots = [as_checked(job, read) for job in plan.jobs]
    checked = [result for sets in robots for result in check_sets(sets, options)]
    return merged_report(plan, checked, ()), [context for sets in robots for _, context in sets]


def contexts(
    options: Options, files: Iterable[str | os.PathLike[str] | Source]
) -> Iterator[Context | None]:
    """The descriptions that a check with the same options reads, in the same order.

    None stands for a launch file or parameter file, for a duplicate of another description, for
    which only some rules run, and for a robot with another value of an argument, of which only the
    additions are reported.
    Descriptions are read one by one, as the iterator advances.
    """
    options = options.with_config()
    resolver = Resolver(options.packages, texts=options.texts)
    for planned_job in planned(files, resolver, options).jobs:
        for job, context in as_checked(planned_job, reader(options, resolver)):
            is_partial = context.is_bringup or job.codes or job.switched
            yield None if is_partial else context


def _checked(
    jobs: list[Job], options: Options, resolver: Resolver, workers: Workers | None
) -> Iterator[Checked]:
    if len(jobs) == 1:
        yield from check_job(jobs[0], options, resolver)
        return
    progress, options = options.progress, options._replace(progress=None)
    for done, results in enumerate(_each(jobs, options, resolver, workers), 1):
        yield from results
        if progress is not None:
            progress(done, len(jobs))


def _each(
    jobs: list[Job], options: Options, resolver: Resolver, workers: Workers | None
) -> Iterator[list[Checked]]:
    count = process_count(options.jobs, len(jobs))
    if count > 1:
        from urdfkit.lint.processes import Workers, in_processes

        admitted = tuple(resolver.admitted.values())
        known = (rule_index.external(), options, disk.log() is not None, admitted)
        own = workers or Workers()
        try:
            yield from in_processes(jobs, known, count, own)
        finally:
            if workers is None:
                own.end()
        return
    for job in jobs:
        yield check_one_of_many(job, options, resolver)


def process_count(jobs: int, robots: int) -> int:
    """The number of processes to check some robots with.

    Args:
        jobs: number that the user requests; 0 to choose it by the number of robots.
        robots: number of robots.
    """
    if jobs:
        return min(jobs, robots)
    return min(limits.processors(), robots // ROBOTS_PER_PROCESS)


def _unchecked(plan: Plan, options: Options) -> Iterator[Diagnostic]:
    """A finding for each file that looks like a robot but cannot be checked."""
    code, config = rule_index.NOT_CHECKED, options.config
    for path, message, help in plan.unchecked if code in options.select else ():
        at = rules.Location(Span(Source(path, b""), 0, 0))
        for diagnostic in diagnose(rule_index.get(code), [rules.Finding(at, message, help)]):
            severity = config.severities.get(code, diagnostic.severity)
            if not config.ignores(code, path, severity):
                yield diagnostic._replace(severity=severity)
