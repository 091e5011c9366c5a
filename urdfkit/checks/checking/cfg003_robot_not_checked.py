"""A robot was found and could not be checked.

The robot requires arguments for which no file has values, or it cannot be read for a reason that
this check is configured to ignore. The robot was not checked, and a report without findings would
hide that. Single values of an argument are reported, too: values beyond the first 16, and names of
directories with which the robot does not expand. So this rule runs with any `--select`; `--ignore
CFG003`, an ignore comment above the root element and `per-file-ignores` accept robots that are not
checked. A directory that has launch files or macros, but no robot, is reported in the same way, and
so is a robot that cannot be simulated, with `--simulate`.

Values for arguments are read from the launch files of the package and of the workspace, from the
choices and defaults that launch files declare under the same name, from defaults in the files
that the robot includes, and from the names of directories that a path with the argument refers to,
as in `config/$(arg ur_type)/limits.yaml`. If there are none, write them in `urdfkit.toml`:

    [[robot]]
    file = "urdf/arm.urdf.xacro"
    arguments.prefix = "left_"
"""

from urdfkit.errors import Unavailable
from urdfkit.lint.rules import Context, Finding, Findings, Related, Severity, rule
from urdfkit.robot.samples import xacro_xml
from urdfkit.text.source import Span

_ROBOT = xacro_xml('<link name="$(arg prefix)base"/>')
BAD = f"<!-- urdfkit: ignore[XAC010] its launch file gives the prefix -->\n{_ROBOT}"
GOOD = xacro_xml('<xacro:arg name="prefix" default=""/>', '<link name="$(arg prefix)base"/>')


@rule(Severity.WARNING, needs=())
def check(context: Context) -> Findings:
    for argument in context.unchecked:
        yield Finding(
            _top(context),
            f"robot not checked with {len(argument.values)} of {argument.total} values of "
            f"'{argument.name}': {', '.join(argument.values)}; {argument.why}",
            "list the robot's variants in urdfkit.toml, under [[robot]]",
            group_key=argument.name,
        )
    if context.is_readable:
        yield from _not_simulated(context)
    # A part of a robot is checked with the file that includes it, which XAC001 reports.
    if context.reading.document is not None or context.reading.is_fragment:
        return
    from urdfkit.lint.unchecked import why_unchecked

    why, help = why_unchecked(context.reading, context.source, context.resolver)
    what = "robot not checked" if context.part is None else "only a part of the robot checked"
    yield Finding(
        _top(context),
        f"{what}: {why}",
        help,
        related=tuple(
            Related(problem.span, f"argument '{problem.argument}'")
            for problem in context.reading.missing_argument_problems
        ),
    )


def _not_simulated(context: Context) -> Findings:
    try:
        _ = context.simulation
    except Unavailable as error:
        help = "correct what is named, or check without --simulate"
        yield Finding(_top(context), f"robot {error}", help)


def _top(context: Context) -> Span:
    start = context.source.data.find(b"<robot")
    return Span(context.source, *((start, start + len("<robot")) if start >= 0 else (0, 0)))
