"""One description with each set of arguments that it is checked with."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping

from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.core.suggest import nearest
from urdfkit.lint.plan import Job
from urdfkit.lint.report import Launched, UncheckedValues
from urdfkit.workspace.launch_files import has_launch_files

if TYPE_CHECKING:
    from collections.abc import Callable

    from urdfkit.lint.context import Context
    from urdfkit.ros.launch.robot_arguments import RobotArguments


#: Sets of arguments with which a robot is checked besides its own; the UR arms have nine.
MAX_GIVEN = 16


def as_launched(job: Job, read: Callable[[Job], Context]) -> list[tuple[Job, Context]]:
    """A job with its description, once for each set of arguments that it is checked with.

    A robot that cannot be expanded for want of arguments, or that uses them above their default,
    comes with those that launch files give it. Where none gives them all, one that cannot be
    expanded comes with the values that are found otherwise and with which it expands. One that its
    defaults do not suffice for comes as launch files start it; any other one comes with its
    defaults, and with those arguments of launch files that make it another robot.
    """
    context = read(job)
    if names := context.reading.arguments_to_pass:
        return _with_missing(job, read, context, names) or [(job, context)]
    if job.shared is None:
        return [(job, context)]
    sets = _launch_sets(job, (), context)
    job = job._replace(started=())  # what the report needs of it goes to another process
    if _needs_more_than_defaults(context):
        return _with_more_than_defaults(job, read, sets) or [(job, context)]
    return _with_other_robots(job, read, context, sets) if sets else [(job, context)]


def _launch_sets(job: Job, names: tuple[str, ...], context: Context) -> list[RobotArguments]:
    """What launch files give to a robot, each set once; those with new values come first.

    Args:
        names: of the arguments that it lacks.
    """
    sets: dict[object, RobotArguments] = {}
    for one in (*_given(job, names, context), *job.started):
        if one.arguments.keys() >= set(names):
            files = (file.path for file in one.parameters)
            sets.setdefault((frozenset(one.arguments.items()), *files), one)
    seen: set[tuple[str, str]] = set()
    new: list[RobotArguments] = []
    rest: list[RobotArguments] = []
    for one in sets.values():
        (rest if one.arguments.items() <= seen else new).append(one)
        seen.update(one.arguments.items())
    return new + rest


def _given(job: Job, names: tuple[str, ...], context: Context) -> list[RobotArguments]:
    if (job.frame and not names) or not has_launch_files(job.path, context.resolver):
        return []
    from urdfkit.ros.launch.robot_arguments import given  # for robots with launch files

    no_arguments = context.reading.document is not None and not _defaults(context)
    return given(job.path, names, context.resolver, only_parameters=no_arguments)


def _with_missing(
    job: Job, read: Callable[[Job], Context], context: Context, names: tuple[str, ...]
) -> list[tuple[Job, Context]]:
    """A job with each set of values that is found for the arguments that it lacks."""
    sets = _launch_sets(job, names, context)
    offered = [{name: one.arguments[name] for name in names} for one in sets]
    found: list[tuple[Job, Context]] = []
    failed: dict[tuple[str, ...], Context] = {}
    for values, now in zip(offered, _started(job, sets[:MAX_GIVEN], names), strict=False):
        pair = (now, read(now))
        if pair[1].reading.missing_arguments:
            failed[tuple(values.values())] = pair[1]
        else:
            found.append(pair)
    if found:
        found[0][1].unchecked = _unchecked(offered, found, failed)
    elif context.reading.missing_arguments:
        return _as_found(job, read, context, names)
    return found


def _needs_more_than_defaults(context: Context) -> bool:
    """True if a description does not expand with the defaults of its arguments."""
    reading = context.reading
    if reading.document is not None or reading.is_fragment:
        return False
    return any(one.code == "XAC001" for one in reading.problems)


def _with_more_than_defaults(
    job: Job, read: Callable[[Job], Context], sets: list[RobotArguments]
) -> list[tuple[Job, Context]]:
    """A job with the sets of arguments of launch files, if it expands with one of them.

    Without a set with which it does not expand, unless a launch file starts it so.
    """
    given = [one for one in sets if one.arguments]
    tried = [(now, read(now)) for now in _started(job, given[:MAX_GIVEN])]
    if all(context.reading.document is None for _, context in tried):
        return []
    found = [
        (now, context)
        for now, context in tried
        if context.reading.document is not None or (now.frame and not now.found)
    ]
    found[0][1].unchecked = _unchecked([one.arguments for one in given[MAX_GIVEN:]], tried, {})
    return found


def _with_other_robots(
    job: Job, read: Callable[[Job], Context], context: Context, sets: list[RobotArguments]
) -> list[tuple[Job, Context]]:
    """A job, and the sets of arguments that make it another robot or come with parameter files."""
    own = {**_defaults(context), **job.arguments} if context.reading.xacro else {}
    base = job._replace(name="", arguments=dict(job.shared or {}))
    others: list[Job] = []
    same: dict[object, Job] = {}  # by parameter files
    for now in _started(base, sets, ()):
        if _changes(now.arguments, own):
            others.append(now)
        elif now.parameters:
            same[tuple(file.path for file in now.parameters)] = now
    found, texts = [(job, context)], [_text(context)] if others else []
    tried = [(now, read(now)) for now in others[:MAX_GIVEN]]
    for now, robot in tried:
        text = _text(robot)
        if text is None or text not in texts:
            found.append((now, robot))
            texts.append(text)
        elif now.parameters:
            found.append((now.about_parameters(), robot))
    found += ((now.about_parameters(), read(now)) for now in same.values())
    left = [_changes(now.arguments, own) for now in others[MAX_GIVEN:]]
    context.unchecked = _unchecked(left, [(job, context), *tried], {})
    return found


def _defaults(context: Context) -> Mapping[str, str]:
    """The arguments that a description declares, with their defaults."""
    return context.reading.xacro.defaults if context.reading.xacro else {}


def _changes(arguments: Mapping[str, str], own: Mapping[str, str]) -> dict[str, str]:
    """The arguments that a description declares and that have another value than its own."""
    return {name: value for name, value in arguments.items() if own.get(name, value) != value}


def _text(context: Context) -> bytes | None:
    """The expanded text; None if there is none."""
    return None if context.reading.document is None else context.text


def _as_found(
    job: Job, read: Callable[[Job], Context], context: Context, names: tuple[str, ...]
) -> list[tuple[Job, Context]]:
    """A job with values that nobody starts it with; empty if it expands with none of them."""
    from urdfkit.lint.argument_values import combinations

    xacro = context.reading.xacro
    assert xacro is not None, "only a xacro lacks arguments"
    found: list[tuple[Job, Context]] = []
    failed: dict[tuple[str, ...], Context] = {}
    more: tuple[str, ...] = ()
    sets = list(combinations(names, xacro, context.resolver))
    offered = [{name: value for name, (value, _) in values.items()} for values in sets]
    for values, given in list(zip(sets, offered, strict=True))[:MAX_GIVEN]:
        arguments, launched = {**given, **job.arguments}, _launched(job, values)
        now = job._replace(arguments=arguments, launched=launched, assumed=_named(given))
        pair = (now, read(now))
        if pair[1].reading.document is not None:
            found.append(pair)
        else:
            failed[tuple(given.values())] = pair[1]
        more += pair[1].reading.missing_arguments
    if found:
        found[0][1].unchecked = _unchecked(offered, found, failed)
    if len(found) == 1:  # there is nothing to choose from
        return [(found[0][0]._replace(assumed=""), found[0][1])]
    if found or set(more) <= set(names):
        return found
    return _as_found(job, read, context, tuple(dict.fromkeys((*names, *more))))


def _unchecked(
    offered: list[dict[str, str]],
    checked: Iterable[tuple[Job, Context]],
    failed: Mapping[tuple[str, ...], Context],
) -> tuple[UncheckedValues, ...]:
    """The values of arguments with which no description is checked.

    Args:
        failed: descriptions that do not expand, by their values in the order of the names.
    """
    known = {item for job, _ in checked for item in job.arguments.items()}
    left: dict[tuple[str, str], dict[str, None]] = {}
    for values in offered:
        context = failed.get(tuple(values.values()))
        why = f"only {MAX_GIVEN} sets of arguments are tried"
        if context is not None:
            from urdfkit.lint.unchecked import why_unchecked

            why, _ = why_unchecked(context.reading, context.source, context.resolver)
        for name, value in values.items():
            if (name, value) not in known:
                left.setdefault((name, why), {})[value] = None
    totals = Counter(name for name, _ in {*known, *(i for one in offered for i in one.items())})
    return tuple(
        UncheckedValues(name, tuple(values), totals[name], why)
        for (name, why), values in left.items()
    )


def _started(
    job: Job, sets: Iterable[RobotArguments], names: Iterable[str] | None = None
) -> Iterator[Job]:
    """A job with each of some sets of arguments that launch files give.

    Args:
        names: of the arguments whose origin the report gives; of all if None.
    """
    known: list[dict[str, str]] = []
    for one in sets:
        reported = one.arguments if names is None else names
        now = job._replace(
            frame=one.frame,
            arguments={**one.arguments, **job.arguments},
            parameters=one.parameters,
            started=(),
            launched=_launched(job, {name: (one.arguments[name], one.launch) for name in reported}),
            found=job.found if one.frame is None else not one.is_whole,
            assumed="" if one.frame else _named(one.arguments),
        )
        yield now.about_parameters() if now.arguments in known else now
        known.append(now.arguments)


def _launched(job: Job, values: Mapping[str, tuple[str, str]]) -> tuple[Launched, ...]:
    """The values of arguments with where they are from, each place once."""
    origins: dict[str, dict[str, str]] = {}
    for name, (value, origin) in values.items():
        origins.setdefault(origin, {})[name] = value
    return tuple(Launched(job.path, *one) for one in origins.items())


def _named(arguments: Mapping[str, str]) -> str:
    return ", ".join(f"{name}={value}" for name, value in arguments.items())


def unknown_arguments(context: Context, given: Iterable[str]) -> dict[str, str]:
    """The given arguments that a description never mentions, each with the suggested one.

    xacro takes any, so that a typo has no effect and is not reported. A launch file may pass them
    on, and of what cannot be read not all is known: neither has any.
    """
    names = tuple(given)
    if not names or context.reading.document is None:
        return {}
    xacro = context.reading.xacro
    declared = set(xacro.defaults) if xacro else set()
    mentioned = declared | (xacro.usage.names if xacro else frozenset())
    return {name: nearest(name, declared) or "" for name in names if name not in mentioned}
