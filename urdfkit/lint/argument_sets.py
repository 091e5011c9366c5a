"""Descriptions that lack arguments, with each set of values that is found for them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from urdfkit.core.suggest import nearest
from urdfkit.lint.plan import Job
from urdfkit.lint.report import Launched, UncheckedValues

if TYPE_CHECKING:
    from collections.abc import Callable

    from urdfkit.lint.context import Context
    from urdfkit.ros.launch.robot_arguments import RobotArguments


#: Sets of values with which a robot is checked that lacks arguments; the UR arms have nine.
MAX_GIVEN = 16


def as_launched(job: Job, read: Callable[[Job], Context]) -> list[tuple[Job, Context]]:
    """A job with its description.

    A robot that cannot be expanded for want of arguments, or that uses them above their default,
    comes with those that launch files give it: once for each set of them. Where none gives them
    all, one that cannot be expanded comes with the values that are found otherwise and with which
    it expands. One that its defaults do not suffice for comes as launch files start it.
    """
    context = read(job)
    if not (names := context.reading.arguments_to_pass):
        return _as_started(job, read, context) or [(job, context)]
    from urdfkit.ros.launch.robot_arguments import given

    found, failed = [], {}
    sets = given(job.path, names, context.resolver)
    for one in sets[:MAX_GIVEN]:
        now = _started(job, one, names)
        if one.frame is None:
            now = now._replace(assumed=_named(one.arguments))
        pair = (now, read(now))
        if pair[1].reading.missing_arguments:
            failed[tuple(one.arguments[name] for name in names)] = pair[1]
        else:
            found.append(pair)
    if found:
        offered = [{name: one.arguments[name] for name in names} for one in sets]
        _note_unchecked(found, offered, failed)
        return found
    if not context.reading.missing_arguments:
        return [(job, context)]
    return _as_found(job, read, context, names) or [(job, context)]


def _as_started(
    job: Job, read: Callable[[Job], Context], context: Context
) -> list[tuple[Job, Context]]:
    """A job whose defaults do not expand, with what launch files start it with; else nothing."""
    if all(one.code != "XAC001" for one in context.reading.problems):
        return []
    if context.reading.document is not None or context.reading.is_fragment:
        return []
    from urdfkit.ros.launch.robot_arguments import given

    found = []
    for one in given(job.path, (), context.resolver)[:MAX_GIVEN]:
        if one.frame is not None and one.arguments:
            now = _started(job, one, one.arguments)
            found.append((now, read(now)))
    return [pair for pair in found if pair[1].reading.document is not None]


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
        _note_unchecked(found, offered, failed)
    if len(found) == 1:  # there is nothing to choose from
        return [(found[0][0]._replace(assumed=""), found[0][1])]
    if found or set(more) <= set(names):
        return found
    return _as_found(job, read, context, tuple(dict.fromkeys((*names, *more))))


def _note_unchecked(
    found: list[tuple[Job, Context]],
    offered: list[dict[str, str]],
    failed: Mapping[tuple[str, ...], Context],
) -> None:
    """Leave with the first description which values of its arguments none is checked with.

    Args:
        failed: descriptions that do not expand, by their values in the order of the names.
    """
    from urdfkit.lint.unchecked import why_unchecked

    left: dict[tuple[str, str], list[str]] = {}
    for values in offered:
        context = failed.get(tuple(values.values()))
        why = f"only {MAX_GIVEN} sets of arguments are tried"
        if context is not None:
            why, _ = why_unchecked(context.reading, context.source, context.resolver)
        for name, value in values.items():
            known = left.setdefault((name, why), [])
            if all(job.arguments.get(name) != value for job, _ in found) and value not in known:
                known.append(value)
    found[0][1].unchecked = tuple(
        UncheckedValues(name, tuple(values), len({one[name] for one in offered}), why)
        for (name, why), values in left.items()
        if values
    )


def _started(job: Job, given: RobotArguments, names: Iterable[str]) -> Job:
    """A job with the arguments that a launch file gives; it is named as the origin of some."""
    launched = _launched(job, {name: (given.arguments[name], given.launch) for name in names})
    arguments = {**given.arguments, **job.arguments}
    return job._replace(frame=given.frame, launched=launched, arguments=arguments)


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
