"""check(): descriptions of robots make a Report."""

from __future__ import annotations

import gc
import os
import sys
from collections import Counter
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from typing import TYPE_CHECKING

from urdfkit.core.record import Record
from urdfkit.errors import UrdfkitError
from urdfkit.lint import rules as catalogue
from urdfkit.lint.context import Subject
from urdfkit.lint.plan import Job, Plan, as_launched, missing_arguments, planned, unknown_arguments
from urdfkit.lint.report import Report, Skipped, crash
from urdfkit.lint.runner import FileResult, diagnose, judge
from urdfkit.text.diagnostic import Confidence, Diagnostic, Severity
from urdfkit.text.file_kinds import is_launch
from urdfkit.text.source import Source, Span, shown
from urdfkit.workspace.resolve import Resolver

if TYPE_CHECKING:
    from typing import TypedDict

    from urdfkit.lint.config import Config
    from urdfkit.ros.targets import Targets

    class Options(TypedDict, total=False):
        """What ``check`` takes besides files, for functions that check as a part of their work."""

        arguments: Mapping[str, str] | None
        packages: Mapping[str, str] | None
        select: Iterable[str]
        ignore: Iterable[str]
        targets: Iterable[str]
        trust: bool
        rules: Iterable[str]
        preview: bool | Collection[str]
        min_confidence: str
        config: Config | None
        variant: str
        changed: bool
        jobs: int
        progress: Callable[[int, int], None] | None
        texts: Mapping[str, bytes] | None
        cache: bool


#: A description, and what the rules say about it.
Judged = tuple[Job, FileResult]


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
    given: tuple[str, ...]
    previews: frozenset[str] | None


