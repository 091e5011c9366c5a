"""Checks one description of a plan."""

from __future__ import annotations

import gc
import re
import sys
from bisect import bisect_right
from collections.abc import Callable, Iterable, Iterator

from urdfkit.core.grouping import by_key
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.errors import UrdfkitError
from urdfkit.lint import rule_index
from urdfkit.lint.argument_sets import as_checked
from urdfkit.lint.context import Context
from urdfkit.lint.merging import Checked
from urdfkit.lint.options import Options
from urdfkit.lint.plan import Job
from urdfkit.lint.report import DEFINES_NO_LINK, IS_SRDF, Skipped, crash
from urdfkit.lint.runner import FileResult, run_rules
from urdfkit.lint.switched_arguments import is_wrong_call
from urdfkit.lint.unknown_arguments import unknown_arguments
from urdfkit.text.diagnostic import Confidence, Diagnostic, Severity
from urdfkit.text.file_kinds import has_srdf_tags
from urdfkit.text.source import Span, shown
from urdfkit.workspace.resolve import Resolver

if TYPE_CHECKING:
    from urdfkit.ros.targets import Targets

#: In the default of an argument: a path, which chooses no part of a robot.
_PATH = r"/|\$\(find "
#: Rules about names, which launch files may tell apart by a prefix that is empty by default.
_OF_NAMES = ("NAM001", "TRE003")


def reader(options: Options, resolver: Resolver) -> Callable[[Job], Context]:
    """A function that reads the description of a job."""
    targets = given_targets(options)

    def read(job: Job) -> Context:
        return Context(
            job.text(resolver),
            resolver,
            job.arguments,
            trust=options.trust,
            targets=targets,
            frame=job.frame,
            parameters=job.parameters,
            cache=options.cache,
            progress=options.progress,
            simulate=options.simulate,
        )

    return read


def given_targets(options: Options) -> Targets | None:
    """The targets to check for; None if they are detected from each model."""
    if not options.targets:
        return None
    from urdfkit.ros.targets import parse

    return parse(options.targets)


def check_one_of_many(job: Job, options: Options, resolver: Resolver) -> list[Checked]:
    """Check one of several robots, and free its memory.

    A robot contains reference cycles. To the garbage collector its meshes are a few objects, but
    they take hundreds of megabytes: without a collection dozens of robots would accumulate.
    Generation 1 suffices for a robot; a full collection takes 20 ms because of the objects of
    modules, and is made for the older objects of a robot with several sets of arguments.
    """
    checked = check_job(job, options, resolver)
    if len(checked) > 1:
        gc.collect()
    elif "numpy" in sys.modules:
        gc.collect(1)
    return checked


def check_job(job: Job, options: Options, resolver: Resolver) -> list[Checked]:
    try:
        return check_sets(_freed(as_checked(job, reader(options, resolver))), options)
    except UrdfkitError:
        raise
    except Exception as error:  # a bug in urdfkit must not hide the findings of other robots
        return [(job, failed(job, error))]


def _freed(sets: list[tuple[Job, Context]]) -> Iterator[tuple[Job, Context]]:
    """Argument sets, the meshes of each of which are freed before the next.

    Five sets of a hand with 40 dense meshes would take 650 MB, and take 300 MB.
    """
    for job, context in sets:
        yield job, context
        context.free()
        if "numpy" in sys.modules:
            gc.collect(1)


def check_sets(sets: Iterable[tuple[Job, Context]], options: Options) -> list[Checked]:
    """Check one robot with each of its argument sets."""
    checked = []
    for job, context in sets:
        result = check_context(job, context, options)
        checked.append((job, _with_unknown_values(job, context, result)))
    started = _with_assumed([pair for pair in checked if not pair[0].switched])
    return [*started, *_with_switched(started, [pair for pair in checked if pair[0].switched])]


def _with_switched(started: list[Checked], switched: list[Checked]) -> Iterator[Checked]:
    """The results of one robot with another value of an argument, about what this adds to it.

    Its errors are warnings, since nobody may want this robot, and its infos are left out. So is
    what depends on arguments, if others of them are assumed, or have to change with this one, and
    why it does not expand, but for a call with other parameters than the macro has.
    """
    known = {_identity(one) for _, result in started for one in result.diagnostics}
    for job, result in switched:
        is_unsure = job.needs_others or bool(job.assumed)
        new = [
            one._replace(severity=Severity.WARNING, variants=(job.switched,))
            for one in result.diagnostics
            if one.severity is not Severity.INFO
            and _identity(one) not in known
            and (one.code not in rule_index.NOT_EXPANDED or is_wrong_call(one))
            and not _is_present(one.span, job)
            and not (is_unsure and _needs_all_parts(one.code))
        ]
        # The job is sent to another process.
        yield job._replace(present={}), result._replace(diagnostics=tuple(new))


def _needs_all_parts(code: str) -> bool:
    rule = rule_index.get(code)
    return rule.depends_on_arguments or rule.reports_missing


def _is_present(span: Span, job: Job) -> bool:
    """True for a place in a tag that the robot also has as it is started."""
    tags = job.present.get(span.source.path, [])
    before = bisect_right(tags, span.start, key=lambda tag: tag[0])
    return before > 0 and span.start < tags[before - 1][1]


