"""check(): descriptions of robots make a Report."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping

from urdfkit.core import disk, limits
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.lint import rule_index, rules
from urdfkit.lint.argument_sets import as_launched
from urdfkit.lint.check_job import (
    check_context,
    check_job,
    check_one_of_many,
    check_sets,
    reader,
)
from urdfkit.lint.config import Config
from urdfkit.lint.context import Context
from urdfkit.lint.findings import diagnose
from urdfkit.lint.merging import Checked, merged_report
from urdfkit.lint.options import Options, words
from urdfkit.lint.plan import Job, Plan, planned
from urdfkit.lint.report import Report
from urdfkit.text.diagnostic import Diagnostic
from urdfkit.text.file_kinds import is_launch
from urdfkit.text.source import Source, Span
from urdfkit.workspace.resolve import Resolver

if TYPE_CHECKING:
    from urdfkit.lint.processes import Workers

#: Robots for each process that make a further one worth while.
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
        packages: directories of ROS packages by name; they win over every search.
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
        select=words("select", select),
        ignore=words("ignore", ignore),
        targets=words("targets", targets),
        trust=trust,
        config=config,
    )
    return check_with(given, files)


def check_with(
    options: Options,
    files: Iterable[str | os.PathLike[str] | Source],
    resolver: Resolver | None = None,
    *,
    workers: Workers | None = None,
    spills: bool = False,
) -> Report:
    """Check descriptions of robots.

    Args:
        files: as of ``check``.
        resolver: what an earlier check with these packages has found of packages and directories;
            for many checks in a row, while nothing changes on disk.
        workers: the processes of these checks; made for this one if None.
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
    checked = _checked(plan.jobs, options, resolver, workers)
    return merged_report(plan, checked, _unchecked(plan, options), spills=spills)


def check_read(options: Options, context: Context) -> Report:
    """Check a robot that was read already.

    Args:
        options: how; resolved, and of this robot alone (`Options.for_one`).
        context: the robot, for the targets of the options.
    """
    plan = Plan(context.resolver, options)
    job = Job(context.source.path, "", context.arguments, False, source=context.source)
    plan.jobs.append(job)
    return merged_report(plan, [(job, check_context(job, context, options))], ())


def check_robots(
    options: Options, file: str | os.PathLike[str] | Source, resolver: Resolver
) -> tuple[Report, list[Context]]:
    """Check the robots of one file, which are returned with the report.

    Args:
        options: how; resolved.
        file: as of ``check``.
        resolver: as of ``check_with``.

    Raises:
        UrdfkitError: as of ``check``.
    """
    plan, read = planned([file], resolver, options), reader(options, resolver)
    robots = [as_launched(job, read) for job in plan.jobs]
    checked = [result for sets in robots for result in check_sets(sets, options)]
    return merged_report(plan, checked, ()), [context for sets in robots for _, context in sets]


def contexts(
    options: Options, files: Iterable[str | os.PathLike[str] | Source]
) -> Iterator[Context | None]:
    """The descriptions that a check with the same options looks at, in the same order.

    None stands for a launch file, and for a robot that another description is already, of which
    only some rules are asked. Nothing is read before it is asked for.
    """
    options = options.with_config()
    resolver = Resolver(options.packages, texts=options.texts)
    for planned_job in planned(files, resolver, options).jobs:
        for job, context in as_launched(planned_job, reader(options, resolver)):
            yield None if is_launch(job.path) or job.codes else context


def _checked(
    jobs: list[Job], options: Options, resolver: Resolver, workers: Workers | None
) -> Iterator[Checked]:
    if len(jobs) == 1:
        yield from check_job(jobs[0], options, resolver)
        return
    progress, options = options.progress, options._replace(progress=None)
    for done, some in enumerate(_each(jobs, options, resolver, workers), 1):
        yield from some
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


def process_count(asked: int, robots: int) -> int:
    """How many processes check some robots.

    Args:
        asked: by the user; 0 for as many as are worth while.
        robots: how many there are.
    """
    if asked:
        return min(asked, robots)
    return min(limits.processors(), robots // ROBOTS_PER_PROCESS)


def _unchecked(plan: Plan, options: Options) -> Iterator[Diagnostic]:
    """A finding for each file that looks like a robot and is none that can be checked."""
    code, config = rule_index.NOT_CHECKED, options.config
    for path, message, help in plan.unchecked if code in options.select else ():
        at = rules.Location(Span(Source(path, b""), 0, 0))
        for found in diagnose(rule_index.get(code), [rules.Finding(at, message, help)]):
            severity = config.severities.get(code, found.severity)
            if not config.ignores(code, path, severity):
                yield found._replace(severity=severity)