def check(
    *files: str | os.PathLike[str] | Source,
    arguments: Mapping[str, str] | None = None,
    packages: Mapping[str, str] | None = None,
    select: Iterable[str] = (),
    ignore: Iterable[str] = (),
    targets: Iterable[str] = (),
    trust: bool = False,
    rules: Iterable[str] = (),
    preview: bool | Collection[str] = False,
    min_confidence: str = "",
    config: Config | None = None,
    variant: str = "",
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
            points of the group ``urdfkit.lint.rules``), or of modules, which are imported.
        preview: run preview rules, too: all, or those of these codes; without it, those that
            ``select`` names by their whole code or name.
        min_confidence: leave out findings that are less sure: ``measured``, ``inferred`` or
            ``guessed``.
        config: settings of the project; the other arguments go before them.
        variant: the name of the only one, of those in the configuration, that is checked.
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
        ConfigError: a robot has no variant of this name.
        UnknownRule: a word of ``select`` or ``ignore`` means no rule.
        UnknownTarget: a name is no target.
        RuleError: a package of rules is missing or cannot be used.
    """
    foreign = (*(config.foreign_rules if config else ()), *added_rules(rules))
    select, ignore = tuple(select), tuple(ignore)
    config = _overridden(config, select, ignore, min_confidence)
    settings = Settings(
        tuple(choose(select, ignore, config, foreign)),
        {**(config.packages if config else {}), **(packages or {})},
        _given(targets, config),
        trust or (config is not None and config.trust),
        config,
        catalogue.foreign(),
        dict(texts or {}),
        cache,
        tuple(arguments or ()),
        previewed(preview, select, config),
    )
    if resolver is None:
        resolver = Resolver(settings.packages, texts=settings.texts)
    else:
        resolver = resolver.with_texts(settings.texts)
    plan = planned(files, resolver, config, arguments, variant=variant, changed=changed)
    judged = _judged(plan.jobs, settings, resolver, jobs, progress)
    return _report(plan, _launched_once(judged), _unopened(plan, settings))


def _overridden(
    config: Config | None, select: Iterable[str], ignore: Iterable[str], min_confidence: str
) -> Config | None:
    """A configuration with what the arguments of a check say of its findings."""
    but_errors = catalogue.ignored(ignore).but_errors
    if config is None and not (but_errors or min_confidence):
        return None
    from urdfkit.lint.config import Config

    found = config or Config()
    # What is selected by hand is reported, whatever the configuration leaves out.
    selected = {code for word in select for code in catalogue.matching(word)}
    found = found._replace(but_errors=(found.but_errors - selected) | but_errors)
    if min_confidence:
        found = found._replace(min_confidence=Confidence(min_confidence))
    return found


def subjects(
    *files: str | os.PathLike[str] | Source,
    arguments: Mapping[str, str] | None = None,
    packages: Mapping[str, str] | None = None,
    trust: bool = False,
    config: Config | None = None,
    variant: str = "",
    changed: bool = False,
    texts: Mapping[str, bytes] | None = None,
) -> Iterator[Subject | None]:
    """The descriptions that ``check`` checks with the same arguments, in the same order.

    None stands for a launch file. Nothing is read before it is asked for.
    """
    known = {**(config.packages if config else {}), **(packages or {})}
    resolver = Resolver(known, texts=texts)
    is_trusted = trust or (config is not None and config.trust)

    def read(job: Job) -> Subject:
        return Subject(job.source, resolver, job.arguments, trust=is_trusted, frame=job.frame)

    for planned_job in planned(
        files, resolver, config, arguments, variant=variant, changed=changed
    ).jobs:
        for job, subject in as_launched(planned_job, read):
            yield None if is_launch(job.source.path) else subject


def added_rules(packages: Iterable[str]) -> list[str]:
    """The codes of packages of rules, which are known from now on."""
    names = tuple(packages)
    if not names:
        return []
    from urdfkit.lint.rule_packages import add

    return add(names, modules=True)


def _given(names: Iterable[str], config: Config | None) -> Targets | None:
    """The targets that were asked for; None if none were."""
    names = tuple(names) or (config.targets if config else ())
    if not names:
        return None
    from urdfkit.ros.targets import parse

    return parse(names)


def choose(
    select: Iterable[str],
    ignore: Iterable[str],
    config: Config | None = None,
    foreign: Iterable[str] = (),
) -> list[str]:
    """The codes that one of ``select`` means and none of ``ignore``.

    ``CFG003`` is one of them unless it is ignored: of a robot that is not checked, no selection
    of rules finds anything.

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
    left_out = catalogue.ignored(ignore)
    if left_out.unknown:
        raise left_out.unknown[0]
    ignored = set(left_out.codes)
    if config is not None:
        # What is selected by hand runs, whatever the configuration leaves out.
        ignored |= config.ignore - selected
        selected = selected or set(config.select)
    chosen = selected or {*catalogue.codes(), *foreign}
    return sorted((chosen | {catalogue.NOT_CHECKED}) - ignored)


def previewed(
    preview: bool | Collection[str], select: Iterable[str], config: Config | None
) -> frozenset[str] | None:
    """The codes of the preview rules that run; None for all."""
    if not isinstance(preview, bool):
        return frozenset(preview)
    if preview or (config is not None and config.preview):
        return None
    return catalogue.named(select) | (config.named if config else frozenset())


def _judged(
    jobs: list[Job],
    settings: Settings,
    resolver: Resolver,
    processes: int,
    progress: Callable[[int, int], None] | None,
) -> list[Judged]:
    if len(jobs) == 1:
        return _run(jobs[0], settings, resolver, progress)
    judged: list[Judged] = []
    for done, some in enumerate(_each(jobs, settings, resolver, processes), 1):
        judged += some
        if progress is not None:
            progress(done, len(jobs))
    return judged


def _each(
    jobs: list[Job], settings: Settings, resolver: Resolver, processes: int
) -> Iterable[list[Judged]]:
    if processes <= 1:
        return (_run_one(job, settings, resolver) for job in jobs)
    return _in_processes(jobs, settings, processes)