def _with_unknown_values(job: Job, context: Context, result: FileResult) -> FileResult:
    """A result with lower severities where the launch files pass other values than the defaults.

    Launch files with a gripper argument start the robot with one, which may be known only at run
    time; with its defaults the robot has no gripper, and unconnected parts. A finding with a fix is
    a typo of an existing name, and keeps its severity.
    """
    xacro = context.reading.xacro
    open_names = set(xacro.defaults) if xacro else set()
    open_names -= job.arguments.keys()
    if not open_names:
        return result
    codes = {diagnostic.code for diagnostic in result.diagnostics}
    empty = {name for name in open_names if xacro and not xacro.defaults[name].strip()}
    of_names = _OF_NAMES if empty & job.replaced else ()
    codes = {
        code for code in codes if rule_index.get(code).depends_on_arguments or code in of_names
    }
    if not codes:
        return result
    from urdfkit.ros.launch.robot_arguments import is_handed_on, known_at_run_time

    own = open_names if "" in job.unknown else open_names.intersection(job.unknown)
    own = {name for name in own if xacro and not re.search(_PATH, xacro.defaults[name])}
    unknown = known_at_run_time(job.path, open_names, context.resolver)
    names = sorted({*own, *unknown, *job.replaced})
    if not names:  # a launch file may choose one of several robots
        names = sorted(
            name for name in open_names if is_handed_on(job.path, name, context.resolver)
        )
    if not names:
        return result
    with_defaults = (f"the default of {', '.join(names)}",)

    def lowered(finding: Diagnostic) -> Diagnostic:
        if finding.code not in codes or finding.severity is Severity.INFO or finding.fix:
            return finding
        lower = Severity.WARNING if finding.severity is Severity.ERROR else Severity.INFO
        return finding._replace(
            severity=lower, confidence=Confidence.GUESSED, variants=with_defaults
        )

    return result._replace(diagnostics=tuple(map(lowered, result.diagnostics)))


def _with_assumed(checked: list[Checked]) -> list[Checked]:
    """The results of one robot, without errors that depend on assumed argument values.

    An error that occurs only with assumed values becomes a warning that states them, unless it
    occurs with all of several sets: then it does not depend on the values. It becomes an info if
    its rule reports no error with another set: the values are those of another variant.
    """
    sets = [job.assumed for job, _ in checked if job.assumed]
    sets_by_finding = by_key(
        (_identity(diagnostic), job.assumed)
        for job, result in checked
        for diagnostic in result.diagnostics
    )

    errors = [
        {
            diagnostic.code
            for diagnostic in result.diagnostics
            if diagnostic.severity is Severity.ERROR
        }
        for job, result in checked
        if job.assumed
    ]

    def lowered(finding: Diagnostic) -> Diagnostic:
        own = tuple(dict.fromkeys(sets_by_finding[_identity(finding)]))
        if finding.severity is not Severity.ERROR or "" in own or len(own) == len(sets) > 1:
            return finding
        is_everywhere = all(finding.code in codes for codes in errors)
        severity = Severity.WARNING if is_everywhere else Severity.INFO
        return finding._replace(
            severity=severity, confidence=Confidence.GUESSED, variants=own, fix=None
        )

    return [
        (job, result._replace(diagnostics=tuple(map(lowered, result.diagnostics))))
        for job, result in checked
    ]


def _identity(finding: Diagnostic) -> object:
    return finding.code, finding.span.source.path, *finding.span[1:], finding.message


def failed(job: Job, error: Exception) -> FileResult:
    """The result of a robot on which urdfkit itself fails."""
    return FileResult((), (), (crash("", job.path, error),), frozenset(), None, 0)


def check_context(job: Job, context: Context, options: Options) -> FileResult:
    chosen = [code for code in options.select if not job.codes or code in job.codes]
    # A robot found in a directory may require arguments; that is not a defect.
    missing = context.reading.missing_argument_codes if job.may_fail else ()
    codes = [code for code in chosen if code not in missing]
    result = run_rules(context, codes, options)
    is_wrong = any(one.severity is Severity.ERROR for one in result.diagnostics)
    if reason := "" if job.may_fail or is_wrong else _why_no_robot(context):
        no_robot = Skipped("", context.source.path, reason)
        result = result._replace(skipped=(*result.skipped, no_robot))
    result = _skipped_as_one(result, context)
    unknown = {"": unknown_arguments(context, options.arguments)}
    if names := options.config.argument_names(job.path) - set(options.arguments):
        entry = f"{shown(options.config.path)}: {shown(job.path)} has no"
        unknown[entry] = unknown_arguments(context, sorted(names))
    return result._replace(unknown_arguments=unknown, srdf=context.read_srdf)


def _why_no_robot(context: Context) -> str:
    """Why a file that the user named is no robot; empty for a robot."""
    reading = context.reading
    if reading.xacro is not None and reading.xacro.is_library:
        return DEFINES_NO_LINK
    return IS_SRDF if reading.document and has_srdf_tags(reading.document.root) else ""


def _skipped_as_one(result: FileResult, context: Context) -> FileResult:
    """A result that skips the whole description if it is unreadable and no error states why."""
    errors = {
        d.code
        for d in result.diagnostics
        if d.severity is Severity.ERROR or d.code in rule_index.NOT_EXPANDED
    }
    if context.is_readable or context.reading.is_fragment or not errors <= {rule_index.NOT_CHECKED}:
        return result
    from urdfkit.lint.unchecked import why_unchecked

    reason, _ = why_unchecked(context.reading, context.source, context.resolver)
    return result._replace(skipped=(Skipped("", context.source.path, reason),))
