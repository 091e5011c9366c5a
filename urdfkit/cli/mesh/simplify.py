"""``urdfkit mesh simplify``: fewer triangles."""

from collections.abc import Iterator

from urdfkit.cli import options, output
from urdfkit.cli.decorators import described, limited, option
from urdfkit.cli.mesh import tables
from urdfkit.cli.mesh.saving import save, writes
from urdfkit.cli.progress import progress_bar
from urdfkit.mesh.io.load import load
from urdfkit.mesh.simplify import Simplified, to_budget, to_error
from urdfkit.mesh.transforms import in_metres


@described("simplify")
@option("--triangles N", "Maximum number of triangles.", type=int)
@option("--error METRES", "Maximum deviation of the surface.", type=float)
@writes
@limited
def command(file: str, path: str | None, triangles: int | None, error: float | None) -> int:
    """Reduce the triangles of a mesh, to a budget or within an error.

    The deviation is measured in both directions. Materials are kept; texture coordinates and
    vertex colours are not.

    Exit codes: 0 done, 2 usage or input error.

    Examples:
        urdfkit mesh simplify arm.dae --triangles 2000 -o arm.stl
        urdfkit mesh simplify arm.dae --error 0.001 --write
    """
    if (triangles is None) == (error is None):
        raise options.UsageError("pass either --triangles or --error")
    if (triangles is not None and triangles < 4) or (error is not None and not error > 0):
        raise options.UsageError("--triangles must be 4 or more, --error more than 0")
    mesh = in_metres(load(file))
    with progress_bar() as bar:
        if triangles is not None:
            simplified = to_budget(mesh, triangles, bar)
        else:
            assert error is not None
            simplified = to_error(mesh, error, bar)
    output.page([*render(simplified), *save(simplified.mesh, path)])
    return 0


def render(simplified: Simplified) -> Iterator[str]:
    """The mesh before and after, and the deviation of the surface."""
    yield from tables.columns(tables.before_and_after(simplified.before, simplified.after))
    share = 100 * simplified.deviation / simplified.diagonal
    yield from tables.distances(simplified.lost, simplified.gained)
    yield f"the larger is {share:.2g} % of the diagonal"
