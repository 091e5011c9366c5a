"""``urdfkit mesh repair``: repairs a mesh so that it is the surface of a solid."""

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

    Prints the defects, the repairs, and the deviation of the surface. A mesh that is a closed solid
    is not changed; a repair without improvement is discarded. Of a broken file, the readable part
    is used.

    Exit codes: 0 nothing to repair, or repaired and written; 1 a repair is needed, or the mesh
    could not be repaired fully; 2 usage or input error.

    Examples:
        urdfkit mesh repair arm.stl
        urdfkit mesh repair arm.stl --write
    """
    mesh, defect = load_or_salvage(file)
    with progress_bar() as bar:
        repaired = repair(
            in_metres(mesh), holes=not keep_holes, one_sided=one_sided, union=union, progress=bar
        )
    lines = [*render(repaired, defect)]
    if repaired.changed or defect or (path and path != file):
        lines += save(repaired.mesh, path)
    output.page(lines)
    if not repaired.changed and not defect:
        return int(not repaired.after.is_solid)
    return int(path is None or not repaired.after.is_solid)


def render(repaired: Repair, defect: str) -> Iterator[str]:
    """The defects, the repairs, and the state before and after."""
    if defect:
        yield from output.indented(f"the file {defect}", first="")
    if not repaired.steps:
        if repaired.before.is_solid:
            yield "nothing to repair: the triangles are the surface of a solid"
        else:
            yield from output.indented(f"not repaired: {tables.surface(repaired.before)}", first="")
        yield from _repair_options(repaired.before)
        return
    yield from output.indented(f"found {tables.surface(repaired.before)}", first="")
    for step in repaired.steps:
        yield f"  {_step(step)}"
    if repaired.discarded:
        yield f"repair discarded: {repaired.discarded}; the mesh is unchanged"
        return
    yield from tables.columns(tables.before_and_after(repaired.before, repaired.after))
    yield from tables.distances(repaired.lost, repaired.gained)
    if not repaired.after.is_solid:
        yield from output.indented(f"left: {tables.surface(repaired.after)}", first="")
    yield from _repair_options(repaired.after)


def _repair_options(health: Health) -> Iterator[str]:
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
