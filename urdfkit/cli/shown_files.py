"""``urdfkit check --show-files``: the robots that would be checked, and the skipped files."""

from collections.abc import Sequence

from urdfkit.core import disk
from urdfkit.lint.argument_sets import as_checked
from urdfkit.lint.check_job import reader
from urdfkit.lint.merging import unread_srdfs
from urdfkit.lint.options import Options
from urdfkit.lint.plan import planned
from urdfkit.lint.unchecked import unread_files
from urdfkit.text.source import shown
from urdfkit.text.terminal import printable
from urdfkit.workspace.resolve import Resolver


def shown_files(files: Sequence[str], settings: Options) -> str:
    """The descriptions that would be checked, with their arguments, and the skipped files."""
    settings = settings.with_config()
    resolver = Resolver(settings.packages)
    plan, read = planned(files, resolver, settings), reader(settings, resolver)
    sets = [pair for job in plan.jobs for pair in as_checked(job, read)]
    lines = [
        " ".join((shown(job.path), *(f"{name}:={value}" for name, value in job.arguments.items())))
        for job, _ in sets
    ]
    robots = [robot for _, robot in sets if plan.srdfs and robot.reading.document]
    read_srdfs = {disk.real(robot.srdf.path) for robot in robots if robot.srdf}
    skipped = (*plan.skipped, *unread_srdfs(plan.srdfs, read_srdfs))
    lines += [f"not checked: {shown(skip.path)}: {skip.reason}" for skip in skipped]
    lines += [
        f"not checked: {shown(path)}: included, but not with these arguments"
        for path in unread_files(context for _, context in sets)
    ]
    return "".join(f"{printable(line)}\n" for line in dict.fromkeys(lines))