def _in_processes(jobs: list[Job], settings: Settings, processes: int) -> Iterable[list[Judged]]:
    """Each job in a process.

    A process that dies takes the others of its pool with it. What they had not done is checked
    again by one process, which shows the robot that it dies of.
    """
    import signal
    import time
    from concurrent.futures import ProcessPoolExecutor
    from concurrent.futures.process import BrokenProcessPool

    # Ctrl-C reaches every process of the terminal; only the first one has something to say.
    silent = (signal.SIGINT, signal.SIG_DFL)
    count = min(processes, len(jobs))
    done = 0
    with ProcessPoolExecutor(count, initializer=signal.signal, initargs=silent) as pool:
        # Not `map`, which cancels what is left and trips over it when the processes are gone.
        futures = [pool.submit(_run_alone, job, settings) for job in jobs]
        try:
            for future in futures:
                yield future.result()
                done += 1
        except BrokenProcessPool:
            time.sleep(1)  # the others may have heard Ctrl-C first; then it is raised here
            if count == 1:
                died = RuntimeError("the process of its check died")
                yield [(jobs[done], _failed(jobs[done], died))]
                done += 1
    if jobs[done:]:
        yield from _in_processes(jobs[done:], settings, 1)


def _run_alone(job: Job, settings: Settings) -> list[Judged]:
    catalogue.register(settings.foreign)  # this process may have begun with nothing
    return _run_one(job, settings, Resolver(settings.packages, texts=settings.texts))


def _run_one(job: Job, settings: Settings, resolver: Resolver) -> list[Judged]:
    """One of several robots, of which nothing but the verdict stays.

    A robot is full of references in circles. The meshes that hang on them are no more than a few
    objects to the collector, but hundreds of megabytes: it would let dozens of robots pile up.
    """
    judged = _run(job, settings, resolver)
    if "numpy" in sys.modules:
        gc.collect()
    return judged


