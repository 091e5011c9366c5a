"""``urdfkit mesh repair``: a mesh made the surface of a solid."""

from collections.abc import Iterator

from urdfkit.cli import output
from urdfkit.cli.decorators import described, limited, option
from urdfkit.cli.mesh import tables
from urdfkit.cli.mesh.saving import save, writes
from urdfkit.cli.progress import progress_bar
from urdfkit.mesh.health import Health
from urdfkit.mesh.io.salvage import load_or_salvage
from urdfkit.mesh.measures import OVERLAP
from urdfkit.mesh.repair import Repair, RepairStep, repair
from urdfkit.mesh.transforms import in_metres


@described("repair")
@writes
@option("--keep-holes", "Do not fill holes.")
@option("--one-sided", "Remove one side of double-sided sheets.")
@option("--union", "Boolean union of bodies that overlap or are nested.")
@limited
def command(file: str, path: str | None, keep_holes: bool, one_sided: bool, union: bool) -> int:
    """Repair a mesh: weld, clean, orient, fill holes.

    Prints what was wrong, what was done, and how far the surface has moved. A mesh that is a
    closed solid is not changed; a repair that makes it no better is discarded. From a broken file,
    the readable part is used.

    Exit codes: 0 nothing to repair, or repaired and written; 1 there is something to repair, or
    it could not be repaired fully; 2 usage or input error.

    Examples:
        urdfkit mesh repair arm.stl
        urdfkit mesh repair arm.stl --write
    """
    mesh, defect = load_or_salvage(file)
    with progress_bar() as bar:
        done = repair(
            in_metres(mesh), holes=not keep_holes, one_sided=one_sided, union=union, progress=bar
        )
    lines = [*render(done, defect)]
    if done.changed or defect or (path and path != file):
        lines += save(done.mesh, path)
    output.page(lines)
    if not done.changed and not defect:
        return int(not done.after.is_solid)
    return int(path is None or not done.after.is_solid)


def render(done: Repair, defect: str) -> Iterator[str]:
    """The defects, the repairs, and the state before and after."""
    if defect:
        yield from output.indented(f"the file {defect}", first="")
    if not done.steps:
        if done.before.is_solid:
            yield "nothing to repair: the triangles are the surface of a solid"
        else:
            yield from output.indented(f"not repaired: {tables.surface(done.before)}", first="")
        yield from _asked(done.before)
        return
    yield from output.indented(f"found {tables.surface(done.before)}", first="")
    for step in done.steps:
        yield f"  {_step(step)}"
    if done.discarded:
        yield f"repair discarded: {done.discarded}; the mesh is unchanged"
        return
    yield from tables.columns(tables.before_and_after(done.before, done.after))
    yield from tables.distances(done.lost, done.gained)
    if not done.after.is_solid:
        yield from output.indented(f"left: {tables.surface(done.after)}", first="")
    yield from _asked(done.after)


def _asked(health: Health) -> Iterator[str]:
    """The options that repair the remaining defects."""
    if health.doubled:
        yield "--one-sided removes one side of the sheets"
    if health.overlap > OVERLAP:
        yield "--union unites the bodies"


def _step(step: RepairStep) -> str:
    changes = [
        f"{number} triangles {words}"
        for number, words in (
            (step.removed, "fewer"),
            (step.added, "more"),
            (step.turned, "turned"),
        )
        if number
    ]
    return step.name + (f": {', '.join(changes)}" if changes else "")
