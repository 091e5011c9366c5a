"""The sets of arguments that a description is checked with."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping

from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.lint.plan import Job
from urdfkit.lint.report import Launched, UncheckedValues
from urdfkit.lint.switched_arguments import is_wrong_call, switched, switched_launches
from urdfkit.text.file_kinds import is_launch
from urdfkit.workspace.launch_files import has_launch_files

if TYPE_CHECKING:
    from collections.abc import Callable

    from urdfkit.lint.context import Context
    from urdfkit.ros.launch.robot_arguments import RobotArguments

#: Most additional sets of arguments that a robot is checked with; the UR arms have nine.
MAX_SETS = 16


def as_checked(job: Job, read: Callable[[Job], Context]) -> list[tuple[Job, Context]]:
    """A job with its description, for each set of arguments that it is checked with.

    These are the sets with which it is started, and those with another value in a condition.
    """
    if is_launch(job.path):
        return [(job, read(job)), *((other, read(other)) for other in switched_launches(job))]
    started = as_launched(job, read)
    return started if job.overriding is None else [*started, *_with_switched(job, started, read)]


def as_launched(job: Job, read: Callable[[Job], Context]) -> list[tuple[Job, Context]]:
    """A job with its description, for each set of arguments with which the robot is started.

    - A robot with missing arguments, or arguments used before their default: the sets of launch
      files. If none sets all of them and the robot does not expand: values found in other files
      with which it expands.
    - A robot that does not expand with its defaults: the sets of launch files.
    - Any other robot: its defaults, and the sets of launch files that result in another robot.
    """
    context = read(job)
    if names := context.reading.arguments_to_pass:
        return _with_missing(job, read, context, names) or [(job, context)]
    if job.overriding is None:
        return [(job, context)]
    sets = _launch_sets(job, (), context)
    job = job._replace(launch_sets=())  # not needed by the report, and sent to another process
    if _needs_more_than_defaults(context):
        return _with_more_than_defaults(job, read, sets) or [(job, context)]
    return _with_other_robots(job, read, context, sets) if sets else [(job, context)]


def _with_switched(
    job: Job, started: list[tuple[Job, Context]], read: Callable[[Job], Context]
) -> Iterator[tuple[Job, Context]]:
    """A robot with each other value of its arguments that adds something to it.

    Not if it does not expand then, since the values may not be meant for each other, unless it
    calls a macro with other parameters than it has; nor without a link or joint that controllers
    and SRDFs may name.
    """
    jobs = list(switched(job, started))
    if not jobs:
        return  # most robots: what follows writes the whole text
    known = {_known_content(robot) for _, robot in started}
    own = _links_and_joints(started[0][1])
    others: list[tuple[Job, Context]] = []
    failed: list[tuple[Job, Context]] = []
    for variant in jobs if None not in known else ():
        robot = read(variant)
        content = _known_content(robot)
        if content is None:
            failed += [(variant, robot)] * any(map(is_wrong_call, robot.reading.problems))
        elif content not in known and own <= _links_and_joints(robot):
            known.add(content)
            others.append((variant, robot))
    if not others and not failed:
        return
    present = _tags(robot for _, robot in started)
    yield from ((variant._replace(present=present), robot) for variant, robot in failed)
    extending = [variant for variant, robot in others if own < _links_and_joints(robot)]
    is_part = not all(
        robot.reading.xacro.has_all_links for _, robot in started if robot.reading.xacro
    )
    for variant, robot in others:
        needs_others = is_part or any(other != variant for other in extending)
        yield variant._replace(present=present, needs_others=needs_others), robot


def _tags(robots: Iterable[Context]) -> dict[str, list[tuple[int, int]]]:
    """The places of the tags of descriptions, in order, by the path of their file."""
    tags: dict[str, set[tuple[int, int]]] = {}
    for document in filter(None, (robot.reading.known for robot in robots)):
        for element in document.root.walk():
            span = element.span
            tags.setdefault(span.source.path, set()).add((span.start, span.end))
    return {path: sorted(places) for path, places in tags.items()}


def _with_missing(
    job: Job, read: Callable[[Job], Context], context: Context, names: tuple[str, ...]
) -> list[tuple[Job, Context]]:
    """A job with each set of values for its missing arguments."""
    sets = _launch_sets(job, names, context)
    candidates = [{name: robot.arguments[name] for name in names} for robot in sets]
    complete: list[tuple[Job, Context]] = []
    unsure: list[tuple[Job, Context]] = []
    failed: dict[tuple[str, ...], Context] = {}
    for values, variant in zip(candidates, _variants(job, sets[:MAX_SETS], names), strict=False):
        robot = read(variant)
        is_unsure = _is_unsure(variant, robot)
        if is_unsure:
            unsure.append((variant, robot))
        if is_unsure or robot.reading.missing_arguments:
            failed[tuple(values.values())] = robot
        else:
            complete.append((variant, robot))
    complete = complete or unsure
    if complete:
        _, first = complete[0]
        first.unchecked = _unchecked_values(candidates, complete, failed)
    elif context.reading.missing_arguments:
        return _with_found_values(job, read, context, names)
    return complete


def _with_found_values(
    job: Job, read: Callable[[Job], Context], context: Context, names: tuple[str, ...]
) -> list[tuple[Job, Context]]:
    """A job with values found in other files; empty if it expands with none of them."""
    from urdfkit.lint.argument_values import combinations

    xacro = context.reading.xacro
    assert xacro is not None, "only a xacro lacks arguments"
    expanded: list[tuple[Job, Context]] = []
    failed: dict[tuple[str, ...], Context] = {}
    missing: tuple[str, ...] = ()
    sets = list(combinations(names, xacro, context.resolver))
    candidates = [{name: value for name, (value, _) in values.items()} for values in sets]
    for values, assumed in list(zip(sets, candidates, strict=True))[:MAX_SETS]:
        arguments, launched = {**assumed, **job.arguments}, _by_origin(job, values)
        variant = job._replace(arguments=arguments, launched=launched, assumed=_as_text(assumed))
        robot = read(variant)
        if robot.reading.document is not None:
            expanded.append((variant, robot))
        else:
            failed[tuple(assumed.values())] = robot
        missing += robot.reading.missing_arguments
    if expanded:
        variant, robot = expanded[0]
        robot.unchecked = _unchecked_values(candidates, expanded, failed)
        is_only_choice = len(expanded) == 1
        return [(variant._replace(assumed=""), robot)] if is_only_choice else expanded
    if set(missing) <= set(names):
        return []
    return _with_found_values(job, read, context, tuple(dict.fromkeys((*names, *missing))))


def _needs_more_than_defaults(context: Context) -> bool:
    """True if a description does not expand with the defaults of its arguments."""
    reading = context.reading
    if reading.document is not None or reading.is_fragment:
        return False
    return any(problem.code == "XAC001" for problem in reading.problems)


def _with_more_than_defaults(
    job: Job, read: Callable[[Job], Context], sets: list[RobotArguments]
) -> list[tuple[Job, Context]]:
    """A job with the sets of arguments of launch files; empty if it expands with none of them.

    Excludes sets with which it does not expand, unless the launch file itself is checked.
    """
    with_arguments = [robot for robot in sets if robot.arguments]
    tried = [(variant, read(variant)) for variant in _variants(job, with_arguments[:MAX_SETS])]
    if all(robot.reading.document is None for _, robot in tried):
        return []
    checked = [
        (variant, robot)
        for variant, robot in tried
        if robot.reading.document is not None or (variant.frame and not variant.may_fail)
    ]
    _, first = checked[0]
    untried = [robot.arguments for robot in with_arguments[MAX_SETS:]]
    first.unchecked = _unchecked_values(untried, tried, {})
    return checked


def _with_other_robots(
    job: Job, read: Callable[[Job], Context], context: Context, sets: list[RobotArguments]
) -> list[tuple[Job, Context]]:
    """A job, also with the sets of arguments that result in another robot or parameter files."""
    own = {**context.reading.defaults, **job.arguments} if context.reading.xacro else {}
    base = job._replace(name="", arguments=dict(job.overriding or {}))
    others: list[Job] = []
    with_defaults: dict[object, Job] = {}  # by parameter files
    for variant in _variants(base, sets, ()):
        if _changes(variant.arguments, own):
            others.append(variant)
        elif variant.parameters:
            with_defaults[tuple(file.path for file in variant.parameters)] = variant
    tried = [(variant, read(variant)) for variant in others[:MAX_SETS]]
    untried = [_changes(variant.arguments, own) for variant in others[MAX_SETS:]]
    context.unchecked = _unchecked_values(untried, [(job, context), *tried], {})
    default_text = _expanded_text(context) if tried else None
    texts = [_expanded_text(robot) for _, robot in tried]  # None without packages, too
    if all(text is None or text != default_text for text in texts):
        replaced = _replaced(sets, own) - job.arguments.keys()
        job = job._replace(replaced=frozenset(replaced))
    return [
        (job, context),
        *_different(tried, default_text),
        *((variant.about_parameters(), read(variant)) for variant in with_defaults.values()),
    ]


def _different(
    tried: Iterable[tuple[Job, Context]], default_text: bytes | None
) -> Iterator[tuple[Job, Context]]:
    """Those that are another robot, and those that have parameter files of their own."""
    texts = {default_text}
    for variant, robot in tried:
        if _is_unsure(variant, robot):
            continue
        text = _expanded_text(robot)
        if text is None or text not in texts:
            texts.add(text)
            yield variant, robot
        elif variant.parameters:
            yield variant.about_parameters(), robot


def _replaced(sets: Iterable[RobotArguments], own: Mapping[str, str]) -> set[str]:
    """The arguments to which each launch file that starts a robot passes another value."""
    changed = [
        set(own) if "" in robot.unknown else {*_changes(robot.arguments, own), *robot.unknown}
        for robot in sets
        if robot.frame
    ]
    return set.intersection(*changed) if changed else set()


def _links_and_joints(context: Context) -> set[tuple[str, str | None]]:
    document = context.reading.known
    elements = document.root.children if document else ()
    return {(e.tag, e.get("name")) for e in elements if e.tag in ("link", "joint")}


def _changes(arguments: Mapping[str, str], own: Mapping[str, str]) -> dict[str, str]:
    """The arguments whose value differs from the description's own."""
    return {name: value for name, value in arguments.items() if own.get(name, value) != value}