def _run(
    job: Job,
    settings: Settings,
    resolver: Resolver,
    progress: Callable[[int, int], None] | None = None,
) -> list[Judged]:
    def read(job: Job) -> Subject:
        return Subject(
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

    try:
        return [
            (launched, _verdict(launched, subject, settings))
            for launched, subject in as_launched(job, read)
        ]
    except UrdfkitError:
        raise
    except Exception as error:  # a bug in urdfkit must not hide the findings of other robots
        return [(job, _failed(job, error))]


def _failed(job: Job, error: Exception) -> FileResult:
    """The result of a robot on which urdfkit itself fails."""
    return FileResult((), (), (crash("", job.source.path, error),), frozenset(), None, 0)


def _verdict(job: Job, subject: Subject, settings: Settings) -> FileResult:
    chosen = [code for code in settings.chosen if not job.codes or code in job.codes]
    # That a robot of a folder cannot be expanded by itself is no defect of it.
    wants = job.found and missing_arguments(subject)
    codes = [code for code in chosen if code != "XAC010"] if wants else chosen
    verdict = _skipped_as_one(judge(subject, codes, settings.config, settings.previews), subject)
    unknown = unknown_arguments(subject, settings.given) if settings.given else {}
    return verdict._replace(unknown_arguments=unknown)


def _skipped_as_one(verdict: FileResult, subject: Subject) -> FileResult:
    """A description that cannot be read, of which no error says so, is skipped as a whole."""
    errors = {d.code for d in verdict.diagnostics if d.severity is Severity.ERROR}
    if subject.is_readable or subject.is_fragment or not errors <= {catalogue.NOT_CHECKED}:
        return verdict
    from urdfkit.lint.unchecked import why_unchecked

    why, _ = why_unchecked(subject.reading, subject.source, subject.resolver)
    return verdict._replace(skipped=(Skipped("", subject.source.path, why),))


def _unopened(plan: Plan, settings: Settings) -> Iterator[Diagnostic]:
    """A finding for each file of a folder that is called like a robot and cannot be opened."""
    code, config = catalogue.NOT_CHECKED, settings.config
    for path in plan.closed if code in settings.chosen else ():
        at = catalogue.Location(Span(Source(path, b""), 0, 0))
        message = "robot not checked: the file cannot be opened"
        help = "check the symbolic link and the file permissions"
        for found in diagnose(catalogue.get(code), [catalogue.Finding(at, message, help)]):
            severity = (config.severities.get(code) if config else None) or found.severity
            if not (config and config.ignores(code, path, severity)):
                yield found._replace(severity=severity)


def _launched_once(judged: list[Judged]) -> list[Judged]:
    """The verdicts, without that a robot is not checked as a launch file starts it.

    What a launch file gives it is not always known without running it. It is enough that the
    robot is checked otherwise.
    """
    read = {
        os.path.realpath(job.source.path)
        for job, verdict in judged
        if all(skip.code for skip in verdict.skipped)
    }
    return [
        (job, verdict._replace(diagnostics=(), skipped=()))
        if job.frame
        and any(not skip.code for skip in verdict.skipped)
        and os.path.realpath(job.source.path) in read
        else (job, verdict)
        for job, verdict in judged
    ]


def _report(plan: Plan, judged: list[Judged], unopened: Iterable[Diagnostic]) -> Report:
    verdicts = [verdict for _, verdict in judged]
    files = Counter(job.source.path for job in plan.jobs)
    return Report(
        tuple(files),
        tuple(sorted((*_distinct(judged), *unopened), key=_reading_order)),
        (*plan.skipped, *(skip for verdict in verdicts for skip in verdict.skipped)),
        (*plan.crashed, *(crash for verdict in verdicts for crash in verdict.crashed)),
        tuple(sorted({code for verdict in verdicts for code in verdict.ran})),
        tuple(
            (job.source.path, verdict.targets)
            for job, verdict in judged
            if verdict.targets is not None
        ),
        sum(verdict.suppressed for verdict in verdicts),
        errors=tuple(
            tuple(
                one
                for one in (*verdict.diagnostics, *verdict.consequences)
                if one.severity is Severity.ERROR
            )
            for verdict in verdicts
        ),
        proposals=tuple(
            tuple(edit for d in verdict.diagnostics if d.fix for edit in d.fix.edits)
            for verdict in verdicts
        ),
        launched=tuple(one for job, _ in judged for one in job.launched),
        unknown_arguments=tuple(
            one
            for one in (verdicts[0].unknown_arguments.items() if verdicts else ())
            if all(one[0] in verdict.unknown_arguments for verdict in verdicts)
        ),
    )


def _distinct(judged: list[Judged]) -> Iterator[Diagnostic]:
    """The findings, each once, with the variants of the robot that it is found in.

    Two robots of one run may include the same file, each in its own words; its defect is told
    once.
    """
    once: dict[tuple[object, ...], Diagnostic] = {}
    found_in: dict[tuple[object, ...], list[Job]] = {}
    files_of: dict[str, str] = {}
    for job, verdict in judged:
        for diagnostic in verdict.diagnostics:
            path = diagnostic.span.source.path
            file = files_of.get(path) or files_of.setdefault(path, os.path.realpath(path))
            key = (diagnostic.code, file, *diagnostic.span[1:], diagnostic.message)
            once.setdefault(key, diagnostic)
            found_in.setdefault(key, []).append(job)
    variants: dict[str, set[str]] = {}
    for job, _ in judged:
        variants.setdefault(job.source.path, set()).add(job.name)
    for jobs, diagnostic in zip(found_in.values(), once.values(), strict=True):
        names = _partial(jobs, variants)
        yield diagnostic._replace(variants=names) if names else diagnostic


def _partial(found_in: list[Job], variants: dict[str, set[str]]) -> tuple[str, ...]:
    """The names of variants with a finding; none if it is in all those of some robot."""
    names: dict[str, dict[str, None]] = {}
    for job in found_in:
        names.setdefault(job.source.path, {})[job.name] = None
    if any("" in own or len(own) == len(variants[path] - {""}) for path, own in names.items()):
        return ()
    return tuple(dict.fromkeys(name for own in names.values() for name in own))


def _reading_order(diagnostic: Diagnostic) -> tuple[str, int, str, str]:
    span = diagnostic.span
    return (shown(span.source.path), span.start, diagnostic.code, diagnostic.message)