def _is_unsure(variant: Job, context: Context) -> bool:
    """True if a robot may only expand with the values that are known only at run time."""
    return context.reading.document is None and variant.frame is not None and variant.may_fail


def _expanded_text(context: Context) -> bytes | None:
    """The expanded text; None if the description cannot be read."""
    return None if context.reading.document is None else context.text


def _known_content(context: Context) -> object:
    """What two equal descriptions have in common, without packages that are not found."""
    text, document = _expanded_text(context), context.reading.known
    if text is not None or document is None:
        return text
    return tuple(
        (element.tag, element.text, *((a.name, a.value) for a in element.attributes.values()))
        for element in document.root.walk()
    )


def _launch_sets(job: Job, names: tuple[str, ...], context: Context) -> list[RobotArguments]:
    """The distinct sets of arguments in launch files; sets with new values are first.

    Args:
        names: names of the missing arguments; sets without all of them are omitted.
    """
    sets: dict[object, RobotArguments] = {}
    for robot in (*_passed(job, names, context), *job.launch_sets):
        if robot.arguments.keys() >= set(names):
            files = (file.path for file in robot.parameters)
            key = (frozenset(robot.arguments.items()), *files)
            if key not in sets or (robot.is_whole and not sets[key].is_whole):
                sets[key] = robot
    known: set[tuple[str, str]] = set()
    new: list[RobotArguments] = []
    rest: list[RobotArguments] = []
    for robot in sets.values():
        (rest if robot.arguments.items() <= known else new).append(robot)
        known.update(robot.arguments.items())
    return new + rest


def _passed(job: Job, names: tuple[str, ...], context: Context) -> list[RobotArguments]:
    if (job.frame and not names) or not has_launch_files(job.path, context.resolver):
        return []
    from urdfkit.ros.launch.robot_arguments import passed_arguments  # for robots with launch files

    reading = context.reading
    return passed_arguments(
        job.path,
        names,
        context.resolver,
        only_parameters=reading.document is not None and not reading.defaults,
        wanted=reading.early_arguments,
    )


def _variants(
    job: Job, sets: Iterable[RobotArguments], names: Iterable[str] | None = None
) -> Iterator[Job]:
    """A job with each of the sets of arguments of launch files.

    Args:
        names: names of the arguments whose origin is reported; all if None.
    """
    known: list[dict[str, str]] = []
    for robot in sets:
        reported = robot.arguments if names is None else names
        origins = {name: (robot.arguments[name], robot.launch) for name in reported}
        variant = job._replace(
            frame=robot.frame,
            arguments={**robot.arguments, **job.arguments},
            parameters=robot.parameters,
            launch_sets=(),
            launched=_by_origin(job, origins),
            may_fail=job.may_fail if robot.frame is None else not robot.is_whole,
            assumed="" if robot.frame else _as_text(robot.arguments),
            unknown=robot.unknown,
        )
        yield variant.about_parameters() if variant.arguments in known else variant
        known.append(variant.arguments)


def _by_origin(job: Job, values: Mapping[str, tuple[str, str]]) -> tuple[Launched, ...]:
    """The values of arguments, grouped by origin."""
    origins: dict[str, dict[str, str]] = {}
    for name, (value, origin) in values.items():
        origins.setdefault(origin, {})[name] = value
    return tuple(Launched(job.path, *item) for item in origins.items())


def _as_text(arguments: Mapping[str, str]) -> str:
    return ", ".join(f"{name}={value}" for name, value in arguments.items())


def _unchecked_values(
    candidates: list[dict[str, str]],
    checked: Iterable[tuple[Job, Context]],
    failed: Mapping[tuple[str, ...], Context],
) -> tuple[UncheckedValues, ...]:
    """The values of arguments that no description is checked with.

    Args:
        failed: descriptions that do not expand, by their values in the order of the names.
    """
    known = {item for job, _ in checked for item in job.arguments.items()}
    left: dict[tuple[str, str], dict[str, None]] = {}
    for values in candidates:
        context = failed.get(tuple(values.values()))
        why = f"only {MAX_SETS} sets of arguments are tried"
        if context is not None:
            from urdfkit.lint.unchecked import why_unchecked

            why, _ = why_unchecked(context.reading, context.source, context.resolver)
        for name, value in values.items():
            if (name, value) not in known:
                left.setdefault((name, why), {})[value] = None
    pairs = {*known, *(pair for values in candidates for pair in values.items())}
    totals = Counter(name for name, _ in pairs)
    return tuple(
        UncheckedValues(name, tuple(unchecked), totals[name], why)
        for (name, why), unchecked in left.items()
    )
